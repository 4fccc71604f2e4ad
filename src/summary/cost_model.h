#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "core/tables/table_of.h"
#include "harness/cells/frame_counts.h"
#include "harness/rows/row.h"

namespace ink::summary {

/// A kind of work that the model gives one price, the same for every method of a run.
struct CostUnit {
    std::string_view name;
    std::string_view doc;  ///< what one of it is
};

/// vertex, vertex_value, triangle, interpolant, covered_pixel, pixel, byte.
inline constexpr std::size_t kCostUnits = 7;
[[nodiscard]] const std::array<CostUnit, kCostUnits>& cost_units();

/// A number per unit: how many of it, or what one costs in ns.
using PerUnit = std::array<double, kCostUnits>;

/// How much of each unit a frame takes: passes x (per vertex + per triangle + per covered pixel +
/// per pixel of the frame).
[[nodiscard]] PerUnit unit_counts(const harness::CostFacts& facts);

/// The sum over units of `counts` times `ns_per_unit`.
[[nodiscard]] double predict_ns(const PerUnit& ns_per_unit, const PerUnit& counts);

/// A frame whose time is known.
struct CostSample {
    PerUnit counts{};
    double measured_ns = 0;  ///< > 0
};

/// The prices, none negative, that minimise the sum of (predicted / measured - 1)^2: relative, so
/// that a frame of a millisecond counts as much as one of a second. 0 for a unit that no sample has
/// or none needs. No samples give zeros.
///
/// Sequential coordinate-wise descent (Franc, Hlavac and Navara 2005), the same bits for the same
/// samples in the same order.
[[nodiscard]] PerUnit fit_unit_costs(std::span<const CostSample> samples);

/// The time that a cell of a method, or a setting of it, should take.
struct CostPrediction {
    std::int64_t cell = 0;
    int setting = 0;  ///< as Row::setting
    std::int64_t predicted_ns = 0;
    double residual = 0;  ///< draw_ns_min over that, less 1
};

/// What a fit was made from, for the report, and what it predicts.
struct CostFit {
    PerUnit ns_per_unit{};  ///< over all cells
    std::size_t cells = 0;
    std::string_view left_out;  ///< "scene" or "view": what each prediction was made without
    std::vector<CostPrediction> predictions = {};  ///< in the order of rows, then settings
};

/// Predicts the time of every row that declares its cost and was timed, each
/// from prices fitted without its own scene; without its own view if there is one scene
/// only. What is predicted is the least time: the model knows work, not what disturbed it. Nothing
/// where what is left has fewer cells than there are units: such a fit says nothing.
///
/// The cells are the timed ones of `rows` and `sweep` together. `cells` is 0 if nothing was
/// predicted.
[[nodiscard]] CostFit predict_costs(const std::vector<harness::Row>& rows,
                                    const std::vector<harness::Row>& sweep);

/// cost_fit.csv: a line per kind of work with its price; the heading alone for a fit of no cells.
[[nodiscard]] const core::TableInfo& cost_fit_table();
[[nodiscard]] std::string cost_fit_csv(const CostFit& fit);

/// predictions.csv: a line per cell and setting that a time is predicted of.
[[nodiscard]] const core::TableOf<CostPrediction>& predictions_table();

}  // namespace ink::summary
