#include "methods/surface16/surface16.h"

namespace ink::methods {

method::MethodInfo surface16() {
    method::MethodInfo info = method::method_info<Surface16>(
        "surface16",
        "new here: two distances over the surface in two bytes, constant over each triangle",
        "a line wherever one of two codes of surface distance differs by more than a step");
    info.family = method::Family::ids;
    info.marker = method::Marker::left;
    info.tunables = buffers::surface_tunables();
    info.sweep = buffers::surface_sweep();
    return info;
}

}  // namespace ink::methods
