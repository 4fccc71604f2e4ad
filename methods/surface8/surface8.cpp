#include "methods/surface8/surface8.h"

namespace ink::methods {

method::MethodInfo surface8() {
    method::MethodInfo info = method::method_info<Surface8>(
        "surface8",
        "new here: distances over the surface in a byte, constant over each triangle",
        "a line wherever codes of surface distance differ by more than a step");
    info.family = method::Family::ids;
    info.marker = method::Marker::diamond;
    info.tunables = buffers::surface_tunables();
    info.sweep = buffers::surface_sweep();
    return info;
}

}  // namespace ink::methods
