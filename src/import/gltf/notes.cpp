#include "import/gltf/notes.h"

#include <array>
#include <set>

namespace ink::import {
namespace {

std::string counted(std::size_t count, const std::string& thing) {
    return std::to_string(count) + ' ' + thing + (count == 1 ? "" : "s");
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
