#pragma once

#include <filesystem>
#include <optional>

#include "import/model_bytes.h"
#include "import/scene_stream.h"

namespace ink::import {

/// How many normals the vertices of MDL and MD2 files choose from.
inline constexpr std::size_t kQuakeNormals = 162;

/// Normal number `index` (below kQuakeNormals), unit to six digits, in the model's z-up axes.
[[nodiscard]] glm::vec3 quake_normal(std::size_t index);

/// The scene with all its frames in a Quake model: MDL (IDPO, version 6), MD2 (IDP2, 8), MD3 (IDP3,
/// 15). Nothing for other files.
///
/// Vertices as stored (z up), a root node that turns z up to y up, triangles turned to
/// counter-clockwise; vertices stay shared. Where `lower`, `upper` and `head` of a
/// Quake III player lie side by side (with one suffix), opening any of them gives all three, hung
/// on each other's tags. Throws core::Error for a damaged file.
[[nodiscard]] std::optional<ImportReply> read_quake_model(const std::filesystem::path& path);

// One format each; what `read_quake_model` calls.
[[nodiscard]] ImportReply read_mdl(const ModelBytes& file, const std::string& name);
[[nodiscard]] ImportReply read_md2(const ModelBytes& file, const std::string& name);

/// A file of a Quake III model by its part's name.
struct Md3File {
    std::string part;
    ModelBytes bytes;
};
/// One file, or lower, upper and head in this order.
[[nodiscard]] ImportReply read_md3(const std::vector<Md3File>& files);

/// Turns Quake's axes (z up) into ours: x, z, -y.
[[nodiscard]] glm::dmat4 y_up_from_quake();

/// `count` triangles of three vertex numbers each, from `offset` on every `stride` bytes, turned.
template <class Index>
std::vector<scene::Triangle> quake_triangles(const ModelBytes& file,
                                             std::uint64_t offset,
                                             std::uint64_t count,
                                             std::uint64_t stride,
                                             std::uint64_t vertices) {
    std::vector<scene::Triangle> triangles(count);
    for (std::uint64_t t = 0; t < count; ++t) {
        for (std::uint64_t c = 0; c < 3; ++c) {
            const std::uint64_t at = offset + t * stride + c * sizeof(Index);
            triangles[t][2 - c] = file.index_at<Index>(at, "a triangle of vertex", vertices);
        }
    }
    return triangles;
}

/// A vertex of MDL and MD2: a place in a box of 256 steps each way, and a normal's number.
struct PackedVertex {
    std::uint8_t p[3];
    std::uint8_t normal;
};
/// A frame of packed vertices, appended to `frames`. Throws for a normal that is none.
void append_packed_frame(const ModelBytes& file,
                         std::uint64_t offset,
                         std::size_t vertices,
                         const glm::vec3& scale,
                         const glm::vec3& origin,
                         scene::VertexFrames& frames);

/// The reply for one mesh on one node; its shape is the first frame.
[[nodiscard]] ImportReply reply_of_frames(const std::string& name,
                                          std::vector<scene::Triangle> triangles,
                                          scene::VertexFrames frames,
                                          double frames_per_s);

}  // namespace ink::import
