#include "method/method.h"

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

}  // namespace ink::method
