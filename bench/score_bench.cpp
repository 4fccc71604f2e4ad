#include <benchmark/benchmark.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <random>

#include "bench/bench_scene.h"
#include "bench/benchmarks.h"
#include "core/hash.h"
#include "score/score.h"

namespace ink::bench {
namespace {

constexpr int kTruthGoal_px = 36'000;
constexpr int kBand_px = 6;

/// A drawing by an unsteady hand, and what it should have been.
struct Drawing {
    core::Image<std::uint8_t> truth{kWidth_px, kHeight_px};
    edge::EdgeImage strength{kWidth_px, kHeight_px};
    int truth_px = 0;
};

void set(core::Image<std::uint8_t>& image, double x, double y, int value) {
    const int column = static_cast<int>(std::floor(x));
    const int line = static_cast<int>(std::floor(y));
    if (image.contains(column, line)) image.at(column, line) = static_cast<std::uint8_t>(value);
}

/// One circle: true in the truth, two pixels wide, shaky and with gaps in the drawing.
void add_circle(Drawing& drawing, std::mt19937& random) {
    const auto below = [&](int end) {
        return static_cast<int>(random() % static_cast<unsigned>(end));
    };
    const double radius = 20 + below(200);
    const double x = below(kWidth_px);
    const double y = below(kHeight_px);
    const int steps = static_cast<int>(radius * 8);
    const int line_class = 1 + below(3);
    for (int step = 0; step < steps; ++step) {
        const double turn = 2 * std::numbers::pi * step / steps;
        const double u = x + radius * std::cos(turn);
        const double v = y + radius * std::sin(turn);
        set(drawing.truth, u, v, line_class);
        if (below(100) < 3) step += below(20);
        const double shake = below(300) / 100.0 - 1.5;
        set(drawing.strength, u + shake, v, 255);
        set(drawing.strength, u + shake + 1, v, 200);
    }
}

/// Circles until the truth, thinned and without its band, has as many pixels as the name says.
Drawing make_drawing(const score::ScoreOptions& options) {
    std::mt19937 random(36);
    Drawing drawing;
    while (drawing.truth_px < kTruthGoal_px) {
        add_circle(drawing, random);
        const auto ready = score::prepare_truth(drawing.truth, options, true);
        const auto* pixels = ready.labels.data();
        drawing.truth_px = static_cast<int>(std::count_if(
            pixels, pixels + ready.labels.size(), [](int label) { return label != 0; }));
    }
    return drawing;
}

score::ScoreOptions options_of_compare() {
    score::ScoreOptions options;
    options.band_px = kBand_px;
    return options;
}

std::string hash_of(const score::Score& s) {
    return core::Hasher()
        .value(s.k)
        .value(s.n_pred)
        .value(s.n_truth)
        .value(s.surplus)
        .value(s.off_line)
        .value(s.lost)
        .value(s.missing)
        .hex();
}

void describe(benchmark::State& state, const score::Score& result) {
    state.SetLabel(hash_of(result));
    state.counters["k"] = static_cast<double>(result.k);
    state.counters["n_truth"] = static_cast<double>(result.n_truth);
}

/// A method's picture against a truth that is ready, as `compare` scores every cell.
void time_score(benchmark::State& state) {
    const score::ScoreOptions options = options_of_compare();
    const Drawing drawing = make_drawing(options);
    const score::ScoringTruth truth = score::prepare_truth(drawing.truth, options, true);
    score::Score result;
    for (auto _ : state)
        result = score::score(drawing.strength, truth, options);
    describe(state, result);
}

/// The same with the truth made ready each time.
void time_prepare_and_score(benchmark::State& state) {
    const score::ScoreOptions options = options_of_compare();
    const Drawing drawing = make_drawing(options);
    score::Score result;
    for (auto _ : state) {
        const score::ScoringTruth truth = score::prepare_truth(drawing.truth, options, true);
        result = score::score(drawing.strength, truth, options);
    }
    describe(state, result);
}

/// All 99 thresholds of a curve.
void time_curve(benchmark::State& state) {
    const score::ScoreOptions options = options_of_compare();
    const Drawing drawing = make_drawing(options);
    const score::ScoringTruth truth = score::prepare_truth(drawing.truth, options, true);
    double ap = 0;
    for (auto _ : state)
        ap = score::average_precision(score::score_curve(drawing.strength, truth, options));
    state.SetLabel(core::Hasher().value(ap).hex());
}

}  // namespace

void add_score_benchmarks() {
    const auto add = [](const char* name, void (*run)(benchmark::State&)) {
        benchmark::RegisterBenchmark(name, run)->Unit(benchmark::kMillisecond);
    };
    add("score/36k", time_score);
    add("score/36k/prepare", time_prepare_and_score);
    add("score/36k/curve", time_curve);
}

}  // namespace ink::bench
