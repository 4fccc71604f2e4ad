#include "bench/results.h"

namespace ink::bench {
namespace {

// Why a run was broken off (State::SkipWithError), "" if it was not: never empty for one that was.
//
// Google Benchmark 1.8 put `skipped` and `skip_message` in the place of `error_occurred` and
// `error_message`; here alone is what depends on its version.
template <class Run>
[[nodiscard]] std::string error_of(const Run& run) {
    bool has_failed = false;
    std::string message;
    if constexpr (requires { run.error_occurred; }) {
        has_failed = run.error_occurred;
        message = run.error_message;
    } else {
        has_failed = static_cast<bool>(run.skipped);
        message = run.skip_message;
    }
    if (!has_failed) return "";
    return message.empty() ? "broken off" : message;
}

using Run = benchmark::BenchmarkReporter::Run;

/// The name without its number of threads, on which no result may depend.
std::string work_of(const std::string& name) {
    const auto found = name.find("/threads:");
    if (found == std::string::npos) return name;
    const auto end = name.find('/', found + 1);
    return name.substr(0, found) + (end == std::string::npos ? "" : name.substr(end));
}

}  // namespace

void Results::add(const std::vector<Run>& runs) {
    for (const Run& run : runs) {
        if (run.run_type != Run::RT_Iteration) continue;
        const auto [found, is_new] = rows_.try_emplace(run.family_index);
        Row& row = found->second;
        row.name = run.run_name.str();
        if (const std::string error = error_of(run); !error.empty()) row.error = error;
        if (!row.error.empty()) continue;
        if (is_new) row.hash = run.report_label;
        row.is_stable = row.is_stable && row.hash == run.report_label;
    }
}

std::vector<std::string> Results::complaints() const {
    std::vector<std::string> lines;
    std::map<std::string, std::string> hash_of;
    for (const auto& [family, row] : rows_) {
        if (!row.error.empty()) lines.push_back(row.name + ": " + row.error);
        if (!row.is_stable) lines.push_back(row.name + ": the result changed between repetitions");
        if (row.error.empty() && row.hash.empty())
            lines.push_back(row.name + ": no hash of the result");
        if (!row.error.empty()) continue;
        const auto [first, is_new] = hash_of.try_emplace(work_of(row.name), row.hash);
        if (first->second != row.hash)
            lines.push_back(row.name + ": the result depends on the number of threads");
    }
    return lines;
}

void Console::ReportRuns(const std::vector<Run>& runs) {
    results_.add(runs);
    std::vector<Run> shown;
    for (const Run& run : runs) {
        const bool is_only = run.run_type == Run::RT_Iteration && run.repetitions == 1;
        if (is_only || run.aggregate_name == "median" || run.aggregate_name == "min")
            shown.push_back(run);
    }
    if (!shown.empty()) ConsoleReporter::ReportRuns(shown);
}

}  // namespace ink::bench
