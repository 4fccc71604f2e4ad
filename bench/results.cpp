#include "bench/results.h"

#include <fmt/format.h>

#include <algorithm>
#include <ostream>

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

constexpr const char* kYardstick = "memcpy/u8/1080p";

using Run = benchmark::BenchmarkReporter::Run;

bool is_repetition(const Run& run) {
    return run.run_type == Run::RT_Iteration && error_of(run).empty() && run.iterations > 0;
}

/// The name without its number of threads, on which no result may depend.
std::string work_of(const std::string& name) {
    const auto found = name.find("/threads:");
    if (found == std::string::npos) return name;
    const auto end = name.find('/', found + 1);
    return name.substr(0, found) + (end == std::string::npos ? "" : name.substr(end));
}

/// Seconds of an iteration: processor time where one thread works, time on the wall of several.
double seconds_of(const Run& run) {
    const std::string name = run.run_name.str();
    const std::size_t at = name.find("/threads:");
    const bool is_one = at == std::string::npos || name.substr(at).starts_with("/threads:1");
    return (is_one ? run.cpu_accumulated_time : run.real_accumulated_time) /
           static_cast<double>(run.iterations);
}

/// The repetition that took least, as an aggregate.
Run least_of(const std::vector<Run>& runs) {
    Run least;
    bool is_first = true;
    for (const Run& run : runs) {
        if (!is_repetition(run)) continue;
        if (is_first || seconds_of(run) < seconds_of(least)) least = run;
        is_first = false;
    }
    least.run_type = Run::RT_Aggregate;
    least.aggregate_name = "min";
    return least;
}

}  // namespace

double Results::Row::least_s() const {
    return *std::min_element(times_s.begin(), times_s.end());
}

double Results::Row::median_s() const {
    std::vector<double> sorted = times_s;
    std::sort(sorted.begin(), sorted.end());
    const std::size_t half = sorted.size() / 2;
    return sorted.size() % 2 == 1 ? sorted[half] : (sorted[half - 1] + sorted[half]) / 2;
}

void Results::add(const std::vector<Run>& runs) {
    for (const Run& run : runs) {
        if (run.run_type != Run::RT_Iteration) continue;
        Row& row = rows_[run.family_index];
        row.name = run.run_name.str();
        if (const std::string error = error_of(run); !error.empty()) row.error = error;
        if (!is_repetition(run)) continue;
        if (row.times_s.empty()) row.hash = run.report_label;
        row.is_stable = row.is_stable && row.hash == run.report_label;
        row.times_s.push_back(seconds_of(run));
    }
}

double Results::yardstick_s() const {
    for (const auto& [family, row] : rows_) {
        if (row.name == kYardstick && !row.times_s.empty()) return row.least_s();
    }
    return 0;
}

std::vector<std::string> Results::complaints() const {
    std::vector<std::string> lines;
    std::map<std::string, std::string> hash_of;
    for (const auto& [family, row] : rows_) {
        if (!row.error.empty()) lines.push_back(row.name + ": " + row.error);
        if (!row.is_stable) lines.push_back(row.name + ": the result changed between repetitions");
        if (row.error.empty() && row.hash.empty())
            lines.push_back(row.name + ": no hash of the result");
        if (row.times_s.empty()) continue;
        const auto [first, is_new] = hash_of.try_emplace(work_of(row.name), row.hash);
        if (first->second != row.hash)
            lines.push_back(row.name + ": the result depends on the number of threads");
    }
    return lines;
}

void TableReporter::ReportRuns(const std::vector<Run>& runs) {
    results_.add(runs);
    std::vector<Run> shown;
    for (const Run& run : runs) {
        const bool is_only = run.run_type == Run::RT_Iteration && run.repetitions == 1;
        const bool has_failed = !error_of(run).empty();
        if (is_only || has_failed || run.aggregate_name == "median") shown.push_back(run);
    }
    if (!shown.empty()) ConsoleReporter::ReportRuns(shown);
}

void TableReporter::Finalize() {
    ConsoleReporter::Finalize();
    const double yardstick_s = results_.yardstick_s();
    std::ostream& out = GetOutputStream();
    out << fmt::format("\n{:<48} {:>12} {:>12} {:>10}  {}\n",
                       "benchmark",
                       "least us",
                       "median us",
                       "least M",
                       "hash of the result");
    for (const auto& [family, row] : results_.rows()) {
        if (row.times_s.empty()) continue;
        const std::string in_m =
            yardstick_s > 0 ? fmt::format("{:.2f}", row.least_s() / yardstick_s) : "-";
        out << fmt::format("{:<48} {:>12.1f} {:>12.1f} {:>10}  {}\n",
                           row.name,
                           row.least_s() * 1e6,
                           row.median_s() * 1e6,
                           in_m,
                           row.hash);
    }
}

void JsonReporter::ReportRuns(const std::vector<Run>& runs) {
    results_.add(runs);
    for (const Run& run : runs)
        runs_[run.family_index].push_back(run);
}

void JsonReporter::Finalize() {
    const double yardstick_s = results_.yardstick_s();
    std::vector<Run> all;
    for (auto& [family, runs] : runs_) {
        if (std::any_of(runs.begin(), runs.end(), is_repetition)) runs.push_back(least_of(runs));
        for (Run& run : runs) {
            const bool is_in_m = run.aggregate_name == "min" || run.aggregate_name == "median";
            if (is_in_m && yardstick_s > 0) run.counters["M"] = seconds_of(run) / yardstick_s;
        }
        all.insert(all.end(), runs.begin(), runs.end());
    }
    JSONReporter::ReportRuns(all);
    JSONReporter::Finalize();
}

}  // namespace ink::bench
