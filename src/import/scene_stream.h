#pragma once

#include <cstddef>
#include <cstdint>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "core/byte_stream.h"
#include "scene/animation.h"
#include "scene/scene.h"

namespace ink::import {

/// How the import child fared.
enum class ImportStatus : std::uint32_t {
    scene,           ///< the rest of the reply holds
    wrong_content,   ///< no reader recognises it, though its extension is known
    unknown_format,  ///< no reader takes it, and its extension is not known either
    damaged,         ///< a reader of ours found a fault; `reason` says where and what
    refused,         ///< a reader of ours knows what it is and does not read it: `reason` names it
    out_of_memory,
};

/// A run of a mesh's triangles that the file keeps together: of one material, and in glTF one
/// primitive. With it each corner leads back into the file: corner c of triangle t of the part is
/// vertex `triangles[t][c] - first_vertex` of primitive `primitive` of the instance's file node.
struct MeshPart {
    std::uint32_t first_triangle = 0;  ///< it ends where the next part begins
    std::uint32_t material = 0;        ///< unique within the file
    std::uint32_t primitive = 0;       ///< its number in the file's mesh; 0 where files have none
    std::uint32_t first_vertex = 0;    ///< the mesh's position that is the primitive's vertex 0
};

/// All triangles of one object, as the file has them.
struct ImportedMesh {
    std::string name;
    std::vector<glm::dvec3> positions;  ///< object space, no digit of the file lost
    /// One per position, of any length (a vertex without one has (0,0,0)); or empty.
    std::vector<glm::vec3> normals;
    /// 1 - v of the file, as glTF has v; one per position, (0,0) where there is none; or empty.
    std::vector<glm::vec2> texcoords;
    std::vector<scene::Triangle> triangles;
    std::vector<std::uint8_t> marked_sides;  ///< as scene::Mesh has them
    std::vector<MeshPart> parts;  ///< by first_triangle, the first at 0; empty: one of material 0
    /// Whether the file's coordinates are floats, already rounded to that where they stand.
    bool are_floats = false;
    /// How far that may have moved a vertex, if more than floats say where the mesh is taken to
    /// (take_out_origin). Not part of the stream.
    double rounding = 0;
};

/// A use of a mesh.
struct ImportedInstance {
    std::uint32_t mesh = 0;
    glm::dmat4 world_from_object{1};
    std::string name;                          ///< UTF-8, as the file has it
    std::uint32_t file_node = scene::kNoNode;  ///< its number in the file; kNoNode: files have none
};

/// A camera as a file gives it, made world space.
struct ImportedCamera {
    std::string name;
    glm::dvec3 eye_world{0};
    glm::dvec3 target_world{0};
    glm::dvec3 up_world{0};
    double fov_y_rad = 0;                 ///< of a pinhole
    std::uint32_t node = scene::kNoNode;  ///< of the reply's animation, in whose zero it stands
    double height_world = 0;              ///< that a parallel camera sees, else 0
};

/// What sends light. Shading knows lamps that shine to all sides alone: see take_lights.
enum class LightKind : std::uint32_t {
    point,
    spot,
    distant,  ///< as the sun does, from one side and everywhere alike
};

/// A light as a file gives it, made world space.
struct ImportedLight {
    LightKind kind = LightKind::point;
    glm::dvec3 p_world{0};
    glm::dvec3 direction_world{0};  ///< where the light of a distant one goes, of any length
    glm::vec3 color{1};             ///< times its strength
    /// Whether the strength is in candela, in lux that of a distant one; else a share of full
    /// light.
    bool is_physical = false;
    double range = 0;                     ///< world units, as scene::OmniLight has it
    std::uint32_t node = scene::kNoNode;  ///< of the reply's animation, with which it goes
};

/// What the user may choose of a model.
struct ModelChoice {
    /// Which animation moves the scene: a name that the file has, else a number from 0; empty: the
    /// first.
    std::string animation;
    /// Objects of several materials become one object for each, so that seams stand between
    /// materials, too. The import child is not told.
    bool material_seams = false;
    bool has_texcoords = false;  ///< OBJ's are kept, which splits vertices
    [[nodiscard]] bool operator==(const ModelChoice&) const = default;
};

/// What the import child hands back. Nothing in it is checked: whoever reads it must not trust it.
struct ImportReply {
    ImportStatus status = ImportStatus::scene;
    std::string reason;
    std::vector<ImportedMesh> meshes;
    std::vector<ImportedInstance> instances;
    std::vector<ImportedCamera> cameras;
    std::vector<ImportedLight> lights;
    std::vector<std::string> animation_names;  ///< of all that the file has; "" has no name
    /// What in the file does not count here, a few words each: "2 materials of mode BLEND are drawn
    /// opaque". Never something that changes geometry.
    std::vector<std::string> notes;
    /// By material number the colour and the opacity of its faces before light and textures, in the
    /// file's own numbers, white where it says nothing; materials beyond the last have none.
    std::vector<glm::vec4> base_colors;
    /// Skins and morphs come without positions and normals: those of their mesh hold.
    std::optional<scene::Animation> animation{};
};

/// Writes `reply` as one binary stream: magic, version, counts, arrays, end mark; native byte
/// order, for it never leaves the machine.
void write_reply(const ImportReply& reply, const core::ByteSink& sink);

/// The reply in `stream`, or nothing if that is not exactly one whole reply.
///
/// Allocates no more than a small multiple of the stream's size, whatever counts it claims. Indices
/// and numbers come as they stand.
[[nodiscard]] std::optional<ImportReply> read_reply(std::span<const std::byte> stream);

/// The number of the animation that `asked` means among `names`: one called so, else the one of
/// that number; the first if nothing is asked. Throws Refusal that lists them.
[[nodiscard]] std::size_t choose_animation(const std::vector<std::string>& names,
                                           const std::string& asked);

}  // namespace ink::import
