/* texmap chart: draws speed against accuracy from what `texmap bench` wrote. */
#include "tests/chart/chart.h"
#include "tests/files/file.h"
#include "tests/program/commands.h"

static bool write(const char *path, const struct chart *chart, struct error *error)
{
    FILE *file = NULL;

    if (!path_ends_in(path, ".svg")) {
        return error_set(error, "%s: a chart's name must end in .svg", path);
    }
    if ((file = file_create(path, error))) {
        chart_draw(file, chart);
    }
    return file && file_finish(file, path, error);
}

static enum outcome run(const struct options *options, struct error *error)
{
    struct csv csv;
    struct chart chart;

    if (!csv_read(options->argument, &csv, error)) {
        return OUTCOME_FAILED;
    }
    bool written = false;
    if (chart_load(&csv, &chart, error)) {
        written = write(options->output, &chart, error);
        chart_destroy(&chart);
    }
    csv_destroy(&csv);
    return written ? OUTCOME_DONE : OUTCOME_FAILED;
}

const struct command command_chart = {
    "chart", "BENCH.csv -o FILE.svg",
    "Draws speed against accuracy from a CSV file of `texmap bench`.",
    OPTION_ARGUMENT | OPTION_OUTPUT, OPTION_ARGUMENT | OPTION_OUTPUT, run};
