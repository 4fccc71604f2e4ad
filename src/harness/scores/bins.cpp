#include "harness/scores/bins.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>
#include <optional>

#include "score/matching.h"
#include "truth/label_image.h"

namespace ink::harness {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();
constexpr double kDegrees = 180 / std::numbers::pi;
constexpr std::size_t kAttributes = 4;

using Values = std::array<std::optional<double>, kAttributes>;

bool is_one_sided(const truth::Curve& curve) {
    return curve.line_class == truth::LineClass::contour ||
           curve.line_class == truth::LineClass::boundary;
}

/// Distance along the view direction at the point of a curve nearest to a pixel's centre: 1/w is
/// linear on the image.
double w_at(const truth::Curve& curve, double x_px, double y_px) {
    const double dx = curve.end.x_px - curve.begin.x_px;
    const double dy = curve.end.y_px - curve.begin.y_px;
    const double square = dx * dx + dy * dy;
    if (square == 0) return curve.begin.w;
    const double along = (x_px - curve.begin.x_px) * dx + (y_px - curve.begin.y_px) * dy;
    const double s = std::clamp(along / square, 0.0, 1.0);
    return 1 / ((1 - s) / curve.begin.w + s / curve.end.w);
}

double w_in_the_middle(const truth::Curve& curve) {
    return 2 / (1 / curve.begin.w + 1 / curve.end.w);
}

/// How near and far the visible lines of a view are.
struct DepthRange {
    double nearest = kInfinity;
    double farthest = 0;

    explicit DepthRange(const std::vector<truth::Curve>& curves) {
        for (const truth::Curve& curve : curves) {
            nearest = std::min({nearest, curve.begin.w, curve.end.w});
            farthest = std::max({farthest, curve.begin.w, curve.end.w});
        }
    }
    [[nodiscard]] double relative(double w) const {
        return farthest > nearest ? (w - nearest) / (farthest - nearest) : 0;
    }
};

/// The attributes of a curve at a pixel, in the order of line_attributes().
Values values_of(const truth::Curve& curve, const DepthRange& range, double x_px, double y_px) {
    Values values;
    if (curve.line_class != truth::LineClass::boundary) values[0] = curve.deviation_rad * kDegrees;
    if (is_one_sided(curve)) values[1] = curve.gap / w_in_the_middle(curve);
    values[2] = curve.view_angle_rad * kDegrees;
    values[3] = range.relative(w_at(curve, x_px, y_px));
    return values;
}

/// The bin of a value, from 0; past the last bin if it is sky. What rounding puts outside the first
/// or last bin belongs to it.
std::size_t bin_of(const LineAttribute& attribute, double value) {
    const std::size_t bins = attribute.edges.size() - 1;
    if (attribute.has_sky && std::isinf(value)) return bins;
    const auto above = std::upper_bound(attribute.edges.begin(), attribute.edges.end(), value);
    const auto at = std::max<std::ptrdiff_t>(0, above - attribute.edges.begin() - 1);
    return std::min(static_cast<std::size_t>(at), bins - 1);
}

/// Adds the bins of one attribute that have pixels; the image holds bin numbers from 1.
void list_bins(std::size_t attribute,
               const core::Image<std::uint8_t>& numbers,
               std::vector<TruthBin>& out) {
    const LineAttribute& a = line_attributes()[attribute];
    const std::size_t bins = a.edges.size() - 1;
    for (std::size_t i = 0; i < bins + (a.has_sky ? 1 : 0); ++i) {
        score::PixelList pixels(numbers, static_cast<std::uint8_t>(i + 1));
        if (pixels.is_empty()) continue;
        const bool is_sky = i == bins;
        out.push_back({attribute,
                       is_sky ? kInfinity : a.edges[i],
                       is_sky ? kInfinity : a.edges[i + 1],
                       std::move(pixels)});
    }
}

}  // namespace

const std::vector<LineAttribute>& line_attributes() {
    static const std::vector<LineAttribute> kTable = {
        {"dihedral_deg",
         "how far the two faces at the line deviate from flat",
         {0, 20, 40, 60, 90, 120, 180}},
        {"relative_gap",
         "depth from the line to what lies behind it, over its own; the sky apart",
         {0, 0.01, 0.03, 0.1, 0.3, kInfinity},
         true},
        {"view_angle_deg",
         "between line of sight and normal of the seen face nearest edge-on",
         {0, 30, 60, 75, 85, 90}},
        {"relative_distance",
         "from the view's nearest visible line (0) to its farthest (1)",
         {0, 0.2, 0.4, 0.6, 0.8, 1}},
    };
    return kTable;
}

std::vector<TruthBin> bin_truth(const truth::Truth& traced, const score::ScoringTruth& scoring) {
    const int width = scoring.labels.width_px(), height = scoring.labels.height_px();
    const auto curve_at = truth::draw_curve_map(traced.curves, width, height);
    const DepthRange range(traced.curves);
    std::array<core::Image<std::uint8_t>, kAttributes> numbers;
    numbers.fill(core::Image<std::uint8_t>(width, height));
    for (int y = 0; y < height; ++y) {
        for (int x = 0; x < width; ++x) {
            if (scoring.labels.at(x, y) == 0 || curve_at.at(x, y) == truth::kNoCurve) continue;
            const truth::Curve& curve = traced.curves[curve_at.at(x, y)];
            const Values values = values_of(curve, range, x + 0.5, y + 0.5);
            for (std::size_t a = 0; a < kAttributes; ++a) {
                if (!values[a]) continue;
                const std::size_t bin = bin_of(line_attributes()[a], *values[a]);
                numbers[a].at(x, y) = static_cast<std::uint8_t>(bin + 1);
            }
        }
    }
    std::vector<TruthBin> bins;
    for (std::size_t a = 0; a < kAttributes; ++a)
        list_bins(a, numbers[a], bins);
    return bins;
}

std::vector<BinCount> match_bins(score::DrawnMatcher& drawn, const std::vector<TruthBin>& bins) {
    std::vector<BinCount> counts;
    for (const TruthBin& bin : bins) {
        counts.push_back({bin.attribute,
                          bin.low,
                          bin.high,
                          drawn.match(bin.pixels),
                          static_cast<std::int64_t>(bin.pixels.size())});
    }
    return counts;
}

}  // namespace ink::harness
