// The laws of the score hold for any two images.

#include "score/score.h"

#include <array>

#include "score/drawing.h"
#include "score/pixel_list.h"
#include "tests/fuzz/fuzz.h"
#include "tests/score/images.h"

namespace ink::fuzz {
namespace {

using score::CurveCount;
using score::Score;
using score::ScoreOptions;
using score::ScoringTruth;

struct Pair {
    Image drawn;   ///< edge responses
    Image labels;  ///< 0..7
};

/// A byte a pixel: the response in the lower half, the label in the upper one.
Pair images(Feed& feed) {
    const int width_px = feed.whole(1, 70);
    const int height_px = feed.whole(1, 24);
    Pair pair{Image(width_px, height_px), Image(width_px, height_px)};
    for (std::size_t i = 0; i < pair.drawn.size() && !feed.is_empty(); ++i) {
        const int both = feed.whole(0, 255);
        pair.drawn.data()[i] = static_cast<std::uint8_t>(both % 16 * 17);
        pair.labels.data()[i] = static_cast<std::uint8_t>(both < 128 ? both / 16 : 0);
    }
    return pair;
}

ScoreOptions some_options(Feed& feed) {
    constexpr std::array kTolerances_px{0.5, 1.0, 1.5, 2.0, 3.0, 8.0};
    ScoreOptions options;
    options.tolerance_px =
        kTolerances_px[static_cast<std::size_t>(feed.whole(0, kTolerances_px.size() - 1))];
    options.threshold = feed.whole(1, 255);
    options.thin = feed.flag();
    options.band_px = feed.whole(0, 3);
    if (feed.flag()) options.ignore_label = 7;
    return options;
}

bool is_same(const Score& a, const CurveCount& b) {
    return a.k == b.k && a.n_pred == b.n_pred && a.n_truth == b.n_truth;
}

bool is_same(const Score& a, const Score& b) {
    return is_same(a, CurveCount{b.k, b.n_pred, b.n_truth}) &&
           a.unmatched_duplicates == b.unmatched_duplicates &&
           a.false_positives == b.false_positives && a.unmatched_truth == b.unmatched_truth &&
           a.false_negatives == b.false_negatives;
}

void check_counts(const Score& s) {
    for (const std::int64_t count :
         {s.k, s.unmatched_duplicates, s.false_positives, s.unmatched_truth, s.false_negatives}) {
        expect(count >= 0, "no count is below 0");
    }
    expect(s.n_pred == s.k + s.unmatched_duplicates + s.false_positives,
           "each drawn pixel is counted once");
    expect(s.n_truth == s.k + s.unmatched_truth + s.false_negatives,
           "each true pixel is counted once");
    expect(s.f() >= 0 && s.f() <= 1, "F lies in 0..1");
    expect(s.precision().has_value() == (s.n_pred > 0), "there is a precision of drawn pixels");
    expect(s.recall().has_value() == (s.n_truth > 0), "there is a recall of true pixels");
    std::int64_t k = 0;
    std::int64_t n_truth = 0;
    for (const score::ClassCount& c : s.classes) {
        expect(c.k >= 0 && c.k <= c.n_truth && c.k <= s.n_pred, "a class matches what it has");
        expect(c.k <= s.k, "a class alone matches no more than all classes");
        k += c.k;
        n_truth += c.n_truth;
    }
    expect(s.classes.empty() || (n_truth == s.n_truth && k >= s.k), "classes add up");
}

/// 255 where a label is, 0 elsewhere.
Image as_drawn(const Image& labels) {
    Image drawn = labels;
    for (std::size_t i = 0; i < drawn.size(); ++i)
        drawn.data()[i] = labels.data()[i] != 0 ? 255 : 0;
    return drawn;
}

/// What holds without thinning, which has a handedness.
void check_symmetry(const Pair& pair, ScoreOptions options) {
    options.thin = false;
    options.ignore_label = std::nullopt;
    const auto scored = [&](const Image& drawn, const Image& labels) {
        return score::score(drawn, score::prepare_truth(labels, options, false), options);
    };
    const Score there = scored(pair.drawn, pair.labels);
    expect(is_same(there, scored(transposed(pair.drawn), transposed(pair.labels))),
           "transposed images have the same score");
    Image above = pair.drawn;
    for (std::size_t i = 0; i < above.size(); ++i)
        above.data()[i] = above.data()[i] >= options.threshold ? 1 : 0;
    const Score back = scored(as_drawn(pair.labels), above);
    expect(there.k == back.k && there.n_pred == back.n_truth && there.n_truth == back.n_pred &&
               there.false_positives == back.false_negatives &&
               there.unmatched_duplicates == back.unmatched_truth,
           "swapped images swap precision and recall");
}

/// A pixel drawn where only the ignored is in reach counts for nothing.
void check_ignored(const Pair& pair, const ScoringTruth& truth, ScoreOptions options) {
    options.thin = false;
    const score::TruthLists lists = score::list_truth(truth, options);
    const Image everywhere(pair.drawn.width_px(), pair.drawn.height_px(), 255);
    const score::PixelList all(everywhere);
    const auto near_ignored = score::within_reach(all, lists.ignore, lists.disk);
    const auto near_truth = score::within_reach(all, lists.truth, lists.disk);
    Image more = pair.drawn;
    for (std::size_t i = 0; i < more.size(); ++i) {
        if (near_ignored[i] != 0 && near_truth[i] == 0) more.data()[i] = 255;
    }
    expect(is_same(score::score(more, truth, options), score::score(pair.drawn, truth, options)),
           "pixels drawn over the ignored change nothing");
}

/// The functions that score many times at once say what score() says.
void check_sweeps(const Pair& pair, const ScoringTruth& truth, ScoreOptions options) {
    constexpr std::array kTolerances_px{0.5, 1.0, 2.0, 3.0};
    std::int64_t k = 0;
    for (const double tolerance_px : kTolerances_px) {
        ScoreOptions at = options;
        at.tolerance_px = tolerance_px;
        const std::int64_t more = score::score(pair.drawn, truth, at).k;
        expect(options.ignore_label || more >= k, "a wider tolerance loses no match");
        k = more;
    }
    const auto curve = score::score_curve(pair.drawn, truth, options);
    for (const int percent : {1, 37, 50, 99}) {
        ScoreOptions at = options;
        at.threshold = (255 * percent + 99) / 100;
        expect(is_same(score::score(pair.drawn, truth, at),
                       curve[static_cast<std::size_t>(percent) - 1]),
               "the curve equals the score at each threshold");
    }
    const double ap = score::average_precision(curve);
    expect(ap >= 0 && ap <= 1 + 1e-12, "the average precision lies in 0..1");
}

}  // namespace

void check_score(Bytes bytes) {
    Feed feed(bytes);
    const ScoreOptions options = some_options(feed);
    const Pair pair = images(feed);
    const ScoringTruth truth = score::prepare_truth(pair.labels, options, false);
    check_counts(score::score(pair.drawn, truth, options));
    check_symmetry(pair, options);
    check_ignored(pair, truth, options);
    check_sweeps(pair, truth, options);

    const ScoringTruth stored = score::prepare_truth(pair.labels, options, true);
    const Score perfect = score::score(as_drawn(stored.labels), stored, options);
    expect(perfect.f() == 1 && perfect.k == perfect.n_truth && perfect.k == perfect.n_pred,
           "a stored truth scores 1 against itself");
    const Score nothing =
        score::score(Image(pair.drawn.width_px(), pair.drawn.height_px()), stored, options);
    expect(nothing.k == 0 && nothing.f() == (stored.labels_in_use.empty() ? 1 : 0),
           "an empty drawing scores 0 where there is truth");
}

}  // namespace ink::fuzz
