#include <benchmark/benchmark.h>

#include <algorithm>
#include <cstdio>
#include <exception>
#include <string>
#include <vector>

#include "bench/benchmarks.h"
#include "bench/ratios.h"
#include "core/provenance.h"

namespace {

void add_provenance() {
    const auto& p = ink::core::provenance();
    benchmark::AddCustomContext("inkbench_version", p.version);
    benchmark::AddCustomContext("commit", p.commit + (p.dirty ? " (changed)" : ""));
    benchmark::AddCustomContext("compiler", p.compiler);
    benchmark::AddCustomContext("flags", p.flags);
    benchmark::AddCustomContext("cpu", p.cpu);
    benchmark::AddCustomContext("simd", p.simd);
    for (const auto& [name, version] : p.libraries)
        benchmark::AddCustomContext(name, version);
}

/// Whether the table goes to the terminal; JSON and CSV must stay as the library writes them.
bool is_table(int argc, char** argv) {
    const std::vector<std::string> words(argv + 1, argv + argc);
    return std::none_of(words.begin(), words.end(), [](const std::string& word) {
        return word == "--benchmark_format=json" || word == "--benchmark_format=csv";
    });
}

int run(int argc, char** argv) {
    const bool with_ratios = is_table(argc, argv);
    ink::bench::add_filter_benchmarks();
    ink::bench::add_raster_benchmarks();
    ink::bench::add_frame_benchmarks();
    ink::bench::add_truth_benchmarks();
    ink::bench::add_score_benchmarks();
    benchmark::Initialize(&argc, argv);
    if (benchmark::ReportUnrecognizedArguments(argc, argv)) return 2;
    add_provenance();
    ink::bench::RatioReporter ratios;
    benchmark::RunSpecifiedBenchmarks(with_ratios ? &ratios : nullptr);
    benchmark::Shutdown();
    return 0;
}

}  // namespace

int main(int argc, char** argv) {
    try {
        return run(argc, argv);
    } catch (const std::exception& error) {
        std::fprintf(stderr, "ink_bench: %s\n", error.what());
        return 2;
    }
}
