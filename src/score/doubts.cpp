#include "score/doubts.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <tuple>
#include <vector>

#include "score/drawing.h"

namespace ink::score {
namespace {

/// Whole pixels to the right and down.
struct Shift {
    int right_px = 0;
    int down_px = 0;
};

constexpr int kFarthestShift_px = 16;

edge::EdgeImage flipped(const edge::EdgeImage& image, bool in_x, bool in_y) {
    edge::EdgeImage result(image.width_px(), image.height_px());
    for (int y = 0; y < image.height_px(); ++y) {
        for (int x = 0; x < image.width_px(); ++x) {
            result.at(x, y) =
                image.at(in_x ? image.width_px() - 1 - x : x, in_y ? image.height_px() - 1 - y : y);
        }
    }
    return result;
}

edge::EdgeImage moved(const edge::EdgeImage& image, const Shift& by) {
    edge::EdgeImage result(image.width_px(), image.height_px(), 0);
    for (int y = 0; y < image.height_px(); ++y) {
        for (int x = 0; x < image.width_px(); ++x) {
            if (image.contains(x - by.right_px, y - by.down_px))
                result.at(x, y) = image.at(x - by.right_px, y - by.down_px);
        }
    }
    return result;
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

/// By how much the drawing is to be moved so that most of it lies at the truth; of shifts that are
/// as good, the shortest. Looks at so many of its pixels at most: they say as much as all.
Shift best_shift(const edge::EdgeImage& image,
                 const ScoringTruth& truth,
                 const ScoreOptions& options) {
    constexpr std::int64_t kMostPixels = 20'000;
    const Strokes strokes = make_strokes(image, options.threshold, options);
    const std::int64_t every = strokes.n_thinned / kMostPixels + 1;
    std::vector<Shift> drawn;
    std::int64_t n = 0;
    for (int y = 0; y < image.height_px(); ++y) {
        strokes.thinned.visit_row(y, [&](int x) {
            if (n++ % every == 0) drawn.push_back({x, y});
        });
    }
    const NearTruth near(truth.labels);
    Shift best;
    std::tuple<std::int64_t, int> most{-1, 0};
    for (int down_px = -kFarthestShift_px; down_px <= kFarthestShift_px; ++down_px) {
        for (int right_px = -kFarthestShift_px; right_px <= kFarthestShift_px; ++right_px) {
            std::int64_t hits = 0;
            for (const Shift& p : drawn)
                hits += near.at(p.right_px + right_px, p.down_px + down_px);
            const std::tuple found{hits, -(right_px * right_px + down_px * down_px)};
            if (found <= most) continue;
            most = found;
            best = {right_px, down_px};
        }
    }
    return best;
}

/// "8 px to the right and 3 px up".
std::string shift_text(const Shift& shift) {
    std::string text;
    if (shift.right_px != 0) {
        text = fmt::format(
            "{} px to the {}", std::abs(shift.right_px), shift.right_px > 0 ? "right" : "left");
    }
    if (shift.down_px != 0) {
        text += fmt::format("{}{} px {}",
                            text.empty() ? "" : " and ",
                            std::abs(shift.down_px),
                            shift.down_px > 0 ? "down" : "up");
    }
    return text;
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
        return fmt::format("no pixel counts as drawn: the strongest is {}, the threshold {}",
                           *most,
                           options.threshold);
    }
    if (share > kMostDrawn) return fmt::format("{:.0f} % of it count as drawn", 100 * share);
    const auto* labels = truth.labels.data();
    if (std::all_of(labels, labels + truth.labels.size(), [](int v) { return v == 0; })) return "";

    // By how much F grows when a mistake is undone: lines of one object that lie across another's
    // gain a little by any shift.
    constexpr double kBetterFlipped = 0.2;
    constexpr double kBetterShifted = 0.1;
    constexpr double kLeastShifted = 0.5;  // parallel lines can be moved onto each other
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
    if (f < 1 - kBetterShifted) {
        try_undone(flipped(image, false, true), f + kBetterFlipped, "it seems to be upside down");
        try_undone(flipped(image, true, false), f + kBetterFlipped, "it seems to be mirrored");
        try_undone(
            flipped(image, true, true), f + kBetterFlipped, "it seems to be turned by 180 degrees");
        const Shift undo = best_shift(image, truth, options);
        try_undone(moved(image, undo),
                   std::max(f + kBetterShifted, kLeastShifted),
                   "it seems to be shifted by " + shift_text({-undo.right_px, -undo.down_px}));
    }
    if (doubt.empty() && f < 0.1)
        return "its lines are nowhere near the true ones: is the camera right?";
    return doubt;
}

}  // namespace ink::score
