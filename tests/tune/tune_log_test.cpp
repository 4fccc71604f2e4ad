#include "tune/tune_log.h"

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>

#include "core/error.h"
#include "core/whole_file.h"
#include "tests/core/temp_folder.h"

namespace ink::tune {
namespace {

namespace fs = std::filesystem;

class Log : public testing::Test {
  protected:
    const core::TempFolder folder_;
    const fs::path path_ = folder_ / "log.part";
};

TEST_F(Log, GivesBackWhatWasAddedToTheLastBit) {
    const double third = 1.0 / 3;
    {
        TuneLog log(path_, "k");
        EXPECT_EQ(log.found(), 0U);
        EXPECT_FALSE(log.find("a=1"));
        log.add("a=1;b=x", {third, third, {}});
        log.add("a=2;b=x", {1.5, third, 0.1});
    }
    const TuneLog log(path_, "k");
    EXPECT_EQ(log.found(), 2U);
    ASSERT_TRUE(log.find("a=1;b=x"));
    EXPECT_EQ(log.find("a=1;b=x")->value, third);
    EXPECT_FALSE(log.find("a=1;b=x")->draw_ms);
    EXPECT_EQ(log.find("a=2;b=x")->value, 1.5);
    EXPECT_EQ(log.find("a=2;b=x")->error, third);
    EXPECT_EQ(log.find("a=2;b=x")->draw_ms, 0.1);
}

TEST_F(Log, GivesBackTheCountsOfEveryView) {
    {
        TuneLog log(path_, "k");
        TuneValue value{.value = 0.5, .error = 0.5};
        value.by_view = {{3, 5, 7}, {0, 0, 1000000}};
        log.add("a=1", value);
    }
    const TuneLog log(path_, "k");
    ASSERT_TRUE(log.find("a=1"));
    const std::vector<score::CurveCount> by_view = log.find("a=1")->by_view;
    ASSERT_EQ(by_view.size(), 2U);
    EXPECT_EQ(by_view[0].n_pred, 5);
    EXPECT_EQ(by_view[1].n_truth, 1000000);
}

TEST_F(Log, ALineThatWasCutOffIsNone) {
    {
        TuneLog log(path_, "k");
        log.add("a=1", {0.25, 0.25, {}});
        log.add("a=2", {0.5, 0.5, {}});
    }
    std::string cut = core::read_whole_file(path_).value_or("");
    cut.resize(cut.size() - 4);
    std::ofstream(path_) << cut;
    {
        TuneLog log(path_, "k");
        EXPECT_EQ(log.found(), 1U);
        log.add("a=3", {0.75, 0.75, {}});
    }
    const TuneLog log(path_, "k");
    EXPECT_EQ(log.found(), 2U) << "and what is added next does not run on behind it";
    EXPECT_EQ(log.find("a=3")->value, 0.75);
}

TEST_F(Log, AnotherSearchsLinesAreNotTaken) {
    {
        TuneLog log(path_, "one");
        log.add("a=1", {0.25, 0.25, {}});
    }
    const TuneLog log(path_, "two");
    EXPECT_EQ(log.found(), 0U);
}

TEST_F(Log, IsGoneWhenTheSearchIsFinished) {
    TuneLog log(path_, "k");
    log.add("a=1", {0.25, 0.25, {}});
    log.remove();
    EXPECT_FALSE(fs::exists(path_));
}

TEST_F(Log, AFolderThatIsNotThereIsAnError) {
    EXPECT_THROW(TuneLog(path_ / "none" / "log", "k"), core::Error);
}

}  // namespace
}  // namespace ink::tune
