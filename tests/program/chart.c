/* texmap chart: draws speed against accuracy from what `texmap bench` wrote. */
#include "tests/chart/chart.h"
#include "tests/program/commands.h"

static enum outcome run(const struct options *options, struct error *error)
{
    struct csv csv;
    struct chart chart;

    if (!csv_read(options->argument, &csv, error)) {
        return OUTCOME_FAILED;
    }
    bool written = false;
    if (chart_load(&csv, &chart, error)) {
        written = chart_write(options->output, &chart, error);
        chart_destroy(&chart);
    }
    csv_destroy(&csv);
    return written ? OUTCOME_DONE : OUTCOME_FAILED;
}

const struct command command_chart = {
    "chart", "BENCH.csv -o FILE.svg",
    "Draws speed against accuracy from a CSV file of `texmap bench`.",
    OPTION_ARGUMENT | OPTION_OUTPUT, OPTION_ARGUMENT | OPTION_OUTPUT, run};
