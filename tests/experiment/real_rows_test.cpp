// Rows as a run makes them: every score, of methods, a preset and baselines.

#include <gtest/gtest.h>

#include "catalogue/catalogue.h"
#include "harness/cells/view_cells.h"
#include "harness/rows/side_tables.h"
#include "methods/method_configs.h"
#include "tests/harness/random_rows.h"

namespace ink::experiment {
namespace {

/// The evaluations of one small view of a scene, scored in full.
std::vector<harness::Evaluation> scored_evaluations(const std::string& name) {
    const scene::Scene scene = catalogue::make_catalogue_scene(name);
    const scene::View view{scene.cameras.front(), 160, 90};
    harness::CellOptions options;
    options.measure.max_repetitions = 1;
    options.seed = 18446744073709551615ULL;
    truth::SceneModel model(scene, options.trace.truth);
    const auto methods =
        harness::prepare_methods(methods::make_configs("mote4,decaudin,edge_list,auto", {}), scene);
    std::vector<harness::Evaluation> evaluations =
        harness::method_evaluations(methods, view, options.measure);
    const harness::TracedView traced = harness::trace_with_facts(model, scene, view, options.trace);
    harness::finish_evaluations(scene, view, traced, options, evaluations);
    return evaluations;
}

TEST(RealRows, GoThroughTheirFilesUnchanged) {
    std::string rows, tolerances, bins, costs;
    std::int64_t cell = 0;
    for (const char* scene : {"cube", "teapot"}) {
        for (const harness::Evaluation& evaluation : scored_evaluations(scene)) {
            ASSERT_EQ(evaluation.row.status, "ok");
            rows += harness::row_line(++cell, harness::Study::compare, evaluation.row);
            tolerances += harness::tolerance_lines(cell, evaluation.row.tolerance_sweep);
            bins += harness::bin_lines(cell, evaluation.row.bins);
            costs += harness::cost_line(cell, evaluation.row);
        }
    }
    std::vector<harness::RowRecord> read =
        harness::read_rows(harness::file_of(harness::rows_table(), rows));
    ASSERT_EQ(read.size(), 16U) << "2 scenes of 4 methods and 4 baselines";
    harness::join_tolerances(harness::file_of(harness::tolerances_table(), tolerances), read);
    harness::join_bins(harness::file_of(harness::bins_table(), bins), read);
    harness::join_costs(harness::file_of(harness::cost_table(), costs), read);
    std::string rows_again, tolerances_again, bins_again, costs_again;
    for (const harness::RowRecord& record : read) {
        rows_again += harness::row_line(record.cell, record.study, record.row);
        tolerances_again += harness::tolerance_lines(record.cell, record.row.tolerance_sweep);
        bins_again += harness::bin_lines(record.cell, record.row.bins);
        costs_again += harness::cost_line(record.cell, record.row);
    }
    EXPECT_EQ(rows_again, rows);
    EXPECT_EQ(tolerances_again, tolerances);
    EXPECT_EQ(bins_again, bins);
    EXPECT_EQ(costs_again, costs);
    EXPECT_GT(costs.size(), 0U);
}

}  // namespace
}  // namespace ink::experiment
