#pragma once

#include "buffers/codes/surface_code_params.h"

namespace ink::methods {

/// Two surface distances in two bytes: that of surface8, and one from another end of each patch.
class Surface16 : public buffers::CodeMethod {
  public:
    using Params = buffers::SurfaceCodeParams;
    [[nodiscard]] static core::ParamTable<Params> table() {
        return buffers::surface_code_table<Params>();
    }

    explicit Surface16(const Params& params)
        : buffers::CodeMethod(params, buffers::surface_setup(params, 2)) {}
};

[[nodiscard]] method::MethodInfo surface16();

}  // namespace ink::methods
