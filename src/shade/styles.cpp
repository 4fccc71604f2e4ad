#include "shade/styles.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace ink::shade {

ToonTable make_toon_table(int steps, double dark) {
    ToonTable table{};
    for (std::size_t i = 0; i < kToonEntries; ++i) {
        const int level = static_cast<int>(i) * steps / static_cast<int>(kToonEntries);
        const double share = steps > 1 ? static_cast<double>(level) / (steps - 1) : 1;
        table[i] = static_cast<float>(dark + (1 - dark) * share);
    }
    return table;
}

float look_up(const ToonTable& table, float brightness) {
    const auto entry = static_cast<std::size_t>(std::max(brightness, 0.0F) * kToonEntries);
    return table[std::min(entry, kToonEntries - 1)];
}

glm::vec3 gooch(float cosine, const GoochParams& params, const glm::vec3& surface) {
    const glm::vec3 cool = glm::vec3(0, 0, static_cast<float>(params.blue)) +
                           static_cast<float>(params.cool_share) * surface;
    const auto yellow = static_cast<float>(params.yellow);
    const glm::vec3 warm =
        glm::vec3(yellow, yellow, 0) + static_cast<float>(params.warm_share) * surface;
    const float lit = (1 + cosine) / 2;
    return params.lit == LitSide::cool ? lit * cool + (1 - lit) * warm
                                       : lit * warm + (1 - lit) * cool;
}

float splashback(float cosine, double alpha, int power) {
    const auto a = static_cast<float>(alpha);
    const float base = a * std::min(std::abs(cosine), 1.0F) + (1 - a);
    float result = 1;
    for (int i = 0; i < power; ++i)
        result *= base;
    return result;
}

StrokeShares stroke_shares(float darkness, const StrokeParams& params) {
    constexpr float kThinnest = 0.15F;
    constexpr float kWidest = 0.5F;
    const auto share = [&](double from, double to) {
        if (darkness < from) return 0.0F;
        const double way = to > from ? std::min((darkness - from) / (to - from), 1.0) : 1;
        return kThinnest + (kWidest - kThinnest) * static_cast<float>(way);
    };
    return {share(params.single_from, params.crossed_from), share(params.crossed_from, 1)};
}

bool is_on_stroke(double x_px, double y_px, const StrokeShares& shares, double spacing_px) {
    const auto hits = [&](double along_px, float share) {
        const double turns = along_px / (std::numbers::sqrt2 * spacing_px);
        return turns - std::floor(turns) < share;
    };
    return hits(x_px + y_px, shares.single) || hits(x_px - y_px, shares.crossed);
}

}  // namespace ink::shade
