#pragma once

#include <benchmark/benchmark.h>

#include <cstdint>
#include <map>
#include <string>
#include <vector>

namespace ink::bench {

/// The repetitions of each benchmark of a run, in the order of registration.
class Results {
  public:
    /// Takes what single repetitions say; aggregates are no repetitions and are left.
    void add(const std::vector<benchmark::BenchmarkReporter::Run>& runs);

    struct Row {
        std::string name;
        std::string hash;             ///< of the result: the label
        std::vector<double> times_s;  ///< an iteration's, one per repetition
        bool is_stable = true;        ///< every repetition had the same hash
        std::string error;            ///< what the benchmark itself found wrong
        [[nodiscard]] double least_s() const;
        [[nodiscard]] double median_s() const;
    };
    /// Keyed by the library's family index.
    [[nodiscard]] const std::map<std::int64_t, Row>& rows() const { return rows_; }

    /// The least time of `memcpy/u8/1080p`, the yardstick M; 0 if it was not run.
    [[nodiscard]] double yardstick_s() const;

    /// One line each for a hash that changed between repetitions or with the number of threads, a
    /// missing one, or an error.
    [[nodiscard]] std::vector<std::string> complaints() const;

  private:
    std::map<std::int64_t, Row> rows_;
};

/// Each benchmark's medians as the library prints them, and after them a table of all: least and
/// median time, the least in M, and the hash of the result.
class TableReporter : public benchmark::ConsoleReporter {
  public:
    TableReporter() : ConsoleReporter(OO_Tabular) {}
    void ReportRuns(const std::vector<Run>& runs) override;
    void Finalize() override;

    [[nodiscard]] const Results& results() const { return results_; }

  private:
    Results results_;
};

/// The library's JSON with two things more, for which it is written at the end of the run: an
/// aggregate `min` per benchmark, and in `min` and `median` the counter `M`, where the yardstick
/// was run.
class JsonReporter : public benchmark::JSONReporter {
  public:
    void ReportRuns(const std::vector<Run>& runs) override;
    void Finalize() override;

    [[nodiscard]] const Results& results() const { return results_; }

  private:
    Results results_;
    std::map<std::int64_t, std::vector<Run>> runs_;
};

}  // namespace ink::bench
