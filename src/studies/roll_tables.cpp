#include <fmt/format.h>

#include <cmath>
#include <numbers>

#include "harness/tables/side_table.h"
#include "studies/roll_axis.h"

namespace ink::studies {
namespace {

/// Angles are written with ten digits: a whole degree that was turned into radians and back is
/// then whole again.
std::string degrees_text(double angle_rad) {
    return fmt::format("{:.10g}", angle_rad * 180 / std::numbers::pi);
}

/// A line of a crease, with the crease's number.
template <class T>
struct OfCrease : T {
    int crease = 0;
    bool is_predicted = false;
};
template <class T>
using CreaseTable = harness::SideTable<OfCrease<T>>;

template <class T>
CreaseTable<T> table_of(const char* file, const char* doc) {
    CreaseTable<T> table(file, doc);
    table.add({"crease", "", "0, 1, 2: by the number of its edge"}, &OfCrease<T>::crease);
    return table;
}

const CreaseTable<RollSample>& creases() {
    static const auto kTable = [] {
        auto table = table_of<RollSample>(
            "creases.csv",
            "A line per cell of study `roll` at an even angle, and crease: how a method draws a "
            "crease of a cube "
            "while the camera rolls once round; the row's value is the angle.");
        using S = OfCrease<RollSample>;
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

/// From prediction to measurement the short way, by the angles as they are written.
std::string error_text(const Vanishing& at) {
    if (!at.measured_rad) return "";
    const double turn_deg =
        std::stod(degrees_text(*at.measured_rad)) - std::stod(degrees_text(at.predicted_rad));
    return fmt::format("{:.3g}", std::remainder(turn_deg, 360.0));
}

const CreaseTable<Vanishing>& vanishings() {
    static const auto kTable = [] {
        auto table = table_of<Vanishing>(
            "vanishing.csv",
            "A line per cell of study `roll` and crease at whose angle a code has no step across "
            "it: where the crease was lost.");
        using V = Vanishing;
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

}  // namespace

const harness::TableInfo& creases_table() {
    return creases().info();
}

std::string crease_line(std::int64_t cell,
                        int crease,
                        const RollSample& sample,
                        bool is_predicted) {
    return creases().line(cell, {sample, crease, is_predicted});
}

const harness::TableInfo& vanishing_table() {
    return vanishings().info();
}

std::string vanishing_line(std::int64_t cell, int crease, const Vanishing& at) {
    return vanishings().line(cell, {at, crease});
}

}  // namespace ink::studies
