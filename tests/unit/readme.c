/* The group `readme`: what the READMEs say is what the program gives. */
#include <stdlib.h>
#include <string.h>
#include "tests/unit/check.h"
#include "tests/lessons/readme.h"
#include "tests/unit/test.h"

#define COMMAND_LENGTH 512

static void test_committed(const char *path, bool is_lesson)
{
    struct error error = {""};
    char *text = readme_read(path, &error);

    if (!check(text, "a README can be read", "%s", error.text)) {
        return;
    }
    char *renewed = readme_renew(path, text, &error);
    if (check(renewed, "a README's blocks can be written", "%s", error.text)) {
        check(strcmp(text, renewed) == 0, "a README's blocks are what the program gives",
              "%s: see `make readme`, and git diff", path);
    }
    check(readme_prose_holds(path, text, &error), "measured numbers stand in blocks alone", "%s",
          error.text);
    check(readme_links_hold(path, text, &error), "a README's links lead somewhere", "%s",
          error.text);
    check(!is_lesson || readme_lesson_holds(path, text, &error), "a lesson has its eleven parts",
          "%s", error.text);
    free(renewed);
    free(text);
}

static void test_pictures(void)
{
    const char *program = getenv("TEXMAP_PROGRAM");
    char command[COMMAND_LENGTH];

    snprintf(command, sizeof command, "sh tests/lessons/pictures.sh '%s' --check",
             program ? program : "build/texmap");
    fflush(stdout);
    check(system(command) == 0, "the lessons' pictures are what texmap draws", "%s", command);
}

/* The judges of the text must be able to say no. */
static void test_prose(void)
{
    static const struct {
        const char *text;
        bool holds;
    } cases[] = {
        {"It takes 3 ns a pixel.\n", false},     {"2.5x as fast\n", false},
        {"wrong by 12 %\n", false},              {"off by 0.1 texel,\n", false},
        {"up to 4 times\n", false},              {"a 3-texel error\n", false},
        {"`3 ns`, 256x192, 16 pixels\n", true},  {"16 texelsome, stage 5 and 28.4\n", true},
        {"a\n\n    3 ns\n\nb\n", true},        {"    3 ns\n5 ns\n", false},
        {"```\n3 ns\n```\nand 2 %\n", false},    {"```\n3 ns\n```\n", true},
        {"<!-- begin run a -->\n3 ns\n<!-- end run -->\n5 ns\n", false},
        {"<!-- begin run a -->\n3 ns\n<!-- end run -->\n[5](6 ns) 7\n", true},
    };

    for (size_t i = 0; i < sizeof cases / sizeof cases[0]; i++) {
        struct error error;
        check(readme_prose_holds("text", cases[i].text, &error) == cases[i].holds,
              "a measured number in the text is seen", "case %zu", i);
    }
}

static void test_renew(void)
{
    static const char *const bad[] = {
        "<!-- begin results -->\n", "<!-- begin nothing -->\n<!-- end nothing -->\n",
        "<!-- end results -->\n", "<!-- begin run ls -->\n<!-- end run -->\n",
        ("<!-- begin results -->\n<!-- begin diff a b -->\n<!-- end diff -->\n"
         "<!-- end results -->\n"),
    };
    struct error error;

    for (size_t i = 0; i < sizeof bad / sizeof bad[0]; i++) {
        char *renewed = readme_renew("text", bad[i], &error);
        check(!renewed, "a block that cannot be written is an error", "case %zu", i);
        free(renewed);
    }
    char *renewed = readme_renew("text", "a\n<!-- begin run texmap help scene -->\nold\n"
                                         "<!-- end run -->\nb\n", &error);
    check(renewed && strstr(renewed, "$ build/texmap help scene\n") && !strstr(renewed, "old\n") &&
              strstr(renewed, "```\n<!-- end run -->\nb\n"),
          "a block is replaced, and nothing around it", "got %s", renewed ? renewed : error.text);
    free(renewed);
}

static void test_line_count(void)
{
    int removed = -1, added = -1;

    check(readme_count_lines("a\nb\nc\nd\n", "a\nc\nx\ny\nd\n", &removed, &added) &&
              removed == 1 && added == 2,
          "as few lines as can be are removed and added", "%d out, %d in; expected 1 and 2",
          removed, added);
}

/* One line, exit status 2. */
static void test_usage(void)
{
    static const char *const commands[] = {
        "sh tests/lessons/lesson.sh build 1", "sh tests/lessons/lesson.sh build 6", "sh tests/lessons/lesson.sh build ''",
        "sh tests/lessons/exercise.sh build 3 3", "sh tests/lessons/exercise.sh build '' ''",
    };

    for (size_t i = 0; i < sizeof commands / sizeof commands[0]; i++) {
        char command[COMMAND_LENGTH];
        snprintf(command, sizeof command,
                 "lines=$(%s 2>&1); [ $? -eq 2 ] && [ \"$(echo \"$lines\" | wc -l)\" -eq 1 ]",
                 commands[i]);
        fflush(stdout);
        check(system(command) == 0, "a lesson that is not there is one line, exit status 2", "%s",
              commands[i]);
    }
}

void test_readme(void)
{
    for (int i = 0; readme_paths[i]; i++) {
        test_committed(readme_paths[i], i > 0);
    }
    test_pictures();
    test_prose();
    test_renew();
    test_line_count();
    test_usage();
}
