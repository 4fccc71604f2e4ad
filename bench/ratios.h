#pragma once

#include <benchmark/benchmark.h>

#include <map>
#include <string>
#include <vector>

namespace ink::bench {

/// Google Benchmark's own table, and after it each benchmark's least time over the least time of
/// `memcpy/u8/1080p` in the same run: the ratio M by which speeds are judged, since machines are
/// shared and differ.
class RatioReporter : public benchmark::ConsoleReporter {
  public:
    RatioReporter();
    void ReportRuns(const std::vector<Run>& runs) override;
    void Finalize() override;

  private:
    std::vector<std::string> names_;  ///< in the order of their runs
    std::map<std::string, double> least_s_;
};

}  // namespace ink::bench
