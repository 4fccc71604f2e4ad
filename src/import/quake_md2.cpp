// Quake II's MD2, version 8: a header of counts and offsets, then the parts anywhere.

#include "import/quake_models.h"

namespace ink::import {
namespace {

constexpr double kFramesPerSecond = 10;       // of the game
constexpr std::uint64_t kTriangleBytes = 12;  // three vertices, three texture coordinates, 16 bits
// A frame's scale and origin, and its name of 16 characters.
constexpr std::uint64_t kFrameHeadBytes = 40;

std::vector<scene::Triangle> read_triangles(const ModelBytes& file, std::uint64_t vertices) {
    const std::uint64_t count = file.count_at(32, "triangles", 1);
    const std::uint64_t offset = file.count_at(52, "as the triangles' offset", 0);
    file.need(offset, count, kTriangleBytes, "triangles");
    std::vector<scene::Triangle> triangles(count);
    for (std::uint64_t t = 0; t < count; ++t) {
        for (std::uint64_t c = 0; c < 3; ++c) {
            const std::uint64_t at = offset + t * kTriangleBytes + 2 * c;
            triangles[t][2 - c] =
                file.index_at<std::uint16_t>(at, "a triangle of vertex", vertices);
        }
    }
    return triangles;
}

scene::VertexFrames read_frames(const ModelBytes& file, std::uint64_t vertices) {
    const std::uint64_t count = file.count_at(40, "frames", 1);
    const std::uint64_t offset = file.count_at(56, "as the frames' offset", 0);
    const std::uint64_t frame_bytes = file.count_at(16, "bytes a frame", 1);
    if (frame_bytes < kFrameHeadBytes + vertices * sizeof(PackedVertex)) {
        file.fail(16,
                  std::to_string(frame_bytes) + " bytes a frame",
                  std::to_string(kFrameHeadBytes + vertices * sizeof(PackedVertex)) + " or more");
    }
    file.need(offset, count, frame_bytes, "frames");
    scene::VertexFrames frames;
    for (std::uint64_t f = 0; f < count; ++f) {
        const std::uint64_t at = offset + f * frame_bytes;
        append_packed_frame(file,
                            at + kFrameHeadBytes,
                            vertices,
                            file.at<glm::vec3>(at),
                            file.at<glm::vec3>(at + 12),
                            frames);
    }
    return frames;
}

}  // namespace

ImportReply read_md2(const ModelBytes& file, const std::string& name) {
    const std::uint64_t vertices = file.count_at(24, "vertices", 1);
    auto triangles = read_triangles(file, vertices);
    return reply_of_frames(
        name, std::move(triangles), read_frames(file, vertices), kFramesPerSecond);
}

}  // namespace ink::import
