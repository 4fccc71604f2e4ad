#include <benchmark/benchmark.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <random>
#include <vector>

#include "bench/benchmarks.h"
#include "core/hash.h"
#include "score/drawing.h"
#include "score/matching.h"
#include "score/score.h"

namespace ink::bench {
namespace {

constexpr int kTruthGoal_px = 36'000;
constexpr int kBand_px = 6;

/// A drawing by an unsteady hand, and what it should have been.
struct Drawing {
    core::Image<std::uint8_t> truth{kWidth_px, kHeight_px};
    edge::EdgeImage edge_response{kWidth_px, kHeight_px};
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
        set(drawing.edge_response, u + shake, v, 255);
        set(drawing.edge_response, u + shake + 1, v, 200);
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
        .value(s.unmatched_duplicates)
        .value(s.false_positives)
        .value(s.unmatched_truth)
        .value(s.false_negatives)
        .hex();
}

void describe(benchmark::State& state, const score::Score& result) {
    state.SetLabel(hash_of(result));
    state.counters["k"] = static_cast<double>(result.k);
    state.counters["n_truth"] = static_cast<double>(result.n_truth);
}

/// A drawing with its truth made ready, for the stages one by one.
struct Stage {
    score::ScoreOptions options = options_of_compare();
    Drawing drawing = make_drawing(options);
    score::ScoringTruth truth = score::prepare_truth(drawing.truth, options, true);
    score::TruthLists lists = score::list_truth(truth, options);
    score::Strokes strokes = score::make_strokes(drawing.edge_response, options.threshold, options);
    score::PixelList drawn = score::counted_pixels(strokes.thinned, lists);
};

/// A method's image against a truth that is ready, as `compare` scores every cell.
void time_score(benchmark::State& state) {
    const Stage stage;
    score::Score result;
    for (auto _ : state)
        result = score::score(stage.drawing.edge_response, stage.truth, stage.options);
    describe(state, result);
}

/// Of every pixel's place.
std::string hash_of(const score::PixelList& list) {
    core::Hasher hasher;
    hasher.value(list.size());
    for (int y = 0; y <= list.height_px(); ++y)
        hasher.value(list.row_begin(y));
    for (std::size_t i = 0; i < list.size(); ++i)
        hasher.value(list.x(i));
    return hasher.hex();
}

void time_thin(benchmark::State& state) {
    Stage stage;
    for (auto _ : state) {
        stage.strokes = score::make_strokes(
            stage.drawing.edge_response, stage.options.threshold, stage.options);
    }
    state.SetLabel(core::image_hash(stage.strokes.thinned.bytes()));
}

/// Band, ignore and the list of what is left; the copy of the mask is part of it.
void time_band(benchmark::State& state) {
    Stage stage;
    for (auto _ : state)
        stage.drawn = score::counted_pixels(stage.strokes.thinned, stage.lists);
    state.SetLabel(hash_of(stage.drawn));
}

void time_lists(benchmark::State& state) {
    Stage stage;
    for (auto _ : state)
        stage.lists = score::list_truth(stage.truth, stage.options);
    state.SetLabel(hash_of(stage.lists.truth));
}

void time_matching(benchmark::State& state) {
    const Stage stage;
    score::MatchCounts counts;
    for (auto _ : state)
        counts = score::match_pixels(stage.drawn, stage.lists.truth, stage.lists.disk);
    state.SetLabel(core::Hasher().value(counts.k).hex());
}

}  // namespace

void add_score_benchmarks() {
    add("score/36k", time_score);
    add("score/36k/thin", time_thin);
    add("score/36k/band", time_band);
    add("score/36k/lists", time_lists);
    add("score/36k/matching", time_matching);
}

}  // namespace ink::bench
