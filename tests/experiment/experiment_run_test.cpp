#include "experiment/experiment_run.h"

#include <gmock/gmock.h>
#include <sys/resource.h>

#include <algorithm>
#include <atomic>
#include <csignal>
#include <fstream>
#include <mutex>
#include <set>
#include <sstream>

#include "core/error.h"
#include "core/tables/csv_table.h"
#include "core/whole_file.h"
#include "experiment/block_store.h"
#include "tests/core/error_text.h"
#include "tests/core/temp_folder.h"

namespace ink::experiment {
namespace {

namespace fs = std::filesystem;
using testing::HasSubstr;

/// A plan whose blocks only count how often they run: block i has two lines and takes work i + 1.
Plan counting_plan(int blocks, std::vector<int>& runs) {
    runs.assign(static_cast<std::size_t>(blocks), 0);
    Plan plan;
    plan.name = "counting";
    plan.kind = "counting";
    plan.asked = "blocks = " + std::to_string(blocks) + "\n";
    plan.identity = "plan-of-" + std::to_string(blocks);
    plan.build = "test";
    plan.tables = {{"t.csv", "block,draw_ns"}};
    for (int i = 0; i < blocks; ++i) {
        const std::string name = std::to_string(i);
        plan.blocks.push_back(
            {"block " + name, 2, i + 1.0, false, [&runs, i, name] {
                 ++runs[static_cast<std::size_t>(i)];
                 return BlockResult{{{"t.csv", name + ",5\n" + name + ",6\n"}}, {}, {}};
             }});
    }
    return plan;
}

std::string text_of(const fs::path& path) {
    return core::read_whole_file(path).value_or("");
}

/// What run.toml says but for how long the blocks took.
std::string text_of_asked(const fs::path& folder) {
    std::istringstream lines(text_of(folder / "run.toml"));
    std::string text;
    for (std::string line; std::getline(lines, line);)
        if (line.find("work_s") == std::string::npos) text += line + "\n";
    return text;
}

class ExperimentRun : public testing::Test {
  protected:
    [[nodiscard]] RunOptions into(const std::string& name, Shard shard = {}) const {
        RunOptions options{.out = folder_ / name, .shard = shard};
        return options;
    }
    const core::TempFolder folder_;
    std::vector<int> runs_;
};

TEST_F(ExperimentRun, WritesItsTablesInPlanOrderAndLeavesOnlyThose) {
    const Plan plan = counting_plan(3, runs_);
    (void)run_experiment(plan, into("a"));
    EXPECT_EQ(text_of(folder_ / "a" / "t.csv"), "block,draw_ns\n0,5\n0,6\n1,5\n1,6\n2,5\n2,6\n");
    std::set<std::string> names;
    for (const auto& entry : fs::directory_iterator(folder_ / "a"))
        names.insert(entry.path().filename());
    EXPECT_EQ(names, (std::set<std::string>{"run.toml", "t.csv"}));
}

TEST_F(ExperimentRun, DoesNothingAgainWhenAllIsDone) {
    const Plan plan = counting_plan(3, runs_);
    (void)run_experiment(plan, into("a"));
    (void)run_experiment(plan, into("a"));
    EXPECT_EQ(runs_, (std::vector<int>{1, 1, 1}));
    fs::remove(folder_ / "a" / "t.csv");
    (void)run_experiment(plan, into("a"));
    EXPECT_EQ(runs_, (std::vector<int>{2, 2, 2})) << "somebody took the table away";
    RunOptions forced = into("a");
    forced.is_forced = true;
    (void)run_experiment(plan, forced);
    EXPECT_EQ(runs_, (std::vector<int>{3, 3, 3}));
}

TEST_F(ExperimentRun, GoesOnAfterABlockThatThrew) {
    Plan plan = counting_plan(3, runs_);
    const auto good = plan.blocks[1].run;
    plan.blocks[1].run = []() -> BlockResult { throw core::Error("block", "it broke"); };
    EXPECT_THAT(core::error_text([&] { (void)run_experiment(plan, into("a")); }),
                HasSubstr("it broke"));
    plan.blocks[1].run = good;
    (void)run_experiment(plan, into("a"));
    EXPECT_EQ(runs_, (std::vector<int>{1, 1, 1})) << "the first block must not run twice";
}

TEST_F(ExperimentRun, ComputesADamagedBlockAgain) {
    const Plan plan = counting_plan(2, runs_);
    // A shard keeps its blocks: cut a part of one of them short, as a machine without power may.
    const Shard shard{1, 2};
    (void)run_experiment(plan, into("b", shard));
    const BlockStore store(folder_ / "b");
    ASSERT_EQ(store.indices().size(), 1U);
    const std::size_t i = store.indices().front();
    ASSERT_TRUE(store.read(i));
    const fs::path part = folder_ / "b" / "blocks" / ("00000" + std::to_string(i)) / "t.csv";
    fs::resize_file(part, fs::file_size(part) - 3);
    EXPECT_FALSE(store.read(i));
    const int before = runs_[i];
    (void)run_experiment(plan, into("b", shard));
    EXPECT_EQ(runs_[i], before + 1);
    EXPECT_TRUE(store.read(i));
}

TEST_F(ExperimentRun, MovesTheImagesOfItsBlocksToTheFolder) {
    Plan plan = counting_plan(2, runs_);
    plan.blocks[1].run = [] {
        return BlockResult{{{"t.csv", "1,5\n"}}, {{"images/s/v/truth.png", "png"}}, {}};
    };
    (void)run_experiment(plan, into("a"));
    EXPECT_EQ(text_of(folder_ / "a" / "images" / "s" / "v" / "truth.png"), "png");
    EXPECT_FALSE(fs::exists(folder_ / "a" / "blocks"));
}

TEST_F(ExperimentRun, ForcedRunLeavesNothingOfTheOneBefore) {
    Plan plan = counting_plan(2, runs_);
    plan.blocks[0].run = [] {
        return BlockResult{{{"t.csv", "0,5\n"}}, {{"images/s/v/truth.png", "png"}}, {}};
    };
    (void)run_experiment(plan, into("a"));
    std::ofstream(folder_ / "a" / "report.html") << "old";
    std::ofstream(folder_ / "a" / "notes.txt") << "the user's own";
    RunOptions forced = into("a");
    forced.is_forced = true;
    (void)run_experiment(counting_plan(3, runs_), forced);
    EXPECT_FALSE(fs::exists(folder_ / "a" / "images"));
    EXPECT_FALSE(fs::exists(folder_ / "a" / "report.html"));
    EXPECT_EQ(text_of(folder_ / "a" / "notes.txt"), "the user's own");
}

TEST_F(ExperimentRun, RefusesResultsThatItCannotTellApart) {
    fs::create_directories(folder_ / "a");
    std::ofstream(folder_ / "a" / "rows.csv") << "method\n";
    EXPECT_THAT(core::error_text([&] { (void)run_experiment(counting_plan(1, runs_), into("a")); }),
                testing::AllOf(HasSubstr("without a run.toml"), HasSubstr("--force")));
    EXPECT_EQ(text_of(folder_ / "a" / "rows.csv"), "method\n");
}

TEST_F(ExperimentRun, RunsAGroupInOrderAndBlocksWithoutOneAlone) {
    Plan plan = counting_plan(9, runs_);
    std::mutex mutex;
    std::vector<std::size_t> begun;
    std::atomic<int> busy = 0;
    bool was_alone = true;
    for (std::size_t i = 0; i < plan.blocks.size(); ++i) {
        Block& block = plan.blocks[i];
        if (i < 8) block.group = i % 4;
        block.run = [&, i, compute = block.run] {
            ++busy;
            BlockResult result = compute();
            {
                const std::lock_guard lock(mutex);
                begun.push_back(i);
                if (i == 8) was_alone = busy == 1 && begun.size() == 9;
            }
            --busy;
            return result;
        };
    }
    EXPECT_EQ(run_experiment(plan, into("a")).record.state, RunState::finished);
    EXPECT_TRUE(was_alone);
    ASSERT_EQ(begun.size(), 9U);
    for (std::size_t group = 0; group < 4; ++group)
        EXPECT_LT(std::find(begun.begin(), begun.end(), group),
                  std::find(begun.begin(), begun.end(), group + 4));
    RunOptions one_lane = into("b");
    one_lane.lanes = 1;
    EXPECT_EQ(run_experiment(plan, one_lane).record.state, RunState::finished);
    EXPECT_EQ(text_of(folder_ / "a" / "t.csv"), text_of(folder_ / "b" / "t.csv"));
    EXPECT_EQ(text_of_asked(folder_ / "a"), text_of_asked(folder_ / "b"));
}

TEST_F(ExperimentRun, EndsAllLanesWhenABlockThrows) {
    Plan plan = counting_plan(6, runs_);
    for (std::size_t i = 0; i < plan.blocks.size(); ++i)
        plan.blocks[i].group = i;
    plan.blocks[5].run = []() -> BlockResult { throw core::Error("block 5", "broken", "whole"); };
    EXPECT_THAT(core::error_text([&] { (void)run_experiment(plan, into("a")); }),
                HasSubstr("broken"));
}

TEST_F(ExperimentRun, RecordsWhatIsMissingWhenItIsCutShort) {
    Plan plan = counting_plan(3, runs_);
    plan.blocks[1].run = [] {
        std::raise(SIGINT);
        return BlockResult{{{"t.csv", "1,5\n"}}, {}, {}};
    };
    const RunOutcome outcome = run_experiment(plan, into("a"));
    EXPECT_TRUE(outcome.is_interrupted);
    EXPECT_THAT(outcome.record.missing_blocks, testing::ElementsAre("block 2"));
    EXPECT_EQ(text_of(folder_ / "a" / "t.csv"), "block,draw_ns\n0,5\n0,6\n1,5\n");
    const auto record = read_record(folder_ / "a");
    ASSERT_TRUE(record);
    EXPECT_EQ(record->state, RunState::unfinished);
    EXPECT_EQ(record->blocks_done, 2);
    EXPECT_THAT(record->missing_blocks, testing::ElementsAre("block 2"));
    const RunOutcome next = run_experiment(plan, into("a"));
    EXPECT_EQ(next.record.state, RunState::finished);
    EXPECT_EQ(text_of(folder_ / "a" / "t.csv"), "block,draw_ns\n0,5\n0,6\n1,5\n2,5\n2,6\n");
}

TEST_F(ExperimentRun, RecordsWhatThereIsToSayOfModels) {
    Plan plan = counting_plan(1, runs_);
    scene::Scene plain;
    plan.add_model(plain);
    EXPECT_TRUE(plan.models.empty());
    scene::Scene far;
    far.name = "far";
    far.origin = {691000, 0, 5335000};
    far.file.notes = {"a lamp"};
    plan.add_model(far);
    (void)run_experiment(plan, into("a"));
    const auto record = read_record(folder_ / "a");
    ASSERT_TRUE(record);
    EXPECT_EQ(record->models, (std::vector<ModelFacts>{{"far", {691000, 0, 5335000}, {"a lamp"}}}));
}

TEST_F(ExperimentRun, RefusesAFolderOfAnotherPlanOrAnotherRun) {
    (void)run_experiment(counting_plan(2, runs_), into("a"));
    const Plan other = counting_plan(3, runs_);
    EXPECT_THAT(core::error_text([&] { (void)run_experiment(other, into("a")); }),
                testing::AllOf(HasSubstr("blocks = 2, here blocks = 3"), HasSubstr("--force")));
    EXPECT_EQ(runs_, (std::vector<int>{0, 0, 0}));
    EXPECT_EQ(text_of(folder_ / "a" / "t.csv"), "block,draw_ns\n0,5\n0,6\n1,5\n1,6\n");
    const FolderLock lock(folder_ / "a", false);
    EXPECT_THAT(core::error_text([&] { (void)run_experiment(other, into("a")); }),
                HasSubstr("another run"));
}

TEST_F(ExperimentRun, ShowsBothListsWhereAnotherRunHasAnother) {
    Plan plan = counting_plan(1, runs_);
    plan.asked = "scenes = [\n    'cube',\n    'torus'\n]\nviews = 2\n";
    (void)run_experiment(plan, into("a"));
    plan.asked = "scenes = [ 'cube' ]\nviews = 2\n";
    plan.identity = "another";
    EXPECT_THAT(core::error_text([&] { (void)run_experiment(plan, into("a")); }),
                HasSubstr("there scenes = [ 'cube', 'torus' ], here scenes = [ 'cube' ] ("));
}

TEST_F(ExperimentRun, KeepsWhatIsFinishedWhenTheDiskIsFull) {
    Plan plan = counting_plan(3, runs_);
    const auto good = plan.blocks[1].run;
    plan.blocks[1].run = [] {
        return BlockResult{{{"t.csv", std::string(1 << 20, 'x') + ",1\n"}}, {}, {}};
    };
    rlimit before{};
    getrlimit(RLIMIT_FSIZE, &before);
    const rlimit small{1 << 16, before.rlim_max};
    const auto old = std::signal(SIGXFSZ, SIG_IGN);
    setrlimit(RLIMIT_FSIZE, &small);
    const std::string error = core::error_text([&] { (void)run_experiment(plan, into("a")); });
    setrlimit(RLIMIT_FSIZE, &before);
    std::signal(SIGXFSZ, old);
    EXPECT_THAT(error, HasSubstr("cannot be written"));
    EXPECT_FALSE(fs::exists(folder_ / "a" / "t.csv"));
    plan.blocks[1].run = good;
    (void)run_experiment(plan, into("a"));
    EXPECT_EQ(runs_, (std::vector<int>{1, 1, 1}));
    EXPECT_EQ(text_of(folder_ / "a" / "t.csv"), "block,draw_ns\n0,5\n0,6\n1,5\n1,6\n2,5\n2,6\n");
}

TEST_F(ExperimentRun, AnInvalidRunSaysSoAgain) {
    Plan plan = counting_plan(1, runs_);
    plan.blocks[0].run = [] { return BlockResult{{{"t.csv", "0,1\n"}}, {}, {"a, b", "c"}}; };
    for (int i = 0; i < 2; ++i) {
        EXPECT_THAT(run_experiment(plan, into("a")).record.faults,
                    testing::ElementsAre("a, b", "c"));
    }
}

TEST_F(ExperimentRun, MergesShardsToTheBytesOfOneRun) {
    const Plan plan = counting_plan(7, runs_);
    (void)run_experiment(plan, into("whole"));
    std::vector<fs::path> parts;
    for (int i = 1; i <= 3; ++i) {
        const std::string name = "part" + std::to_string(i);
        (void)run_experiment(plan, into(name, {i, 3}));
        EXPECT_FALSE(fs::exists(folder_ / name / "t.csv"));
        parts.push_back(folder_ / name);
    }
    (void)merge_shards(parts, folder_ / "merged");
    EXPECT_EQ(text_of(folder_ / "merged" / "t.csv"), text_of(folder_ / "whole" / "t.csv"));
    EXPECT_EQ(text_of_asked(folder_ / "merged"), text_of_asked(folder_ / "whole"));
}

TEST_F(ExperimentRun, MergeRefusesWhatDoesNotFit) {
    const Plan plan = counting_plan(4, runs_);
    (void)run_experiment(plan, into("a", {1, 2}));
    (void)run_experiment(plan, into("b", {2, 2}));
    (void)run_experiment(plan, into("c", {2, 2}));
    (void)run_experiment(plan, into("whole"));
    std::vector<int> others;
    (void)run_experiment(counting_plan(5, others), into("foreign", {1, 2}));
    const auto merge = [&](const std::vector<std::string>& names) {
        std::vector<fs::path> folders;
        for (const std::string& name : names)
            folders.push_back(folder_ / name);
        return core::error_text([&] { (void)merge_shards(folders, folder_ / "m"); });
    };
    EXPECT_THAT(merge({"a"}),
                testing::AllOf(HasSubstr("2 of 4 blocks are missing"), HasSubstr("'block ")));
    EXPECT_THAT(merge({"a", "b", "c"}), testing::AllOf(HasSubstr("/c"), HasSubstr("/b too")));
    EXPECT_THAT(merge({"a", "foreign"}), testing::AllOf(HasSubstr("/foreign"), HasSubstr("/a")));
    EXPECT_THAT(merge({"a", "nowhere"}), HasSubstr("/nowhere"));
    EXPECT_THAT(merge({"whole"}), HasSubstr("finished"));
    EXPECT_FALSE(fs::exists(folder_ / "m"));
}

TEST(ShardBlocks, ShareAllBlocksOutEvenly) {
    std::vector<int> runs;
    const Plan plan = counting_plan(40, runs);  // 820 of work
    for (const int n : {1, 3, 7, 50}) {
        std::multiset<std::size_t> all;
        for (int i = 1; i <= n; ++i) {
            double work = 0;
            for (const std::size_t block : shard_blocks(plan, i, n)) {
                all.insert(block);
                work += plan.blocks[block].work;
            }
            EXPECT_LE(work, 820.0 / n + 40) << i << "/" << n;
        }
        EXPECT_EQ(all.size(), 40U);
        EXPECT_EQ(std::set<std::size_t>(all.begin(), all.end()).size(), 40U);
    }
}

TEST(ParseShard, TakesOneToN) {
    EXPECT_EQ(parse_shard("2/4").i, 2);
    EXPECT_EQ(parse_shard("2/4").n, 4);
    for (const char* bad : {"", "2", "0/4", "5/4", "1/0", "a/b", "1/2/3", "1/2 ", "-1/2"})
        EXPECT_THROW((void)parse_shard(bad), core::Error) << bad;
}

TEST(CsvTable, KeepsEveryByteOfFieldsItDoesNotChange) {
    const std::string text = "a,b\n\"x, \"\"y\"\"\n\",2\n,\n";
    const core::CsvTable table = core::split_csv(text, "t");
    ASSERT_EQ(table.records.size(), 2U);
    EXPECT_EQ(core::unquoted(table.records[0][0]), "x, \"y\"\n");
    EXPECT_EQ(table.records[0], (std::vector<std::string>{"\"x, \"\"y\"\"\n\"", "2"}));
    EXPECT_EQ(table.records[1], (std::vector<std::string>{"", ""}));
    EXPECT_THROW((void)core::split_csv("a,b\n1\n", "t"), core::Error);
    EXPECT_TRUE(core::split_csv("", "t").columns.empty());
}

}  // namespace
}  // namespace ink::experiment
