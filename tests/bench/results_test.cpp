#include "bench/results.h"

#include <gmock/gmock.h>

#include <string>

namespace ink::bench {
namespace {

using testing::ElementsAre;
using testing::IsEmpty;
using Repetition = benchmark::BenchmarkReporter::Run;

/// As State::SkipWithError leaves a run, in any version of Google Benchmark.
template <class Run>
void break_off(Run& run, const std::string& message) {
    if constexpr (requires { run.error_occurred; }) {
        run.error_occurred = true;
        run.error_message = message;
    } else {
        run.skipped = static_cast<decltype(run.skipped)>(2);  // SkippedWithError
        run.skip_message = message;
    }
}

/// One repetition of ten iterations that took `time_s` of one thread each, and waited as long.
Repetition repetition(std::int64_t family,
                      const std::string& name,
                      double time_s,
                      const char* hash) {
    Repetition run;
    run.family_index = family;
    run.run_name.function_name = name;
    run.iterations = 10;
    run.cpu_accumulated_time = 10 * time_s;
    run.real_accumulated_time = 20 * time_s;
    run.report_label = hash;
    return run;
}

TEST(Results, HaveLeastAndMedianInTheOrderOfRegistration) {
    Results results;
    results.add({repetition(7, "b", 4, "h"), repetition(7, "b", 2, "h")});
    results.add(
        {repetition(3, "a", 5, "g"), repetition(3, "a", 1, "g"), repetition(3, "a", 2, "g")});
    ASSERT_EQ(results.rows().size(), 2U);
    const Results::Row& first = results.rows().begin()->second;
    EXPECT_EQ(first.name, "a");
    EXPECT_EQ(first.hash, "g");
    EXPECT_DOUBLE_EQ(first.least_s(), 1);
    EXPECT_DOUBLE_EQ(first.median_s(), 2);
    EXPECT_DOUBLE_EQ(results.rows().at(7).median_s(), 3);
    EXPECT_THAT(results.complaints(), IsEmpty());
}

TEST(Results, OfTwoThreadsAreTimedByTheWall) {
    Results results;
    results.add({repetition(0, "a/threads:1", 3, "h"), repetition(1, "a/threads:2/b", 3, "h")});
    EXPECT_DOUBLE_EQ(results.rows().at(0).least_s(), 3);
    EXPECT_DOUBLE_EQ(results.rows().at(1).least_s(), 6);
}

TEST(Results, TakeTheCopyOfAByteFrameForYardstick) {
    Results results;
    EXPECT_EQ(results.yardstick_s(), 0);
    results.add({repetition(0, "memcpy/u16/1080p", 1, "h"),
                 repetition(1, "memcpy/u8/1080p", 3, "h"),
                 repetition(1, "memcpy/u8/1080p", 2, "h")});
    EXPECT_DOUBLE_EQ(results.yardstick_s(), 2);
}

TEST(Results, ComplainOfAHashThatChanged) {
    Results results;
    results.add({repetition(0, "steady", 1, "h"), repetition(0, "steady", 1, "h")});
    results.add({repetition(1, "shaky", 1, "h"), repetition(1, "shaky", 1, "i")});
    EXPECT_THAT(results.complaints(), ElementsAre("shaky: the result changed between repetitions"));
}

TEST(Results, ComplainOfAHashThatDependsOnThreads) {
    Results results;
    results.add({repetition(0, "frame/a/threads:1", 1, "h"),
                 repetition(1, "frame/a/threads:2", 1, "i"),
                 repetition(2, "frame/b/threads:2/iterations:3", 1, "j"),
                 repetition(3, "frame/b/threads:1/iterations:3", 1, "j")});
    EXPECT_THAT(results.complaints(),
                ElementsAre("frame/a/threads:2: the result depends on the number of threads"));
}

TEST(Results, ComplainOfNoHashAndOfAnError) {
    Results results;
    Repetition failed = repetition(1, "failed", 1, "");
    break_off(failed, "differs from its formula");
    results.add({repetition(0, "nameless", 1, ""), failed});
    EXPECT_THAT(results.complaints(),
                ElementsAre("nameless: no hash of the result", "failed: differs from its formula"));
    EXPECT_THAT(results.rows().at(1).times_s, IsEmpty());
}

TEST(Results, LeaveAggregates) {
    Results results;
    Repetition mean = repetition(0, "a", 1, "h");
    mean.run_type = Repetition::RT_Aggregate;
    results.add({mean});
    EXPECT_THAT(results.rows(), IsEmpty());
}

}  // namespace
}  // namespace ink::bench
