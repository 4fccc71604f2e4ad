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

Repetition repetition(std::int64_t family, const std::string& name, const char* hash) {
    Repetition run;
    run.family_index = family;
    run.run_name.function_name = name;
    run.iterations = 10;
    run.report_label = hash;
    return run;
}

TEST(Results, ComplainOfAHashThatChanged) {
    Results results;
    results.add({repetition(0, "steady", "h"), repetition(0, "steady", "h")});
    results.add({repetition(1, "shaky", "h"), repetition(1, "shaky", "i")});
    EXPECT_THAT(results.complaints(), ElementsAre("shaky: the result changed between repetitions"));
}

TEST(Results, ComplainOfAHashThatDependsOnThreads) {
    Results results;
    results.add({repetition(0, "frame/a/threads:1", "h"),
                 repetition(1, "frame/a/threads:2", "i"),
                 repetition(2, "frame/b/threads:2/iterations:3", "j"),
                 repetition(3, "frame/b/threads:1/iterations:3", "j")});
    EXPECT_THAT(results.complaints(),
                ElementsAre("frame/a/threads:2: the result depends on the number of threads"));
}

TEST(Results, ComplainOfNoHashAndOfAnError) {
    Results results;
    Repetition failed = repetition(1, "failed", "");
    break_off(failed, "differs from its formula");
    results.add({repetition(0, "nameless", ""), failed});
    EXPECT_THAT(results.complaints(),
                ElementsAre("nameless: no hash of the result", "failed: differs from its formula"));
}

TEST(Results, LeaveAggregates) {
    Results results;
    Repetition mean = repetition(0, "a", "");
    mean.run_type = Repetition::RT_Aggregate;
    results.add({mean});
    EXPECT_THAT(results.complaints(), IsEmpty());
}

}  // namespace
}  // namespace ink::bench
