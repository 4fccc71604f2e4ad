// New here: two distances over the surface in two bytes, constant over each triangle: that of
// surface8, and one from another end of each patch, with steps twice as long. The larger of the two
// edge responses counts (surface_codes/surface_codes.h).

#include "methods/surface_codes/surface_code_params.h"

namespace ink::methods {
namespace {

class Surface16 : public CodeMethod {
  public:
    using Params = SurfaceCodeParams;
    static core::ParamTable<Params> table() { return surface_code_table(); }
    explicit Surface16(const Params& params) : CodeMethod(params, surface_setup(params, 2)) {}
};

}  // namespace

method::MethodInfo surface16_method() {
    return method::method_info<Surface16>("surface16");
}

}  // namespace ink::methods
