// New here: two distances over the surface in two bytes, constant over each triangle: that of
// surface8, and one from another end of each patch, with steps twice as long. The larger of the two
// edge responses counts (surface_codes/surface_codes.h).

#include "methods/surface_codes/surface_code_params.h"

namespace ink::methods {

method::MethodInfo surface16_method() {
    return method::method_info<SurfaceCodeMethod<2>>("surface16");
}

}  // namespace ink::methods
