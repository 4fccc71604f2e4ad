#include <fmt/format.h>

#include <cmath>
#include <numbers>

#include "studies/roll_axis.h"

namespace ink::studies {
namespace {

/// Angles are written with ten digits: a whole degree that was turned into radians and back is
/// then whole again.
std::string degrees_text(double angle_rad) {
    return fmt::format("{:.10g}", angle_rad * 180 / std::numbers::pi);
}

/// From prediction to measurement the short way, by the angles as they are written.
std::string error_text(const Vanishing& at) {
    if (!at.measured_rad) return "";
    const double turn_deg =
        std::stod(degrees_text(*at.measured_rad)) - std::stod(degrees_text(at.predicted_rad));
    return fmt::format("{:.3g}", std::remainder(turn_deg, 360.0));
}

harness::Column crease_column() {
    return {"crease", "", "0, 1, 2: by the number of its edge"};
}

}  // namespace

const harness::SideTable<RollSample>& creases_table() {
    static const auto kTable = [] {
        harness::SideTable<RollSample> table(
            "creases.csv",
            "A line per cell of study `roll` at an even angle, and crease: how a method draws a "
            "crease of a cube "
            "while the camera rolls once round; the row's value is the angle.");
        using S = RollSample;
        table.add(crease_column(), &S::crease);
        table.add({"length_px", "px", "of the crease that is visible"}, &S::length_px);
        table.add({"covered_px", "px", "of that, with a drawn pixel within 2 px"}, &S::covered_px);
        const auto predicted = table.part_if(&S::is_predicted);
        predicted.add({"predicted_step",
                       "codes",
                       "of the code across the crease; empty for a method that declares none"},
                      &S::step);
        predicted.add({"predicted_blind", "", "true: the code cannot show it, as predicted"},
                      &S::is_blind);
        return table;
    }();
    return kTable;
}

const harness::SideTable<Vanishing>& vanishing_table() {
    static const auto kTable = [] {
        harness::SideTable<Vanishing> table(
            "vanishing.csv",
            "A line per cell of study `roll` and crease at whose angle a code has no step across "
            "it: where the crease was lost.");
        using V = Vanishing;
        table.add(crease_column(), &V::crease);
        table.add_derived({"predicted_deg", "deg", "the angle without a step"},
                          [](const V& at) { return degrees_text(at.predicted_rad); });
        table.part(&V::measured_rad)
            .add_derived({"measured_deg",
                          "deg",
                          "middle of the angles near it at which less than half was drawn"},
                         degrees_text);
        table.add_derived({"error_deg", "deg", "measured less predicted, the short way round"},
                          error_text);
        table.add({"recall_there", "0..1", "share of the crease drawn at exactly this angle"},
                  &V::recall_there);
        return table;
    }();
    return kTable;
}

}  // namespace ink::studies
