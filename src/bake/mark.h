#pragma once

#include <optional>
#include <string>

#include "bake/gltf_edit.h"
#include "scene/scene.h"

namespace ink::bake {

/// What extras.inkbench says of a baked file, at its asset or, where that has no room, at its root.
struct Mark {
    std::string version;  ///< of the program
    std::string mesh;     ///< mesh_hash
    std::string pose;     ///< BakeOptions::pose
    Json codes;  ///< {"method", "crease_deg"[, "channel"][, "repaired"][, "animation"]}; null: none
    Json edges;  ///< {"crease_deg"}; null: none

    [[nodiscard]] bool operator==(const Mark&) const = default;
};

/// The mark in a file's JSON; nothing if it has none.
[[nodiscard]] std::optional<Mark> read_mark(const Json& gltf);

/// Writes it beside the user's own extras. Throws core::Error if neither place has room.
void write_mark(Json& gltf, const Mark& mark);

/// A hash of the placed triangles of a scene, sixteen digits: the same whichever corner of a
/// triangle comes first, and however vertices are numbered.
[[nodiscard]] std::string mesh_hash(const scene::Scene& scene);

}  // namespace ink::bake
