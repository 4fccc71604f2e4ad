#include "methods/registry.h"

#include <algorithm>
#include <iterator>

#include "core/error.h"
#include "methods/auto/auto.h"
#include "methods/back_faces/back_faces.h"
#include "methods/blurred_silhouette/blurred_silhouette.h"
#include "methods/canny/canny.h"
#include "methods/decaudin/decaudin.h"
#include "methods/edge_hash/edge_hash.h"
#include "methods/edge_list/edge_list.h"
#include "methods/id_lookup/id_lookup.h"
#include "methods/ids/ids.h"
#include "methods/ids_depth/ids_depth.h"
#include "methods/inverted_hull/inverted_hull.h"
#include "methods/jump_flood/jump_flood.h"
#include "methods/label8/label8.h"
#include "methods/label_plane/label_plane.h"
#include "methods/mote16/mote16.h"
#include "methods/mote2/mote2.h"
#include "methods/mote4/mote4.h"
#include "methods/plane_distance/plane_distance.h"
#include "methods/polygon_offset/polygon_offset.h"
#include "methods/rim/rim.h"
#include "methods/roberts/roberts.h"
#include "methods/sobel/sobel.h"
#include "methods/surface16/surface16.h"
#include "methods/surface8/surface8.h"
#include "methods/tuned.h"
#include "methods/two_sums/two_sums.h"

namespace ink::methods {
namespace {

std::vector<method::MethodInfo> with_tuned(std::vector<method::MethodInfo> methods) {
    std::vector<method::MethodInfo> tuned = tuned_methods(methods);
    std::move(tuned.begin(), tuned.end(), std::back_inserter(methods));
    return methods;
}

}  // namespace

const std::vector<method::MethodInfo>& registry() {
    // A static object of its own per method would register itself, and vanish with the object file
    // that nobody else refers to when this is linked from a static library. Hence a list.
    // One line for each method.
    // clang-format off
    static const std::vector<method::MethodInfo> methods = with_tuned({
        decaudin(),
        mote2(),
        mote4(),
        mote16(),
        two_sums(),
        label_plane(),
        polygon_offset(),
        edge_list(),
        back_faces(),
        edge_hash(),
        roberts(),
        sobel(),
        canny(),
        plane_distance(),
        rim(),
        ids(),
        ids_depth(),
        id_lookup(),
        inverted_hull(),
        jump_flood(),
        blurred_silhouette(),
        label8(),
        surface8(),
        surface16(),
        auto_method(),
    });
    // clang-format on
    return methods;
}

const method::MethodInfo& find_method(const std::string& name) {
    const auto& methods = registry();
    const auto found =
        std::find_if(methods.begin(), methods.end(), [&](const method::MethodInfo& info) {
            return info.name == name;
        });
    if (found != methods.end()) return *found;
    std::vector<std::string> names;
    for (const method::MethodInfo& info : methods)
        names.push_back(info.name);
    throw core::Error(
        "methods", "there is no method '" + name + "'", core::known_names(names, name));
}

}  // namespace ink::methods
