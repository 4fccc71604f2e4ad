#pragma once

#include <array>
#include <optional>
#include <string>

#include "edge/laplacian.h"
#include "method/method.h"

namespace ink::linear_code {

/// Weights of depth and the normal's x, y, z over the threshold: a code that fires from T codes on
/// has T times these.
using LinearWeights = std::array<double, 4>;

/// What they come to, sign aside.
[[nodiscard]] double sum_of_sizes(const LinearWeights& weights);

/// Which weights are asked about: the filter fires where w . v >= 1.
struct WeightDomain {
    bool is_signed = false;  ///< else no weight is below 0
    /// The most that the four may come to, sign aside. As it stands: a byte spans 255 codes, and a
    /// threshold of less than 4 would draw what rounding leaves of a plane.
    double most_sum = 255.0 / 4;
    /// `absolute` or `positive`: a response modulo its range is not linear.
    edge::Response response = edge::Response::absolute;
    /// What rounding may add to w . v or take from it: 0 for real numbers; 4 / T holds every code
    /// that is rounded once and fires from T codes on.
    double rounding = 0;

    /// Whether `weights` are among them.
    [[nodiscard]] bool contains(const LinearWeights& weights) const;
};

/// The least |L| whose edge response, by either sign, is `edge_response` (1..255) or more, in
/// codes; nothing if none is.
[[nodiscard]] std::optional<int> threshold_in_codes(const edge::LaplacianResponse& response,
                                                    int edge_response);

/// The weights over the threshold of a code whose lines have `edge_response` or more. The code
/// passes weight_domain().
[[nodiscard]] LinearWeights weights_of(const method::LinearCode& code, int edge_response);

/// All weights that a code of these bits and this response can have: of one sign and within its
/// range at every pixel, or, `is_signed`, with sizes that come to no more than its range. Its
/// threshold is no less than `least_threshold` codes; 0: than the least that its filter draws.
///
/// Throws core::Error (where = `name`) for a code that is not linear with 0 for empty pixels: one
/// that wraps, whose response wraps, or that has an offset or a sky code.
[[nodiscard]] WeightDomain weight_domain(const std::string& name,
                                         const method::LinearCode& code,
                                         bool is_signed,
                                         int least_threshold);

}  // namespace ink::linear_code
