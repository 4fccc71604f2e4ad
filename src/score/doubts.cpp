#include "score/doubts.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <glm/vec2.hpp>
#include <iterator>
#include <tuple>
#include <vector>

#include "score/drawing.h"

namespace ink::score {
namespace {

/// By how much F grows at another threshold, to be worth a word.
constexpr double kBetterThreshold = 0.02;

constexpr int kFarthestShift_px = 16;

/// Each pixel from where `from(x, y)` says; 0 from outside.
template <class From>
edge::EdgeImage taken_from(const edge::EdgeImage& image, const From& from) {
    edge::EdgeImage result(image.width_px(), image.height_px());
    for (int y = 0; y < image.height_px(); ++y) {
        for (int x = 0; x < image.width_px(); ++x) {
            const glm::ivec2 p = from(x, y);
            if (image.contains(p.x, p.y)) result.at(x, y) = image.at(p.x, p.y);
        }
    }
    return result;
}

edge::EdgeImage flipped(const edge::EdgeImage& image, bool in_x, bool in_y) {
    return taken_from(image, [&](int x, int y) {
        return glm::ivec2(in_x ? image.width_px() - 1 - x : x,
                          in_y ? image.height_px() - 1 - y : y);
    });
}

/// 2 at true pixels, 1 at their neighbours, with a frame as wide as any shift, so that none leaves
/// it.
class NearTruth {
  public:
    explicit NearTruth(const core::Image<std::uint8_t>& labels)
        : near_(labels.width_px() + 2 * kFrame_px, labels.height_px() + 2 * kFrame_px, 0) {
        for (int y = 0; y < labels.height_px(); ++y) {
            for (int x = 0; x < labels.width_px(); ++x) {
                if (labels.at(x, y) == 0) continue;
                for (int i = 0; i < 9; ++i) {
                    std::uint8_t& near =
                        near_.at(x + kFrame_px + i % 3 - 1, y + kFrame_px + i / 3 - 1);
                    near = std::max<std::uint8_t>(near, i == 4 ? 2 : 1);
                }
            }
        }
    }
    [[nodiscard]] int at(int x, int y) const { return near_.at(x + kFrame_px, y + kFrame_px); }

  private:
    static constexpr int kFrame_px = kFarthestShift_px + 1;
    edge::Mask near_;
};

/// The pixels of a drawing's lines, or so many of them: they say as much as all.
std::vector<glm::ivec2> line_pixels(const edge::EdgeImage& image,
                                    int threshold,
                                    const ScoreOptions& options) {
    constexpr std::int64_t kMostPixels = 20'000;
    const Strokes strokes = make_strokes(image, threshold, options);
    const std::int64_t every = strokes.n_thinned / kMostPixels + 1;
    std::vector<glm::ivec2> pixels;
    std::int64_t n = 0;
    for (int y = 0; y < image.height_px(); ++y) {
        strokes.thinned.visit_row(y, [&](int x) {
            if (n++ % every == 0) pixels.emplace_back(x, y);
        });
    }
    return pixels;
}

/// By how much the drawing is to be moved, right and down, so that most of it lies at the truth; of
/// shifts that are as good, the shortest.
glm::ivec2 best_shift(const std::vector<glm::ivec2>& drawn, const NearTruth& near) {
    glm::ivec2 best{0};
    std::tuple<std::int64_t, int> most{-1, 0};
    for (int down_px = -kFarthestShift_px; down_px <= kFarthestShift_px; ++down_px) {
        for (int right_px = -kFarthestShift_px; right_px <= kFarthestShift_px; ++right_px) {
            std::int64_t hits = 0;
            for (const glm::ivec2& p : drawn)
                hits += near.at(p.x + right_px, p.y + down_px);
            const std::tuple found{hits, -(right_px * right_px + down_px * down_px)};
            if (found <= most) continue;
            most = found;
            best = {right_px, down_px};
        }
    }
    return best;
}

/// An empty border around a drawing: as many pixels on all sides.
struct Border {
    int width_px = 0;
    /// The drawing was not made narrower and lower by as much, but smaller by one factor, its
    /// height's.
    bool keeps_shape = false;

