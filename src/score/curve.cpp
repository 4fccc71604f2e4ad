#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <utility>
#include <vector>

#include "edge/bit_mask.h"
#include "edge/set_pixels.h"
#include "edge/thin.h"
#include "score/drawing.h"
#include "score/matching.h"
#include "score/score.h"

namespace ink::score {
namespace {

/// The drawn pixels of an image, the strongest first.
class ByResponse {
  public:
    struct Place {
        int x;
        int y;
    };

    explicit ByResponse(const edge::EdgeImage& image) {
        edge::visit_set_pixels(image,
                               [&](int x, int y) { ++count_[std::size_t{image.row(y)[x]}]; });
        for (std::size_t s = 255; s > 0; --s)
            count_[s] += count_[s + 1];
        places_.resize(count_[1]);
        std::array<std::size_t, 257> next = count_;
        edge::visit_set_pixels(image, [&](int x, int y) {
            places_[next[std::size_t{image.row(y)[x]} + 1]++] = {x, y};
        });
    }

    /// How many have at least this edge response, 1..255: that many from the first on.
    [[nodiscard]] std::size_t count(int edge_response) const {
        return count_[static_cast<std::size_t>(edge_response)];
    }
    [[nodiscard]] const Place& at(std::size_t i) const { return places_[i]; }

  private:
    std::array<std::size_t, 257> count_{};
    std::vector<Place> places_;
};

/// Counts one mask after the other against one truth.
class CurveCounter {
  public:
    explicit CurveCounter(const TruthLists& lists)
        : lists_(lists), matcher_(lists.truth.width_px(), lists.truth.height_px(), lists.disk) {
        matcher_.set_right(lists.truth);
    }

    /// `drawn` is thin, and changed by this.
    [[nodiscard]] CurveCount count(edge::BitMask& drawn) {
        const std::span<std::uint64_t> words = drawn.words();
        const std::span<const std::uint64_t> countable = lists_.countable.words();
        for (std::size_t i = 0; i < words.size(); ++i)
            words[i] &= countable[i];
        matcher_.set_left(words);
        const std::int64_t k = matcher_.match();
        return {k, matcher_.left_size(), matcher_.right_size()};
    }

  private:
    const TruthLists& lists_;
    BitMatcher matcher_;
};

}  // namespace

CurveCount& CurveCount::operator+=(const CurveCount& other) {
    k += other.k;
    n_pred += other.n_pred;
    n_truth += other.n_truth;
    return *this;
}

double CurveCount::f() const {
    const std::int64_t all = n_pred + n_truth;
    return all > 0 ? 2.0 * static_cast<double>(k) / static_cast<double>(all) : 1.0;
}

std::array<CurveCount, 99> score_curve(const edge::EdgeImage& prediction,
                                       const ScoringTruth& truth,
                                       const ScoreOptions& options) {
    return score_curve_lists(prediction, checked_lists(prediction, truth, options), options);
}

std::array<CurveCount, 99> score_curve_lists(const edge::EdgeImage& prediction,
                                             const TruthLists& lists,
                                             const ScoreOptions& options) {
    const ByResponse pixels(prediction);
    std::array<CurveCount, 99> curve;
    CurveCounter counter(lists);
    // From the highest threshold down, each mask is the one before and some pixels more.
    edge::BitMask drawn(prediction.width_px(), prediction.height_px());
    std::size_t n_drawn = 0;
    for (std::size_t i = curve.size(); i-- > 0;) {
        const int threshold = edge::response_at_percent(static_cast<int>(i) + 1);
        const std::size_t n_now = pixels.count(threshold);
        if (n_now == n_drawn && i + 1 < curve.size()) {
            curve[i] = curve[i + 1];
            continue;
        }
        for (; n_drawn < n_now; ++n_drawn)
            drawn.set(pixels.at(n_drawn).x, pixels.at(n_drawn).y);
        edge::BitMask thinned = drawn;
        if (options.thin) edge::thin(thinned);
        curve[i] = counter.count(thinned);
    }
    return curve;
}

double average_precision(const std::array<CurveCount, 99>& curve) {
    const auto n_truth = static_cast<double>(curve[0].n_truth);
    if (n_truth == 0) {
        const bool fires = std::any_of(
            curve.begin(), curve.end(), [](const CurveCount& c) { return c.n_pred > 0; });
        return fires ? 0 : 1;
    }
    std::vector<std::pair<double, double>> points;  // recall, precision
    for (const CurveCount& c : curve) {
        if (c.n_pred == 0) continue;
        const auto k = static_cast<double>(c.k);
        points.emplace_back(k / n_truth, k / static_cast<double>(c.n_pred));
    }
    std::sort(points.begin(), points.end());
    double area = 0;
    double best_precision = 0;
    for (std::size_t i = points.size(); i-- > 0;) {
        best_precision = std::max(best_precision, points[i].second);
        const double recall_below = i > 0 ? points[i - 1].first : 0;
        area += (points[i].first - recall_below) * best_precision;
    }
    return area;
}

}  // namespace ink::score
