#include <fmt/format.h>

#include "core/error.h"
#include "studies/stress/stress_cases.h"

namespace ink::studies {

const Axis& find_stress_axis(const std::string& name) {
    std::vector<std::string> names;
    for (const Axis& axis : stress_axes()) {
        if (axis.name == name) return axis;
        names.push_back(axis.name);
    }
    throw core::Error(
        "--axes", fmt::format("there is no axis '{}'", name), core::known_names(names, name));
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
