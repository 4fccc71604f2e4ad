#include "methods/mesh_lookup/lookup_table.h"

#include <cstdlib>
#include <glm/trigonometric.hpp>

#include "methods/mesh_lookup/lookup_method.h"
#include "methods/surface_codes/surface_code_params.h"
#include "methods/surface_codes/surface_codes.h"

namespace ink::methods {

std::vector<std::uint32_t> lookup_words(const LookupMesh& mesh,
                                        const std::vector<std::uint32_t>& codes) {
    const std::size_t count = mesh.faces.size();
    std::vector<std::uint32_t> words(count);
    for (std::size_t t = 0; t < codes.size(); ++t) {
        const std::uint32_t face = mesh.face_of_triangle[t];
        if (face != kNoNeighbour) words[face] = codes[t] << LookupWord::kCodeShift | face;
    }
    const auto code = [&](std::size_t face) {
        return static_cast<int>(words[face] >> LookupWord::kCodeShift);
    };
    for (std::size_t f = 0; f < count; ++f) {
        for (std::size_t i = 0; i < 3; ++i) {
            const Twin twin = mesh.faces[f].twins[i];
            if (twin.is_nothing()) continue;
            const bool is_line = mesh.faces[f].kinds[i] != LineKind::none;
            if (twin.is_many() || is_line != (std::abs(code(f) - code(twin.face())) >= 2))
                words[f] |= LookupWord::kFlag;
        }
    }
    return words;
}

LookupTable lookup_table(const scene::PreparedScene& scene) {
    const LookupParams params;
    const LookupMesh mesh = make_lookup_mesh(
        scene,
        {.crease_rad = glm::radians(params.crease_deg), .weld_epsilon = params.weld_epsilon});
    LookupWord::require_room("surface_lookup", mesh.faces.size());
    SurfaceCodeParams code_params;
    code_params.crease_deg = params.crease_deg;
    code_params.weld_epsilon = params.weld_epsilon;
    SurfaceCodes codes(code_options(code_params, surface_setup(code_params)));
    codes.prepare(scene);
    const std::vector<std::uint32_t> words =
        lookup_words(mesh, codes.object_codes(scene, code_params.length_px));

    LookupTable table;
    for (std::size_t f = 0; f < mesh.faces.size(); ++f) {
        const LookupFace& face = mesh.faces[f];
        std::uint32_t rest =
            (words[f] & ~LookupWord::kFaceOfCoded) | (mesh.objects[f] & LookupTable::kObject) << 9U;
        for (std::size_t i = 0; i < 3; ++i)
            rest |= static_cast<std::uint32_t>(face.kinds[i]) << 3 * i;
        table.faces.push_back({face.vertices,
                               face.patch,
                               {face.twins[0].word, face.twins[1].word, face.twins[2].word},
                               rest});
    }
    for (const glm::dvec3& p : mesh.p_world)
        table.p_world.emplace_back(p, 1);
    return table;
}

}  // namespace ink::methods
