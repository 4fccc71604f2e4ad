#include "studies/roll_prediction.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "edge/laplacian.h"

namespace ink::studies {
namespace {

constexpr double kTurn_rad = 2 * std::numbers::pi;

double within_turn(double angle_rad) {
    const double rest = std::fmod(angle_rad, kTurn_rad);
    return rest < 0 ? rest + kTurn_rad : rest;
}

}  // namespace

RollPrediction::RollPrediction(const method::LinearCode& code, const CreaseNormals& normals)
    : response_(code.response) {
    const glm::dvec3 change = normals.n1_view - normals.n0_view;
    const double* weight = code.normal_weight;
    cosine_ = (weight[0] * change.x + weight[1] * change.y) / 2;
    sine_ = (weight[0] * change.y - weight[1] * change.x) / 2;
    constant_ = weight[2] * change.z / 2;
    if (code.wraps) period_ = std::ldexp(1.0, code.bits);
}

double RollPrediction::step(double roll_rad) const {
    const double step = cosine_ * std::cos(roll_rad) + sine_ * std::sin(roll_rad) + constant_;
    return period_ > 0 ? std::remainder(step, period_) : step;
}

std::vector<double> RollPrediction::vanishing_rad() const {
    const double amplitude = std::sqrt(cosine_ * cosine_ + sine_ * sine_);
    if (amplitude == 0) return {};
    const double phase = std::atan2(sine_, cosine_);
    // A code that wraps vanishes at whole periods, too.
    const double most = std::abs(constant_) + amplitude;
    const int periods = period_ > 0 ? static_cast<int>(most / period_) : 0;
    std::vector<double> angles;
    for (int k = -periods; k <= periods; ++k) {
        const double cosine = (k * period_ - constant_) / amplitude;
        if (std::abs(cosine) > 1) continue;
        angles.push_back(within_turn(phase + std::acos(cosine)));
        angles.push_back(within_turn(phase - std::acos(cosine)));
    }
    std::sort(angles.begin(), angles.end());
    return angles;
}

bool RollPrediction::is_blind(double roll_rad, int threshold) const {
    const int twice = static_cast<int>(std::lround(2 * std::abs(step(roll_rad))));
    const auto edge_response = [&](int laplacian) { return edge::respond(laplacian, response_); };
    return std::max(edge_response(twice), edge_response(-twice)) < threshold &&
           std::max(edge_response(twice / 2), edge_response(-(twice / 2))) < threshold;
}

}  // namespace ink::studies
