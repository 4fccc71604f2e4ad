#include "import/quake_models.h"

namespace ink::import {
namespace {

constexpr double kGameFramesPerSecond = 10;  // of the games

// Quake's MDL, version 6: header, skins, texture coordinates, triangles, frames, one behind the
// other. Numbers are 32 bits.

constexpr std::uint64_t kPackedHeaderBytes = 84;
constexpr std::uint64_t kTextureBytes = 12;         // on seam, s, t
constexpr std::uint64_t kPackedTriangleBytes = 16;  // faces front, three vertices
// A frame's box, and its name of 16 characters.
constexpr std::uint64_t kFrameHeadBytes = 24;

struct Header {
    glm::vec3 scale{1};
    glm::vec3 origin{0};
    std::uint64_t skins = 0;
    std::uint64_t skin_bytes = 0;
    std::uint64_t vertices = 0;
    std::uint64_t triangles = 0;
    std::uint64_t frames = 0;
};

Header read_header(const ModelBytes& file) {
    Header header;
    header.scale = file.at<glm::vec3>(8);
    header.origin = file.at<glm::vec3>(20);
    header.skins = file.count_at(48, "skins", 0);
    header.skin_bytes =
        file.count_at(52, "px of skin width", 0) * file.count_at(56, "px of skin height", 0);
    header.vertices = file.count_at(60, "vertices", 1);
    header.triangles = file.count_at(64, "triangles", 1);
    header.frames = file.count_at(68, "frames", 1);
    return header;
}

/// The offset behind the skins that begin at `offset`: single ones, or groups with a time each.
std::uint64_t skip_skins(const ModelBytes& file, const Header& header, std::uint64_t offset) {
    for (std::uint64_t s = 0; s < header.skins; ++s) {
        const bool is_group = file.at<std::int32_t>(offset) != 0;
        offset += 4;
        std::uint64_t images = 1;
        if (is_group) {
            images = file.count_at(offset, "images in a group of skins", 1);
            offset += 4;
            file.need(offset, images, 4, "times of skins");
            offset += 4 * images;
        }
        if (header.skin_bytes > 0) file.need(offset, images, header.skin_bytes, "skins");
        offset += images * header.skin_bytes;
    }
    return offset;
}

std::vector<scene::Triangle> read_triangles(const ModelBytes& file,
                                            const Header& header,
                                            std::uint64_t offset) {
    file.need(offset, header.triangles, kPackedTriangleBytes, "triangles");
    return quake_triangles<std::int32_t>(
        file, offset + 4, header.triangles, kPackedTriangleBytes, header.vertices);
}

/// All frames, those of groups one after the other. A group's own times are not kept.
scene::VertexFrames read_frames(const ModelBytes& file,
                                const Header& header,
                                std::uint64_t offset) {
    scene::VertexFrames frames;
    const auto take_one = [&] {
        file.need(offset, 1, kFrameHeadBytes, "frame");
        append_packed_frame(
            file, offset + kFrameHeadBytes, header.vertices, header.scale, header.origin, frames);
        offset += kFrameHeadBytes + header.vertices * sizeof(PackedVertex);
    };
    for (std::uint64_t f = 0; f < header.frames; ++f) {
        const bool is_group = file.at<std::int32_t>(offset) != 0;
        offset += 4;
        std::uint64_t poses = 1;
        if (is_group) {
            poses = file.count_at(offset, "frames in a group", 1);
            offset += 12;  // and a box
            file.need(offset, poses, 4, "times of frames");
            offset += 4 * poses;
        }
        for (std::uint64_t p = 0; p < poses; ++p)
            take_one();
    }
    return frames;
}

// Quake II's MD2, version 8: a header of counts and offsets, then the parts anywhere.

constexpr std::uint64_t kMd2TriangleBytes =
    12;  // three vertices, three texture coordinates, 16 bits
// A frame's scale and origin, and its name of 16 characters.
constexpr std::uint64_t kMd2FrameHeadBytes = 40;

std::vector<scene::Triangle> read_triangles(const ModelBytes& file, std::uint64_t vertices) {
    const std::uint64_t count = file.count_at(32, "triangles", 1);
    const std::uint64_t offset = file.count_at(52, "as the triangles' offset", 0);
    file.need(offset, count, kMd2TriangleBytes, "triangles");
    return quake_triangles<std::uint16_t>(file, offset, count, kMd2TriangleBytes, vertices);
}

scene::VertexFrames read_frames(const ModelBytes& file, std::uint64_t vertices) {
    const std::uint64_t count = file.count_at(40, "frames", 1);
    const std::uint64_t offset = file.count_at(56, "as the frames' offset", 0);
    const std::uint64_t frame_bytes = file.count_at(16, "bytes a frame", 1);
    if (frame_bytes < kMd2FrameHeadBytes + vertices * sizeof(PackedVertex)) {
        file.fail(
            16,
            std::to_string(frame_bytes) + " bytes a frame",
            std::to_string(kMd2FrameHeadBytes + vertices * sizeof(PackedVertex)) + " or more");
    }
    file.need(offset, count, frame_bytes, "frames");
    scene::VertexFrames frames;
    for (std::uint64_t f = 0; f < count; ++f) {
        const std::uint64_t at = offset + f * frame_bytes;
        append_packed_frame(file,
                            at + kMd2FrameHeadBytes,
                            vertices,
                            file.at<glm::vec3>(at),
                            file.at<glm::vec3>(at + 12),
                            frames);
    }
    return frames;
}

}  // namespace

ImportReply read_mdl(const ModelBytes& file, const std::string& name) {
    const Header header = read_header(file);
    std::uint64_t offset = skip_skins(file, header, kPackedHeaderBytes);
    file.need(offset, header.vertices, kTextureBytes, "texture coordinates");
    offset += header.vertices * kTextureBytes;
    auto triangles = read_triangles(file, header, offset);
    offset += header.triangles * kPackedTriangleBytes;
    return reply_of_frames(
        name, std::move(triangles), read_frames(file, header, offset), kGameFramesPerSecond);
}

ImportReply read_md2(const ModelBytes& file, const std::string& name) {
    const std::uint64_t vertices = file.count_at(24, "vertices", 1);
    auto triangles = read_triangles(file, vertices);
    return reply_of_frames(
        name, std::move(triangles), read_frames(file, vertices), kGameFramesPerSecond);
}

}  // namespace ink::import
