/* Linked with the reader's copy of a stage: it becomes `--stage mine` of the program.
 * EXERCISE_STAGE is the digit of the stage that it was copied from, whose promises are its own. */
#include "tests/program/stages.h"

draw_triangle mine_draw_triangle;

__attribute__((constructor)) static void add_mine(void)
{
    stage_add_mine(EXERCISE_STAGE, mine_draw_triangle);
}
