#include <benchmark/benchmark.h>
#include <fmt/format.h>

#include <cstddef>
#include <cstdio>
#include <exception>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "bench/benchmarks.h"
#include "bench/results.h"
#include "core/error.h"
#include "core/named.h"
#include "core/parse_number.h"
#include "core/provenance.h"
#include "core/simd.h"

namespace {

using namespace ink;

// What `ink_bench` takes beside Google Benchmark's own flags.
struct Options {
    std::string simd;  ///< the instruction set to force; empty: the best
    int draws = 0;     ///< frames and passes run exactly so often; 0: as the library sees fit
    std::vector<std::string> library_words;  ///< the program's name, our defaults, the user's flags
};

/// What follows `name` in `word`, if it begins with it.
std::optional<std::string> value_of(const std::string& word, std::string_view name) {
    if (word.compare(0, name.size(), name) != 0) return std::nullopt;
    return word.substr(name.size());
}

int parse_count(const std::string& text) {
    const int count = core::parse_number<int>(text).value_or(0);
    if (count < 1) throw core::Error("--draws", "'" + text + "'", "a whole number from 1 on");
    return count;
}

// Splits the command line. Ours: `--simd=NAME`, `--draws=N`.
// The library's flags come with defaults before them, which any flag of the user's overrides:
// 9 repetitions, interleaved at random, 0.1 s each. Throws core::Error for a wrong value of ours.
Options parse_options(int argc, char** argv) {
    Options options;
    options.library_words = {argv[0],
                             "--benchmark_repetitions=9",
                             "--benchmark_enable_random_interleaving=true",
                             "--benchmark_min_time=0.1"};
    for (int i = 1; i < argc; ++i) {
        const std::string word = argv[i];
        if (const auto simd = value_of(word, "--simd=")) {
            options.simd = *simd;
        } else if (const auto draws = value_of(word, "--draws=")) {
            options.draws = parse_count(*draws);
        } else if (value_of(word, "--benchmark_format=").value_or("console") != "console") {
            throw core::Error("ink_bench", word, "console, and --benchmark_out=FILE for JSON");
        } else {
            options.library_words.push_back(word);
        }
    }
    return options;
}

void add_provenance() {
    const auto& p = core::provenance();
    benchmark::AddCustomContext("inkbench_version", p.version);
    benchmark::AddCustomContext("commit", p.commit + (p.dirty ? " (changed)" : ""));
    benchmark::AddCustomContext("compiler", p.compiler);
    benchmark::AddCustomContext("flags", p.flags);
    benchmark::AddCustomContext("cpu", p.cpu);
    benchmark::AddCustomContext("simd", core::current_simd_target().name);
    for (const auto& [name, version] : p.libraries)
        benchmark::AddCustomContext(name, version);
}

core::SimdTarget find_target(const std::string& name) {
    const auto& targets = core::simd_targets();
    if (const core::SimdTarget* found = core::find_named(targets, name)) return *found;
    throw core::Error("--simd",
                      "'" + name + "' does not run here",
                      fmt::format("{}", fmt::join(core::names_of(targets), ", ")));
}

/// Google Benchmark keeps pointers into the words for as long as it runs.
bool start_library(std::vector<std::string>& words) {
    std::vector<char*> pointers;
    for (std::string& word : words)
        pointers.push_back(word.data());
    int count = static_cast<int>(pointers.size());
    pointers.push_back(nullptr);
    benchmark::Initialize(&count, pointers.data());
    return !benchmark::ReportUnrecognizedArguments(count, pointers.data());
}

int run(int argc, char** argv) {
    Options options = parse_options(argc, argv);
    bench::pin_to_cores();
    std::optional<core::ForcedSimdTarget> forced;
    if (!options.simd.empty()) forced.emplace(find_target(options.simd));
    bench::add_filter_benchmarks();
    bench::add_raster_benchmarks(options.draws);
    bench::add_frame_benchmarks(options.draws);
    bench::add_edge_benchmarks();
    bench::add_embree_benchmarks();
    bench::add_truth_benchmarks();
    bench::add_score_benchmarks();
    if (!start_library(options.library_words)) return 2;
    add_provenance();
    bench::Console console;
    const std::size_t matched = benchmark::RunSpecifiedBenchmarks(&console);
    benchmark::Shutdown();
    if (matched == 0) return 2;  // the library has said so
    const auto complaints = console.results().complaints();
    for (const std::string& line : complaints)
        std::fprintf(stderr, "ink_bench: %s\n", line.c_str());
    return complaints.empty() ? 0 : 1;
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