    /// How much larger the drawing is without it.
    [[nodiscard]] glm::dvec2 growth(const glm::dvec2& size_px) const {
        const glm::dvec2 both = size_px / (size_px - 2.0 * width_px);
        return keeps_shape ? glm::dvec2(both.y) : both;
    }
};

/// The border without which most of the drawing lies at the truth.
Border best_border(const std::vector<glm::ivec2>& drawn,
                   const NearTruth& near,
                   const glm::ivec2& size_px) {
    constexpr int kWidest_px = 64;
    const int widest_px = std::min(kWidest_px, (std::min(size_px.x, size_px.y) - 1) / 4);
    const glm::dvec2 middle = 0.5 * glm::dvec2(size_px);
    Border best;
    std::int64_t most = -1;
    for (int i = 0; i < 2 * widest_px; ++i) {
        const Border border{i / 2 + 1, i % 2 == 1};
        const glm::dvec2 growth = border.growth(size_px);
        std::int64_t hits = 0;
        for (const glm::ivec2& p : drawn) {
            const glm::dvec2 grown = middle + (glm::dvec2(p) + 0.5 - middle) * growth;
            const bool is_inside =
                grown.x >= 0 && grown.y >= 0 && grown.x < size_px.x && grown.y < size_px.y;
            if (is_inside) hits += near.at(static_cast<int>(grown.x), static_cast<int>(grown.y));
        }
        if (hits <= most) continue;
        most = hits;
        best = border;
    }
    return best;
}

/// The drawing made so large that its border lies outside the image.
edge::EdgeImage without(const Border& border, const edge::EdgeImage& image) {
    const glm::dvec2 size_px(image.width_px(), image.height_px());
    const glm::dvec2 growth = border.growth(size_px);
    return taken_from(image, [&](int x, int y) {
        return glm::ivec2(0.5 * size_px + (glm::dvec2(x + 0.5, y + 0.5) - 0.5 * size_px) / growth);
    });
}

/// Of the pixels that lie `from_frame_px` from the frame, the share that counts as drawn.
double drawn_share_of_ring(const edge::EdgeImage& image, int threshold, int from_frame_px) {
    const int right = image.width_px() - 1 - from_frame_px;
    const int bottom = image.height_px() - 1 - from_frame_px;
    int drawn = 0;
    int all = 0;
    const auto look_at = [&](int x, int y) {
        drawn += image.at(x, y) >= threshold ? 1 : 0;
        ++all;
    };
    for (int x = from_frame_px; x <= right; ++x) {
        look_at(x, from_frame_px);
        look_at(x, bottom);
    }
    for (int y = from_frame_px; y <= bottom; ++y) {
        look_at(from_frame_px, y);
        look_at(right, y);
    }
    return static_cast<double>(drawn) / all;
}

/// What is wrong if pixels beside the frame are all drawn and what they enclose is not, or the
/// other way round; or "".
std::string border_doubt(const edge::EdgeImage& image, int threshold) {
    constexpr double kMostLines = 0.2;  // of what is no line
    const double outside = drawn_share_of_ring(image, threshold, 0);
    if (outside > 0 && outside < 1) return "";
    const int end_px = std::min(image.width_px(), image.height_px()) / 2;
    for (int border_px = 1; border_px < end_px; ++border_px) {
        const double inside = drawn_share_of_ring(image, threshold, border_px);
        if (inside == outside) continue;
        if (std::abs(outside - inside) < 1 - kMostLines) return "";
        return fmt::format("{}a border of {} px around it counts as drawn",
                           outside == 0 ? "all but " : "",
                           border_px);
    }
    return "";
}

/// A threshold, and what an image scores with it.
struct ThresholdScore {
    int threshold = 0;
    double f = 0;
};

/// The best of some thresholds.
ThresholdScore best_threshold(const edge::EdgeImage& image,
                              const ScoringTruth& truth,
                              const ScoreOptions& options) {
    ThresholdScore best;
    for (const int threshold : {128, 96, 160, 64, 192, 32, 224, 16}) {
        ScoreOptions other = options;
        other.threshold = threshold;
        const double f = score(image, truth, other).f();
        if (f > best.f + 0.001) best = {threshold, f};  // of equals that nearest to the middle
    }
    return best;
}

std::string would_score(const ThresholdScore& other) {
    return fmt::format("at threshold {} F would be {:.3f}", other.threshold, other.f);
}

/// "its lines are faint, half of them at most 117 of 255: at threshold 64 F would be 0.995".
std::string threshold_text(const ThresholdScore& better,
                           const edge::EdgeImage& image,
                           const ScoreOptions& options) {
    if (better.threshold > options.threshold)
        return "much of its grey is no line: " + would_score(better);
    std::vector<glm::ivec2> pixels = line_pixels(image, better.threshold, options);
    const auto median = pixels.begin() + std::ssize(pixels) / 2;
    std::nth_element(pixels.begin(), median, pixels.end(), [&](const auto& a, const auto& b) {
        return image.at(a.x, a.y) < image.at(b.x, b.y);
    });
    return fmt::format("its lines are faint, half of them at most {} of 255: {}",
                       image.at(median->x, median->y),
                       would_score(better));
}

/// "8 px to the right and 3 px up".
std::string shift_text(const glm::ivec2& shift) {
    std::vector<std::string> ways;
    if (shift.x != 0)
        ways.push_back(
            fmt::format("{} px to the {}", std::abs(shift.x), shift.x > 0 ? "right" : "left"));
    if (shift.y != 0)
        ways.push_back(fmt::format("{} px {}", std::abs(shift.y), shift.y > 0 ? "down" : "up"));
    return fmt::format("{}", fmt::join(ways, " and "));
}

/// What is wrong with the place of lines, or their strength; or "".
std::string doubt_of_lines(const edge::EdgeImage& image,
                           const ScoringTruth& truth,
                           const ScoreOptions& options,
                           double f) {
    // By how much F grows when a mistake is undone: lines of one object that lie across another's
    // gain a little by any shift.
    constexpr double kBetterFlipped = 0.2;
    constexpr double kBetterPlaced = 0.1;
    constexpr double kLeastPlaced = 0.5;  // parallel lines can be moved onto each other
    // Of a round thing whose lines lie a little inside, any growth finds more.
    constexpr double kLeastBordered = 0.9;
    // Of two mistakes that explain as much, as in symmetric scenes, the first.
    constexpr double kBetterThanOther = 0.05;
    std::string doubt;
    double least_f = 0;
    const auto try_undone = [&](const edge::EdgeImage& undone, double needed_f, std::string said) {
        const double f_undone = score(undone, truth, options).f();
        if (f_undone <= std::max(needed_f, least_f)) return;
        least_f = f_undone + kBetterThanOther;
        doubt = std::move(said);
    };
    if (f < 1 - kBetterPlaced) {
        const double flipped_f = f + kBetterFlipped;
        const double placed_f = std::max(f + kBetterPlaced, kLeastPlaced);
        try_undone(flipped(image, false, true), flipped_f, "it seems to be upside down");
        try_undone(flipped(image, true, false), flipped_f, "it seems to be mirrored");
        try_undone(flipped(image, true, true), flipped_f, "it seems to be turned by 180 degrees");
        const NearTruth near(truth.labels);
        const auto drawn = line_pixels(image, options.threshold, options);
        const glm::ivec2 undo = best_shift(drawn, near);
        try_undone(taken_from(image, [&](int x, int y) { return glm::ivec2(x, y) - undo; }),
                   placed_f,
                   "it seems to be shifted by " + shift_text(-undo));
        const Border border = best_border(drawn, near, {image.width_px(), image.height_px()});
        try_undone(
            without(border, image),
            std::max(f + kBetterFlipped, kLeastBordered),
            fmt::format("it seems to have a border of about {} px around it", border.width_px));
    }
    const ThresholdScore better = best_threshold(image, truth, options);
    if (better.f > std::max(f + kBetterThreshold, least_f))
        return threshold_text(better, image, options);
    if (doubt.empty() && f < 0.1)
        return "its lines are nowhere near the true ones: is the camera right?";
    return doubt;
}

}  // namespace

double drawn_share(const edge::EdgeImage& image, int threshold) {
    if (image.is_empty()) return 0;
    const auto drawn = std::count_if(
        image.data(), image.data() + image.size(), [&](int v) { return v >= threshold; });
    return static_cast<double>(drawn) / static_cast<double>(image.size());
}

std::string doubt_of(const edge::EdgeImage& image,
                     const ScoringTruth& truth,
                     const ScoreOptions& options,
                     double f) {
    if (image.is_empty()) return "";
    const auto [least, most] = std::minmax_element(image.data(), image.data() + image.size());
    if (*least == *most) return "it is blank";
    const double share = drawn_share(image, options.threshold);
    if (share == 0) {
        const ThresholdScore better = best_threshold(image, truth, options);
        return fmt::format("no pixel counts as drawn: the strongest is {}, the threshold {}{}",
                           *most,
                           options.threshold,
                           better.f > f + kBetterThreshold ? "; " + would_score(better) : "");
    }
    const auto* labels = truth.labels.data();
    const bool is_truth_empty =
        std::all_of(labels, labels + truth.labels.size(), [](int v) { return v == 0; });
    const bool may_gain = !is_truth_empty && f < 1 - kBetterThreshold;
    if (may_gain) {
        const std::string border = border_doubt(image, options.threshold);
        if (!border.empty()) return border;
    }
    if (share > kMostDrawn) return fmt::format("{:.0f} % of it count as drawn", 100 * share);
    return may_gain ? doubt_of_lines(image, truth, options, f) : "";
}

}  // namespace ink::score
