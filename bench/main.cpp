#include <benchmark/benchmark.h>

#include <cstddef>
#include <cstdio>
#include <exception>
#include <optional>
#include <string>
#include <vector>

#include "bench/bench_scene.h"
#include "bench/benchmarks.h"
#include "bench/cores.h"
#include "bench/options.h"
#include "bench/results.h"
#include "core/error.h"
#include "core/provenance.h"
#include "core/simd.h"

namespace {

using namespace ink;

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
    std::string known;
    for (const core::SimdTarget& target : core::simd_targets()) {
        if (target.name == name) return target;
        known += (known.empty() ? "" : ", ") + target.name;
    }
    throw core::Error("--simd", "'" + name + "' does not run here", known);
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
    bench::Options options = bench::parse_options(argc, argv);
    bench::pin_to_cores();
    std::optional<core::ForcedSimdTarget> forced;
    if (!options.simd.empty()) forced.emplace(find_target(options.simd));
    for (const std::string& model : options.models)
        bench::add_model(model);
    bench::add_filter_benchmarks();
    bench::add_raster_benchmarks(options.draws);
    bench::add_frame_benchmarks(options.draws);
    bench::add_edge_benchmarks();
    bench::add_embree_benchmarks();
    bench::add_truth_benchmarks();
    bench::add_score_benchmarks();
    if (!start_library(options.library_words)) return 2;
    add_provenance();
    bench::TableReporter table;
    bench::JsonReporter json;
    bench::JsonReporter file;
    benchmark::BenchmarkReporter* display = nullptr;  // the library's own
    if (options.format == "console") display = &table;
    if (options.format == "json") display = &json;
    const std::size_t matched =
        benchmark::RunSpecifiedBenchmarks(display, options.has_json_file ? &file : nullptr);
    benchmark::Shutdown();
    if (matched == 0) return 2;  // the library has said so
    const bench::Results& results = display == &json ? json.results() : table.results();
    const auto complaints = results.complaints();
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
