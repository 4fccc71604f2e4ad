#pragma once

#include <filesystem>
#include <glm/vec2.hpp>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "import/import.h"
#include "methods/surface_codes/baked_codes.h"
#include "scene/scene.h"

namespace ink::bake {

/// What is put into a file.
struct BakeOptions {
    std::optional<methods::BakedMethod> codes{};  ///< the attribute _INK
    int texcoord = 0;                             ///< 1 or 2: codes as TEXCOORD_1 or _2, too
    bool edges = false;                           ///< EXT_mesh_primitive_edge_visibility
    double crease_deg = 40;                       ///< of codes and edges
    /// Which pose of a model that moves stands in its scene, "at rest" or "at 1.5 s": what the file
    /// is to say of it. Empty: it does not move.
    std::string pose{};
    bool repair = false;  ///< codes are surface8's, and repaired by views of the model
    /// The same scene with an animation each, of whose poses they are, too; and what the file is to
    /// say of these: "walk", "all".
    std::vector<scene::Scene> motions{};
    std::string animation{};
};

/// "surface8", "label8".
[[nodiscard]] std::string name(methods::BakedMethod method);

/// A baked file, not yet written.
struct BakedFile {
    std::string bytes;
    std::vector<std::string> lines;  ///< what was done, a sentence each
    bool is_unchanged = false;       ///< all that was asked for was there already
    std::size_t vertices = 0;        ///< of what was given codes, before
    std::size_t added_vertices = 0;
};

/// The glTF file at `from`, which `model` was imported from, with what the options ask for, made of
/// the model as it stands; of the kind that the ending of `to` says. All else in it stays as it is.
///
/// A file that has it all already comes back byte for byte if it is of that kind. Throws
/// core::Error (where = `from`) for what cannot be baked, and (where = `to`) for what cannot be
/// written there.
[[nodiscard]] BakedFile bake(const std::filesystem::path& from,
                             const import::ImportedModel& model,
                             const BakeOptions& options,
                             const std::filesystem::path& to);

/// Whether a model was read from a glTF file.
[[nodiscard]] bool is_gltf(const import::ImportedModel& model);

/// Gives normals to the meshes that have none: those of smooth patches, which creases part. A
/// vertex that has several is copied, with its own of the meshes' `texcoords`, if any; triangles
/// and their corners keep their order. For a scene that is not to move.
void add_normals(scene::Scene& scene,
                 double crease_deg,
                 std::span<std::vector<glm::vec2>> texcoords = {});

/// What the shaders of surface_lookup and chords read of a glTF model, for a file beside its own.
///
/// Words of 32 bits, little-endian: how many faces, parts and points follow; eight words a face
/// (methods::LookupTable::Face); of a part, which one draw call draws, the file's node and the
/// primitive in the mesh there; of a point its part and the vertex. A point moves as that vertex
/// does. Throws core::Error for copies of a mesh in one node, and as methods::lookup_table().
[[nodiscard]] std::string lookup_file(const import::ImportedModel& model, double crease_deg);

}  // namespace ink::bake
