#include "score/offset.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace ink::score {
namespace {

constexpr double kReach_px = 2;

// Ends that should be one point may differ in the last bit.
constexpr double kSame_px = 1e-9;

/// A curve as a pixel's centre sees it.
struct Candidate {
    double distance_px = 0;
    double across_px = 0;  ///< distance from the line through the curve
    CurveOffset offset;
};

/// A curve with its direction worked out once.
class Line {
  public:
    explicit Line(const truth::Curve& curve)
        : x_(curve.begin.x_px),
          y_(curve.begin.y_px),
          length_px_(std::hypot(curve.end.x_px - x_, curve.end.y_px - y_)),
          label_(static_cast<std::uint8_t>(curve.line_class)) {
        if (length_px_ == 0) return;
        along_x_ = (curve.end.x_px - x_) / length_px_;
        along_y_ = (curve.end.y_px - y_) / length_px_;
        // To the right of the direction, y down.
        normal_x_ = -along_y_;
        normal_y_ = along_x_;
        const bool is_steep = std::abs(along_y_) > std::abs(along_x_);
        const double sense =
            curve.empty_side != 0 ? curve.empty_side : (is_steep ? normal_x_ : normal_y_);
        if (sense < 0) {
            normal_x_ = -normal_x_;
            normal_y_ = -normal_y_;
        }
    }

    [[nodiscard]] double length_px() const { return length_px_; }

    [[nodiscard]] Candidate seen_from(double x, double y) const {
        const double along = (x - x_) * along_x_ + (y - y_) * along_y_;
        const double across = (x - x_) * normal_x_ + (y - y_) * normal_y_;
        const double beyond = std::max({0.0, -along, along - length_px_});
        Candidate candidate;
        candidate.distance_px = std::hypot(beyond, across);
        candidate.across_px = std::abs(across);
        candidate.offset.offset_px = std::copysign(candidate.distance_px, across);
        candidate.offset.normal_x = normal_x_;
        candidate.offset.normal_y = normal_y_;
        candidate.offset.label = label_;
        candidate.offset.is_beyond_end = beyond > candidate.across_px + kSame_px;
        return candidate;
    }

  private:
    double x_, y_;
    double length_px_;
    double along_x_ = 0, along_y_ = 0;
    double normal_x_ = 0, normal_y_ = 0;
    std::uint8_t label_;
};

/// First and last of the pixels 0..count-1 whose centres lie in [low, high]; none if first > last.
std::pair<int, int> pixels_between(double low, double high, int count) {
    const double last = count - 1.0;
    return {static_cast<int>(std::ceil(std::clamp(low - 0.5, 0.0, last + 1))),
            static_cast<int>(std::floor(std::clamp(high - 0.5, -1.0, last)))};
}

/// A stretch of the row of centres at `y` that holds all that the curve reaches there.
std::pair<double, double> reach_in_row(const truth::Curve& curve, double y) {
    const auto [y0, y1] = std::minmax(curve.begin.y_px, curve.end.y_px);
    double u = curve.begin.x_px, v = curve.end.x_px;
    if (y0 != y1) {
        const auto x_at = [&](double at) {
            const double s = (at - curve.begin.y_px) / (curve.end.y_px - curve.begin.y_px);
            return curve.begin.x_px + s * (curve.end.x_px - curve.begin.x_px);
        };
        u = x_at(std::clamp(y - kReach_px, y0, y1));
        v = x_at(std::clamp(y + kReach_px, y0, y1));
    }
    return {std::min(u, v) - kReach_px, std::max(u, v) + kReach_px};
}

/// Keeps for each pixel the best of the curves seen so far.
class Finder {
  public:
    Finder(int width_px, int height_px)
        : result_{core::Image<std::uint32_t>(width_px, height_px), {}} {}

    void add(const truth::Curve& curve) {
        const Line line(curve);
        if (line.length_px() == 0 || result_.index.is_empty()) return;
        const auto [y0, y1] = std::minmax(curve.begin.y_px, curve.end.y_px);
        const auto [first, last] =
            pixels_between(y0 - kReach_px, y1 + kReach_px, result_.index.height_px());
        for (int y = first; y <= last; ++y)
            add_row(curve, line, y);
    }
    [[nodiscard]] NearestCurves take_result() { return std::move(result_); }

  private:
    /// The pixels of row y that the curve reaches.
    void add_row(const truth::Curve& curve, const Line& line, int y) {
        const auto [low, high] = reach_in_row(curve, y + 0.5);
        const auto [first, last] = pixels_between(low, high, result_.index.width_px());
        for (int x = first; x <= last; ++x) {
            const Candidate candidate = line.seen_from(x + 0.5, y + 0.5);
            if (candidate.distance_px <= kReach_px) offer(x, y, candidate);
        }
    }

    void offer(int x, int y, const Candidate& candidate) {
        std::uint32_t& index = result_.index.at(x, y);
        if (index == 0) {
            result_.offsets.push_back(candidate.offset);
            across_px_.push_back(candidate.across_px);
            index = static_cast<std::uint32_t>(result_.offsets.size());
            return;
        }
        CurveOffset& known = result_.offsets[index - 1];
        const double nearer_px = std::abs(known.offset_px) - candidate.distance_px;
        const double further_px = candidate.across_px - across_px_[index - 1];
        const bool is_better = std::abs(nearer_px) > kSame_px ? nearer_px > 0
                               : std::abs(further_px) > kSame_px
                                   ? further_px > 0
                                   : candidate.offset.label < known.label;
        if (!is_better) return;
        known = candidate.offset;
        across_px_[index - 1] = candidate.across_px;
    }

    NearestCurves result_;
    std::vector<double> across_px_;  ///< of each offset
};

/// The sums of which a least-squares translation is solved.
struct ShiftSums {
    double xx = 0, xy = 0, yy = 0;  ///< of products of normals
    double x = 0, y = 0;            ///< of normals times offset

    void add(const CurveOffset& o) {
        xx += o.normal_x * o.normal_x;
        xy += o.normal_x * o.normal_y;
        yy += o.normal_y * o.normal_y;
        x += o.normal_x * o.offset_px;
        y += o.normal_y * o.offset_px;
    }
    [[nodiscard]] std::optional<Shift> solve() const {
        // 1/4 if lines run in all directions alike, 0 if in one.
        constexpr double kLeastSpread = 0.01;
        const double determinant = xx * yy - xy * xy;
        if (determinant <= kLeastSpread * (xx + yy) * (xx + yy)) return std::nullopt;
        return Shift{(yy * x - xy * y) / determinant, (xx * y - xy * x) / determinant};
    }
};

}  // namespace

NearestCurves find_nearest_curves(std::span<const truth::Curve> curves,
                                  int width_px,
                                  int height_px) {
    Finder finder(width_px, height_px);
    for (const truth::Curve& curve : curves)
        finder.add(curve);
    return finder.take_result();
}

Offsets measure_offsets(const PixelList& drawn, const NearestCurves& curves) {
    Offsets offsets;
    ShiftSums shift;
    drawn.visit([&](int x, int y) {
        const CurveOffset* found = curves.find(x, y);
        if (found == nullptr || found->is_beyond_end) return;
        offsets.all.add(found->offset_px);
        offsets.classes[found->label & 7U].add(found->offset_px);
        shift.add(*found);
    });
    offsets.shift = shift.solve();
    return offsets;
}

}  // namespace ink::score
