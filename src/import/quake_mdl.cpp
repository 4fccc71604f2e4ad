// Quake's MDL, version 6: header, skins, texture coordinates, triangles, frames, one behind the
// other. Numbers are 32 bits.

#include "import/quake_models.h"

namespace ink::import {
namespace {

constexpr double kFramesPerSecond = 10;  // of the game
constexpr std::uint64_t kHeaderBytes = 84;
constexpr std::uint64_t kTextureBytes = 12;   // on seam, s, t
constexpr std::uint64_t kTriangleBytes = 16;  // faces front, three vertices
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
    file.need(offset, header.triangles, kTriangleBytes, "triangles");
    std::vector<scene::Triangle> triangles(header.triangles);
    for (std::uint64_t t = 0; t < header.triangles; ++t) {
        const std::uint64_t at = offset + t * kTriangleBytes + 4;
        for (std::uint64_t c = 0; c < 3; ++c) {
            triangles[t][2 - c] =
                file.index_at<std::int32_t>(at + 4 * c, "a triangle of vertex", header.vertices);
        }
    }
    return triangles;
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

}  // namespace

ImportReply read_mdl(const ModelBytes& file, const std::string& name) {
    const Header header = read_header(file);
    std::uint64_t offset = skip_skins(file, header, kHeaderBytes);
    file.need(offset, header.vertices, kTextureBytes, "texture coordinates");
    offset += header.vertices * kTextureBytes;
    auto triangles = read_triangles(file, header, offset);
    offset += header.triangles * kTriangleBytes;
    return reply_of_frames(
        name, std::move(triangles), read_frames(file, header, offset), kFramesPerSecond);
}

}  // namespace ink::import
