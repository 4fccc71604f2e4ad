#pragma once

#include "buffers/codes/surface_code_params.h"

namespace ink::methods {

/// Surface distance in a byte: a code per triangle that changes by a step at most where a smooth
/// surface goes on, and by more across lines.
class Surface8 : public buffers::CodeMethod {
  public:
    using Params = buffers::SurfaceCodeParams;
    [[nodiscard]] static core::ParamTable<Params> table() {
        return buffers::surface_code_table<Params>();
    }

    explicit Surface8(const Params& params)
        : buffers::CodeMethod(params, buffers::surface_setup(params, 1)) {}
};

[[nodiscard]] method::MethodInfo surface8();

}  // namespace ink::methods
