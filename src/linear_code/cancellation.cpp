#include "linear_code/cancellation.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>

#include "score/attribution.h"
#include "truth/label_image.h"

namespace ink::linear_code {
namespace {

/// Right angles of turned boxes come out a little under 90 as often as over it.
constexpr double kRounding_deg = 0.01;

int bin_low_deg(double deviation_rad) {
    constexpr int kLast_deg = 180 - kDihedralBin_deg;
    const double deviation_deg = deviation_rad * 180 / std::numbers::pi;
    const int low =
        static_cast<int>((deviation_deg + kRounding_deg) / kDihedralBin_deg) * kDihedralBin_deg;
    return std::clamp(low, 0, kLast_deg);
}

LineKind kind_of(const truth::Curve& curve) {
    if (curve.line_class == truth::LineClass::boundary) return {curve.line_class, std::nullopt};
    return {curve.line_class, bin_low_deg(curve.deviation_rad)};
}

}  // namespace

std::optional<int> threshold_in_codes(const edge::LaplacianResponse& response, int edge_response) {
    for (int laplacian = 0; laplacian <= 4 * 65535; ++laplacian) {
        if (edge::respond(laplacian, response) >= edge_response) return laplacian;
        if (edge::respond(-laplacian, response) >= edge_response) return laplacian;
    }
    return std::nullopt;
}

double silent_deviation_rad(const method::LinearCode& code, int threshold) {
    double square = 0;
    for (const double weight : code.normal_weight)
        square += weight * weight;
    const auto least = threshold_in_codes(code.response, threshold);
    const double seen_twice = 2 * std::sqrt(square);
    if (!least || *least >= seen_twice) return std::numbers::pi;
    return 2 * std::asin(*least / seen_twice);
}

std::vector<KindPixels> sort_by_kind(const truth::Truth& traced,
                                     const score::ScoringTruth& scoring) {
    const int width = scoring.labels.width_px(), height = scoring.labels.height_px();
    const auto curve_at = truth::draw_curve_map(traced.curves, width, height);
    std::map<LineKind, std::vector<score::Pixel>> kinds;
    for (int y = 0; y < height; ++y) {
        for (int x = 0; x < width; ++x) {
            if (scoring.labels.at(x, y) == 0 || curve_at.at(x, y) == truth::kNoCurve) continue;
            kinds[kind_of(traced.curves[curve_at.at(x, y)])].push_back({x, y});
        }
    }
    std::vector<KindPixels> sorted;
    core::Image<std::uint8_t> mask(width, height);
    for (const auto& [kind, pixels] : kinds) {
        for (const auto& [x, y] : pixels)
            mask.at(x, y) = 1;
        sorted.push_back({kind, score::PixelList(mask)});
        for (const auto& [x, y] : pixels)
            mask.at(x, y) = 0;
    }
    return sorted;
}

CancellationCount count_cancellation(const score::PixelList& kind,
                                     CountedInk& predicted,
                                     CountedInk& measured) {
    CancellationCount count;
    count.n_truth = static_cast<std::int64_t>(kind.size());
    count.predicted_missed = count.n_truth - predicted.match(kind);
    count.measured_missed = count.n_truth - measured.match(kind);
    kind.visit([&](int x, int y) {
        const bool is_predicted = predicted.is_near(x, y);
        const bool is_measured = measured.is_near(x, y);
        count.predicted_false_negatives += is_predicted ? 0 : 1;
        count.measured_false_negatives += is_measured ? 0 : 1;
        count.both_false_negatives += is_predicted || is_measured ? 0 : 1;
    });
    return count;
}

}  // namespace ink::linear_code
