#include "bench/ratios.h"

#include <fmt/format.h>

#include <algorithm>
#include <ostream>

namespace ink::bench {
namespace {

constexpr const char* kYardstick = "memcpy/u8/1080p";

}  // namespace

RatioReporter::RatioReporter() : ConsoleReporter(OO_Tabular) {}

void RatioReporter::ReportRuns(const std::vector<Run>& runs) {
    ConsoleReporter::ReportRuns(runs);
    for (const Run& run : runs) {
        if (run.run_type != Run::RT_Iteration || run.iterations == 0) continue;
        const std::string name = run.run_name.str();
        const double time_s = run.real_accumulated_time / static_cast<double>(run.iterations);
        const auto [entry, is_new] = least_s_.try_emplace(name, time_s);
        if (is_new) names_.push_back(name);
        entry->second = std::min(entry->second, time_s);
    }
}

void RatioReporter::Finalize() {
    ConsoleReporter::Finalize();
    const auto yardstick = least_s_.find(kYardstick);
    if (yardstick == least_s_.end()) return;
    GetOutputStream() << fmt::format("\n{:<48} {:>12} {:>10}\n", "least time", "us", "M");
    for (const std::string& name : names_) {
        const double time_s = least_s_.at(name);
        GetOutputStream() << fmt::format(
            "{:<48} {:>12.1f} {:>10.2f}\n", name, time_s * 1e6, time_s / yardstick->second);
    }
}

}  // namespace ink::bench
