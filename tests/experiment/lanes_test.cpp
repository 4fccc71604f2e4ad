// Blocks beside each other on lanes, of many scenes and of one, against one after the other.

#include <gtest/gtest.h>

#include <filesystem>

#include "core/parallel.h"
#include "core/tables/csv_table.h"
#include "core/whole_file.h"
#include "experiment/experiment_run.h"
#include "harness/rows/row_table.h"
#include "tests/core/temp_folder.h"

namespace ink::experiment {
namespace {

namespace fs = std::filesystem;

Experiment small_comparison(bool times) {
    Experiment experiment;
    experiment.where = "test";
    experiment.name = "lanes";
    experiment.methods = {"mote4", "ids", "decaudin"};
    experiment.scenes = {"cube", "torus", "gear", "tiles"};
    experiment.sizes = {{160, 90}};
    experiment.compare.views = 2;
    experiment.compare.own_sweep_views = 1;
    experiment.repetitions = 2;
    experiment.times = times;
    return experiment;
}

class Lanes : public testing::Test {
  protected:
    fs::path run(const Experiment& experiment, int lanes) {
        const RunOptions options{.out = folder_ / std::to_string(lanes), .lanes = lanes};
        EXPECT_EQ(run_experiment(make_plan(experiment, {}), options).record.state,
                  RunState::finished);
        return options.out;
    }

    /// On many lanes as on one.
    void expect_same_bytes(const Experiment& experiment) {
        const fs::path one = run(experiment, 1);
        const fs::path many = run(experiment, core::hardware_threads());
        for (const auto& entry : fs::recursive_directory_iterator(one)) {
            const fs::path name = fs::relative(entry.path(), one);
            if (!entry.is_regular_file() || name == "run.toml") continue;
            const auto bytes = core::read_whole_file(many / name);
            ASSERT_TRUE(bytes) << name;
            EXPECT_TRUE(*bytes == core::read_whole_file(entry.path())) << name;
        }
    }

    const core::TempFolder folder_;
};

TEST_F(Lanes, WriteTheSameBytesWithoutTimes) {
    expect_same_bytes(small_comparison(false));
}

TEST_F(Lanes, ShareAScene) {
    Experiment experiment = small_comparison(false);
    experiment.scenes = {"gear"};
    experiment.compare.views = 3;
    expect_same_bytes(experiment);
}

TEST_F(Lanes, HaveTheSameRowsButForTimes) {
    const Experiment experiment = small_comparison(true);
    const auto rows = [&](int lanes) {
        const auto text = core::read_whole_file(run(experiment, lanes) / "rows.csv");
        std::vector<std::string> lines;
        for (harness::RowRecord& record : harness::read_rows(core::split_csv(*text, "rows.csv"))) {
            if (!harness::is_baseline(record.row.method)) {
                EXPECT_GT(record.row.draw_n, 0);
                EXPECT_TRUE(record.row.draw_ns.has_value());
            }
            clear_times(record.row);
            lines.push_back(harness::row_line(record.cell, record.study, record.row));
        }
        return lines;
    };
    const auto one = rows(1);
    EXPECT_EQ(one.size(), 4U * 2 * 7);
    EXPECT_EQ(rows(core::hardware_threads()), one);
}

}  // namespace
}  // namespace ink::experiment
