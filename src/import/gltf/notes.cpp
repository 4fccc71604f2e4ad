#include "import/gltf/notes.h"

#include <algorithm>
#include <array>
#include <set>
#include <string_view>

#include "import/meshes/polygons.h"

namespace ink::import {
namespace {

enum class Heeded {
    read,
    needless,  ///< moves no triangle: looks, sounds, physics, notes of other programs
    visible,   ///< moves no triangle, but draws something that is left out here
};

struct Extension {
    std::string_view name;  ///< or how it begins, before a *
    Heeded heeded;
};

/// All that may be required of us. Others are refused by name.
constexpr std::array kExtensions{
    Extension{"EXT_mesh_gpu_instancing", Heeded::read},
    Extension{"EXT_mesh_primitive_edge_visibility", Heeded::read},
    Extension{"EXT_meshopt_compression", Heeded::read},
    Extension{"KHR_animation_pointer", Heeded::read},
    Extension{"KHR_draco_mesh_compression", Heeded::read},
    Extension{"KHR_lights_punctual", Heeded::read},
    Extension{"KHR_mesh_quantization", Heeded::read},
    Extension{"KHR_meshopt_compression", Heeded::read},
    Extension{"KHR_node_visibility", Heeded::read},
    Extension{"KHR_materials_*", Heeded::needless},
    Extension{"KHR_texture_*", Heeded::needless},
    Extension{"KHR_audio*", Heeded::needless},
    Extension{"KHR_node_hoverability", Heeded::needless},
    Extension{"KHR_node_selectability", Heeded::needless},
    Extension{"KHR_physics_*", Heeded::needless},
    Extension{"KHR_technique*", Heeded::needless},
    Extension{"KHR_xmp*", Heeded::needless},
    Extension{"EXT_instance_features", Heeded::needless},
    Extension{"EXT_lights_*", Heeded::needless},
    Extension{"EXT_mesh_features", Heeded::needless},
    Extension{"EXT_mesh_manifold", Heeded::needless},
    Extension{"EXT_structural_metadata", Heeded::needless},
    Extension{"EXT_texture_*", Heeded::needless},
    Extension{"ADOBE_materials_*", Heeded::needless},
    Extension{"AGI_stk_metadata", Heeded::needless},
    Extension{"FB_ngon_encoding", Heeded::needless},
    Extension{"GODOT_single_root", Heeded::needless},
    Extension{"MSFT_lod", Heeded::needless},
    Extension{"MSFT_packing_*", Heeded::needless},
    Extension{"MSFT_screencoverage", Heeded::needless},
    Extension{"MSFT_texture_dds", Heeded::needless},
    Extension{"CESIUM_primitive_outline", Heeded::visible},
};

const Extension* find_extension(std::string_view name) {
    const auto* found = std::find_if(kExtensions.begin(), kExtensions.end(), [&](auto& extension) {
        const std::string_view known = extension.name;
        return known.ends_with('*') ? name.starts_with(known.substr(0, known.size() - 1))
                                    : name == known;
    });
    return found == kExtensions.end() ? nullptr : found;
}

/// "2 further animations: Run, Jump", of all but number `own`; nameless ones by number.
void note_further(const std::vector<JsonObject>& all,
                  std::size_t own,
                  const std::string& thing,
                  std::vector<std::string>& notes) {
    std::string names;
    for (std::size_t i = 0; i < all.size(); ++i) {
        if (i == own) continue;
        const std::string name = all[i].text("name");
        names += (names.empty() ? "" : ", ") + (name.empty() ? std::to_string(i) : name);
    }
    if (!names.empty()) notes.push_back(counted(all.size() - 1, "further " + thing) + ": " + names);
}

}  // namespace

void check_extensions(const GltfDocument& document, std::vector<std::string>& notes) {
    const JsonObject root = document.root();
    for (const std::string& name : root.texts("extensionsRequired")) {
        if (find_extension(name) == nullptr)
            root.refuse("it needs the extension " + name + ", which is not read");
    }
    std::string ignored;
    for (const std::string& name : root.texts("extensionsUsed")) {
        const Extension* known = find_extension(name);
        if (known != nullptr && known->heeded != Heeded::visible) continue;
        ignored += (ignored.empty() ? "" : ", ") + name;
    }
    if (!ignored.empty()) notes.push_back("not read: " + ignored);
}

void note_choices(const GltfDocument& document,
                  std::size_t animation,
                  std::vector<std::string>& notes) {
    note_further(document.animations, animation, "animation", notes);
    const std::size_t scenes = document.scenes.size();
    if (scenes == 0) return;
    note_further(
        document.scenes, document.root().find_index("scene", scenes).value_or(0), "scene", notes);
}

void note_left_out(std::size_t lines,
                   std::size_t empty_parts,
                   std::size_t pointers,
                   std::vector<std::string>& notes) {
    if (lines > 0) notes.push_back(counted(lines, "part") + " of points or lines left out");
    if (empty_parts > 0) notes.push_back(counted(empty_parts, "part") + " without a triangle");
    if (pointers > 0)
        notes.push_back(counted(pointers, "channel") + " of the animation at no node");
}

void note_materials(const GltfDocument& document,
                    const std::vector<ImportedMesh>& meshes,
                    std::vector<std::string>& notes) {
    std::set<std::uint32_t> used;
    for (const ImportedMesh& mesh : meshes)
        for (const MeshPart& part : mesh.parts)
            used.insert(part.material);
    for (const char* mode : {"BLEND", "MASK"}) {
        std::size_t count = 0;
        for (const std::uint32_t material : used)
            if (material < document.materials.size() &&
                document.materials[material].text("alphaMode") == mode)
                ++count;
        if (count > 0)
            notes.push_back(counted(count, "material") + " of " + mode + " drawn opaque");
    }
}

}  // namespace ink::import
