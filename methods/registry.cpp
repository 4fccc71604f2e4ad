#include "methods/registry.h"

#include "core/error.h"
#include "core/named.h"
#include "methods/method_file.h"
#include "methods/presets.h"

// One line for each method, in the order in which tables show them. A static object of its own per
// method would register itself, and vanish with the object file that no other refers to when this
// is linked from a static library. Hence a list.
// clang-format off
#define INK_METHODS(X) \
    X(decaudin) \
    X(mote2) \
    X(mote4) \
    X(mote16) \
    X(two_sums) \
    X(label_plane) \
    X(polygon_offset) \
    X(edge_list) \
    X(back_faces) \
    X(edge_hash) \
    X(roberts) \
    X(sobel) \
    X(canny) \
    X(plane_distance) \
    X(rim) \
    X(ids) \
    X(ids_depth) \
    X(id_lookup) \
    X(inverted_hull) \
    X(jump_flood) \
    X(blurred_silhouette) \
    X(label8) \
    X(surface8) \
    X(surface8_depth) \
    X(surface_lookup) \
    X(strokes) \
    X(chords) \
    X(auto)
// clang-format on

namespace ink::methods {

#define INK_DECLARE(name) method::MethodInfo name##_method();
INK_METHODS(INK_DECLARE)
#undef INK_DECLARE

namespace {

/// The method with what its file says.
method::MethodInfo with_data(method::MethodInfo info) {
    const auto files = method_files();
    const ShippedFile* file = core::find_named(files, info.name);
    if (file == nullptr)
        throw core::Error("methods/CMakeLists.txt", "it has no line '" + info.name + "'");
    return described(std::move(info), file->text, file->where());
}

std::vector<method::MethodInfo> all_methods() {
    std::vector<method::MethodInfo> methods;
#define INK_ADD(name) methods.push_back(with_data(name##_method()));
    INK_METHODS(INK_ADD)
#undef INK_ADD
    const std::vector<method::MethodInfo> bases = methods;
    for (const ShippedFile& preset : shipped_presets())
        methods.push_back(preset_method(parse_preset(preset.text, preset.where(), bases), bases));
    return methods;
}

}  // namespace

const std::vector<method::MethodInfo>& registry() {
    static const std::vector<method::MethodInfo> methods = all_methods();
    return methods;
}

const method::MethodInfo& find_method(const std::string& name) {
    if (const method::MethodInfo* found = core::find_named(registry(), name)) return *found;
    throw core::Error("methods",
                      "there is no method '" + name + "'",
                      core::known_names(core::names_of(registry()), name));
}

}  // namespace ink::methods
