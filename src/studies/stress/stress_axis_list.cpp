#include <fmt/format.h>

#include "core/error.h"
#include "core/named.h"
#include "studies/stress/stress_cases.h"

namespace ink::studies {

const Axis& find_stress_axis(const std::string& name) {
    if (const Axis* axis = core::find_named(stress_axes(), name)) return *axis;
    throw core::Error("--axes",
                      fmt::format("there is no axis '{}'", name),
                      core::known_names(core::names_of(stress_axes()), name));
}

const std::vector<Axis>& stress_axes() {
    static const std::vector<Axis> axes = [] {
        std::vector<Axis> made;
        add_place_axes(made);
        add_shape_axes(made);
        add_parameter_axes(made);
        add_defect_axes(made);
        return made;
    }();
    return axes;
}

}  // namespace ink::studies
