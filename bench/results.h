#pragma once

#include <benchmark/benchmark.h>

#include <cstdint>
#include <map>
#include <string>
#include <vector>

namespace ink::bench {

/// What is wrong with the results of a run's benchmarks, whose hashes are their labels.
class Results {
  public:
    /// Takes what single repetitions say; aggregates are no repetitions and are left.
    void add(const std::vector<benchmark::BenchmarkReporter::Run>& runs);

    /// One line each for a hash that changed between repetitions or with the number of threads, a
    /// missing one, or an error; in the order of registration.
    [[nodiscard]] std::vector<std::string> complaints() const;

  private:
    struct Row {
        std::string name;
        std::string hash;
        bool is_stable = true;  ///< every repetition had the same hash
        std::string error;      ///< what the benchmark itself found wrong
    };
    std::map<std::int64_t, Row> rows_;  ///< keyed by the library's family index
};

/// The library's console, which keeps results as well, and shows of repeated benchmarks the median
/// and the least alone.
class Console : public benchmark::ConsoleReporter {
  public:
    Console() : ConsoleReporter(OO_Tabular) {}
    void ReportRuns(const std::vector<Run>& runs) override;

    [[nodiscard]] const Results& results() const { return results_; }

  private:
    Results results_;
};

}  // namespace ink::bench
