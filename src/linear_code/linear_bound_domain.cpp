#include "linear_code/linear_bound_domain.h"

#include <algorithm>
#include <cmath>

#include "core/error.h"

namespace ink::linear_code {

bool WeightDomain::contains(const LinearWeights& weights) const {
    const bool has_sign = *std::min_element(weights.begin(), weights.end()) < 0;
    return (is_signed || !has_sign) && sum_of_sizes(weights) <= most_sum;
}

double sum_of_sizes(const LinearWeights& weights) {
    double sum = 0;
    for (const double weight : weights)
        sum += std::abs(weight);
    return sum;
}

std::optional<int> threshold_in_codes(const edge::LaplacianResponse& response, int edge_response) {
    for (int laplacian = 0; laplacian <= 4 * 65535; ++laplacian) {
        if (edge::respond(laplacian, response) >= edge_response) return laplacian;
        if (edge::respond(-laplacian, response) >= edge_response) return laplacian;
    }
    return std::nullopt;
}

LinearWeights weights_of(const method::LinearCode& code, int edge_response) {
    const double threshold = threshold_in_codes(code.response, edge_response).value_or(4 * 65535);
    return {code.depth_weight / threshold,
            code.normal_weight[0] / threshold,
            code.normal_weight[1] / threshold,
            code.normal_weight[2] / threshold};
}

WeightDomain weight_domain(const std::string& name,
                           const method::LinearCode& code,
                           bool is_signed,
                           int least_threshold) {
    if (code.wraps || code.response.response == edge::Response::wrap) {
        throw core::Error(name,
                          "a code or a response that wraps is not linear in its weights",
                          "overflow saturate, response absolute or positive");
    }
    if (code.offset != 0 || code.sky_code != 0) {
        throw core::Error(name,
                          "weights are bounded for codes that are 0 where nothing is seen",
                          "sky 0, depth_sign near_high");
    }
    const int least = threshold_in_codes(code.response, 1).value_or(1);
    const double range = (1 << code.bits) - 1;
    return {.is_signed = is_signed,
            .most_sum = range / std::max(least, least_threshold),
            .response = code.response.response};
}

}  // namespace ink::linear_code
