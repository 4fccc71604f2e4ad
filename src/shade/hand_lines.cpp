#include "shade/hand_lines.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/trigonometric.hpp>

#include "core/hash.h"

namespace ink::shade {
namespace {

constexpr double kStep_samples = 0.5;  ///< from one dab of the pen to the next
constexpr int kCornerReach_px = 4;
constexpr double kThinnestEnd = 0.35;  ///< of the width, where a stroke begins and ends

/// What of a stroke a wave moves.
enum class Wave : std::uint32_t { x, y, width, start, end };

/// Smooth noise in -1 .. 1 along a stroke.
class Noise {
  public:
    Noise(std::uint64_t seed, std::size_t stroke, int pass) {
        key_ = core::Hasher().value(seed).value(std::uint64_t{stroke}).value(pass).result();
    }

    /// Value noise: a hash at whole numbers, cubic ramps between.
    [[nodiscard]] double at(Wave wave, double t) const {
        const double floor = std::floor(t);
        const auto cell = static_cast<std::int64_t>(floor);
        const double s = t - floor;
        const double ramp = s * s * (3 - 2 * s);
        return (1 - ramp) * value(wave, cell) + ramp * value(wave, cell + 1);
    }

  private:
    [[nodiscard]] double value(Wave wave, std::int64_t cell) const {
        const std::uint64_t bits = core::Hasher().value(key_).value(wave).value(cell).result();
        return static_cast<double>(bits >> 11) * 0x1p-52 - 1;
    }
    std::uint64_t key_ = 0;
};

/// A line by its length.
class Path {
  public:
    explicit Path(const LineChain& chain) : points_(chain.points_px) {
        if (chain.is_closed) points_.push_back(points_.front());
        lengths_.push_back(0);
        for (std::size_t i = 1; i < points_.size(); ++i)
            lengths_.push_back(lengths_.back() + glm::distance(points_[i - 1], points_[i]));
    }
    [[nodiscard]] double length() const { return lengths_.back(); }

    /// The point `t` along; beyond the ends straight on, in the direction of the last few points.
    [[nodiscard]] glm::dvec2 at(double t) const {
        if (t < 0) return points_.front() + t * direction(0, std::min(kReach, points_.size() - 1));
        if (t > length()) {
            const std::size_t last = points_.size() - 1;
            return points_.back() + (t - length()) * direction(last - std::min(kReach, last), last);
        }
        const auto found = std::upper_bound(lengths_.begin(), lengths_.end(), t);
        const auto i =
            std::min(static_cast<std::size_t>(found - lengths_.begin()), points_.size() - 1);
        const double span = lengths_[i] - lengths_[i - 1];
        const double share = span > 0 ? (t - lengths_[i - 1]) / span : 0;
        return points_[i - 1] + share * (points_[i] - points_[i - 1]);
    }

  private:
    static constexpr std::size_t kReach = 6;

    [[nodiscard]] glm::dvec2 direction(std::size_t from, std::size_t to) const {
        const glm::dvec2 way = points_[to] - points_[from];
        const double length = glm::length(way);
        return length > 0 ? way / length : glm::dvec2(0);
    }

    std::vector<glm::dvec2> points_;
    std::vector<double> lengths_;
};

void draw_disc(const glm::dvec2& center, double radius, core::Image<std::uint8_t>& image) {
    const auto first = [](double v) { return static_cast<int>(std::ceil(v - 0.5)); };
    const int y1 = std::min(first(center.y + radius), image.height_px() - 1);
    for (int y = std::max(first(center.y - radius), 0); y <= y1; ++y) {
        const double dy = y + 0.5 - center.y;
        const double rest = radius * radius - dy * dy;
        if (rest < 0) continue;
        const double half = std::sqrt(rest);
        const int x1 =
            std::min(static_cast<int>(std::floor(center.x + half - 0.5)), image.width_px() - 1);
        for (int x = std::max(first(center.x - half), 0); x <= x1; ++x)
            image.row(y)[x] = 255;
    }
}

/// Draws one stroke; all lengths in samples.
void draw_stroke(const Path& path,
                 const HandParams& params,
                 const HandPen& pen,
                 const Noise& noise,
                 core::Image<std::uint8_t>& image) {
    const double px = pen.samples_per_px;
    const double wave = std::max(params.wave_px, 1.0) * px;
    const auto overshoot = [&](Wave end) {
        return params.overshoot_px * px * (0.7 + 0.3 * noise.at(end, 0));
    };
    const double begin = -overshoot(Wave::start);
    const double end = path.length() + overshoot(Wave::end);
    const double taper = std::min(params.taper_px * px, (end - begin) / 2);
    for (double t = begin; t <= end; t += kStep_samples) {
        const double u = t / wave;
        const glm::dvec2 off(noise.at(Wave::x, u), noise.at(Wave::y, u));
        const double to_end = std::min(t - begin, end - t);
        const double share = taper > 0 ? std::min(to_end / taper, 1.0) : 1;
        const double width = pen.line_width_px * px *
                             (1 + params.width_spread * noise.at(Wave::width, u)) *
                             (kThinnestEnd + (1 - kThinnestEnd) * share);
        // A pen of less than one sample would leave gaps between centres.
        const double radius = std::max(width / 2, 0.5);
        draw_disc(path.at(t) + params.jitter_px * px * off, radius, image);
    }
}

}  // namespace

core::ParamTable<HandParams> hand_table() {
    core::ParamTable<HandParams> table;
    table
        .number(&HandParams::jitter_px,
                "jitter_px",
                {0, 20},
                "px",
                "How far a stroke wanders off its line at most, along each axis.")
        .number(&HandParams::wave_px, "wave_px", {1, 1000}, "px", "Length of its waves.")
        .number(&HandParams::overshoot_px,
                "overshoot_px",
                {0, 100},
                "px",
                "How far it runs beyond the ends of its line at most.")
        .number(&HandParams::width_spread,
                "width_spread",
                {0, 1},
                "",
                "By what part of it the width swells and shrinks.")
        .number(&HandParams::taper_px,
                "taper_px",
                {0, 200},
                "px",
                "Length over which a stroke grows to its width at either end.")
        .number(&HandParams::passes, "passes", {1, 8}, "", "Strokes over each other.")
        .number(&HandParams::corner_deg,
                "corner_deg",
                {5, 180},
                "deg",
                "Turn from which on a line is two strokes.")
        .number(&HandParams::smooth_px,
                "smooth_px",
                {0, 10},
                "px",
                "How much the steps of the raster are smoothed away (sigma).")
        .number(&HandParams::least_px,
                "least_px",
                {0, 1000},
                "px",
                "Lines shorter than this are left out.");
    return table;
}

core::Image<std::uint8_t> draw_by_hand(const core::Image<std::uint8_t>& thinned,
                                       const HandParams& params,
                                       const HandPen& pen) {
    core::Image<std::uint8_t> image(thinned.width_px(), thinned.height_px());
    const int n = pen.samples_per_px;
    const auto strokes =
        cut_at_corners(trace_chains(thinned), glm::radians(params.corner_deg), kCornerReach_px * n);
    for (std::size_t i = 0; i < strokes.size(); ++i) {
        LineChain stroke = strokes[i];
        if (static_cast<double>(stroke.points_px.size()) < params.least_px * n) continue;
        smooth(stroke, params.smooth_px * n);
        const Path path(stroke);
        for (int pass = 0; pass < params.passes; ++pass)
            draw_stroke(path, params, pen, Noise(pen.seed, i, pass), image);
    }
    return image;
}

}  // namespace ink::shade
