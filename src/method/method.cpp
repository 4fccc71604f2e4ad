#include "method/method.h"

#include "core/vocabulary.h"

namespace ink::method {

MethodInfo method_info(std::string_view name,
                       const core::ParamRows& rows,
                       bool draws_by_threshold,
                       MakeMethod make) {
    MethodInfo info;
    info.name = name;
    info.params = rows.params();
    info.draws_by_threshold = draws_by_threshold;
    info.make = [rows, make, where = info.name](const core::ParamValues& values) {
        return make(rows, values, where);
    };
    info.complete = [rows, where = info.name](const core::ParamValues& values) {
        return rows.complete(values, where);
    };
    return info;
}

std::string_view name_of(Family family) {
    return core::vocabulary().families[static_cast<std::size_t>(family)].name;
}

std::string_view name_of(Marker marker) {
    return core::vocabulary().markers[static_cast<std::size_t>(marker)].name;
}

}  // namespace ink::method
