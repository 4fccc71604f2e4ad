#include "import/quake_models.h"

#include <algorithm>
#include <array>
#include <cassert>
#include <string_view>
#include <system_error>

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

// The corners of an icosahedron whose edges are cut in four and pushed out to the unit sphere, in
// id Software's order. Their coordinates have only so many sizes: a letter each, a capital for less
// than 0.
constexpr std::array kSizes{0.0F,      0.147621F, 0.162460F, 0.238856F, 0.262866F, 0.295242F,
                            0.309017F, 0.425325F, 0.442863F, 0.5F,      0.525731F, 0.587785F,
                            0.681718F, 0.688191F, 0.716567F, 0.809017F, 0.850651F, 0.864188F,
                            0.951056F, 0.955423F, 1.0F};
constexpr std::string_view kLetters =
    "KaqIdrFatGjpCesaauaqkBombomakqgjpkaqfatidrcesMboPgjLhnQkaRidOmbNlhJpgDriHnlOmBJpG"
    "KqaaqKDrIatFEsCauaatfEscdriescjpgdrIesCjpGqkaombomBkqahnlridnlhpgjmbolhntfauaasce"
    "qKatFarIdsCepGjmBoqakriDpgJscEkaQmbOmBOqaKpGJrIDsCEboMgjPhnLidRlhNnlHBoMGjPakQKaQ"
    "IdRFaTCeSaaUfaTceSIDRGJPCESaQKBOMbOMaKQgJPiDRcESdRIjPGhNLoMBnLHlHNaTFaUaeSCaQkaTf"
    "dRieScjPgoMbkQaDRIJPGESCQKaOMBOMbKQaJPgDRiEScRIdPGjNLhMBoIDrLHnGJpBOmHNlCEsiDrcEs"
    "gJpbOmaKqhNllHnnLhTfaSceUaaQakTFaSCeRiDScEPgJRIDSCEPGJMbOMBOQaKNlHLhNHnLHNLLHNNLH";
static_assert(kLetters.size() == 3 * kQuakeNormals);

float coordinate(char letter) {
    const bool is_negative = letter < 'a';
    const float size = kSizes[static_cast<std::size_t>(letter - (is_negative ? 'A' : 'a'))];
    return is_negative ? -size : size;
}

/// The magic word and the version.
struct Kind {
    std::array<char, 4> magic{};
    std::int32_t version = 0;
    bool operator==(const Kind&) const = default;
};
constexpr Kind kMdl{{'I', 'D', 'P', 'O'}, 6};
constexpr Kind kMd2{{'I', 'D', 'P', '2'}, 8};
constexpr Kind kMd3{{'I', 'D', 'P', '3'}, 15};

Kind kind_of(const std::filesystem::path& path) {
    const auto head = read_file(path, sizeof(Kind));
    return head && head->size() == sizeof(Kind) ? number_at<Kind>(*head, 0) : Kind{};
}

/// The files that make up the player of which `path` is a part, or `path` alone.
std::vector<Md3File> md3_files(const std::filesystem::path& path) {
    constexpr std::array kParts{"lower", "upper", "head"};
    const std::string stem = path.stem().string();
    const std::size_t end = std::min(stem.find_last_of('_'), stem.size());
    const bool is_part = std::ranges::find(kParts, lower_case(stem.substr(0, end))) != kParts.end();
    std::vector<Md3File> files;
    for (const char* part : kParts) {
        if (!is_part) break;
        const auto file =
            path.parent_path() / (part + stem.substr(end) + path.extension().string());
        std::error_code error;
        // A pipe in place of a part would keep us waiting.
        if (!std::filesystem::is_regular_file(file, error)) break;
        const std::string called = file.filename().string();
        files.push_back({part, ModelBytes(file == path ? "" : called, bytes_of(file))});
    }
    if (files.size() < kParts.size()) {
        files.clear();
        files.push_back({stem, ModelBytes("", bytes_of(path))});
    }
    return files;
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

glm::vec3 quake_normal(std::size_t index) {
    assert(index < kQuakeNormals);
    const std::size_t at = 3 * index;
    return {coordinate(kLetters[at]), coordinate(kLetters[at + 1]), coordinate(kLetters[at + 2])};
}

glm::dmat4 y_up_from_quake() {
    return {1, 0, 0, 0, 0, 0, -1, 0, 0, 1, 0, 0, 0, 0, 0, 1};
}

void append_packed_frame(const ModelBytes& file,
                         std::uint64_t offset,
                         std::size_t vertices,
                         const glm::vec3& scale,
                         const glm::vec3& origin,
                         scene::VertexFrames& frames) {
    file.need(offset, vertices, sizeof(PackedVertex), "vertices");
    for (std::size_t v = 0; v < vertices; ++v) {
        const std::uint64_t at = offset + v * sizeof(PackedVertex);
        const auto packed = file.at<PackedVertex>(at);
        const glm::vec3 steps{packed.p[0], packed.p[1], packed.p[2]};
        frames.positions.push_back(steps * scale + origin);
        frames.normals.push_back(
            quake_normal(file.index_at<std::uint8_t>(at + 3, "normal", kQuakeNormals)));
    }
    ++frames.frame_count;
}

ImportReply reply_of_frames(const std::string& name,
                            std::vector<scene::Triangle> triangles,
                            scene::VertexFrames frames,
                            double frames_per_s) {
    ImportReply reply;
    const auto vertices = static_cast<std::ptrdiff_t>(frames.positions.size() / frames.frame_count);
    ImportedMesh mesh;
    mesh.name = name;
    mesh.positions.assign(frames.positions.begin(), frames.positions.begin() + vertices);
    mesh.normals.assign(frames.normals.begin(), frames.normals.begin() + vertices);
    mesh.triangles = std::move(triangles);
    reply.meshes.push_back(std::move(mesh));
    reply.instances.push_back({0, y_up_from_quake(), name});
    if (frames.frame_count < 2) return reply;
    scene::Animation animation;
    animation.frames_per_s = frames_per_s;
    animation.duration_s = static_cast<double>(frames.frame_count - 1) / frames_per_s;
    animation.node_of_instance = {scene::kNoNode};
    animation.vertex_frames.push_back(std::move(frames));
    reply.animation = std::move(animation);
    return reply;
}

std::optional<ImportReply> read_quake_model(const std::filesystem::path& path) {
    const Kind kind = kind_of(path);
    const std::string name = path.stem().string();
    if (kind == kMdl) return read_mdl({"", bytes_of(path)}, name);
    if (kind == kMd2) return read_md2({"", bytes_of(path)}, name);
    if (kind == kMd3) return read_md3(md3_files(path));
    return std::nullopt;
}

}  // namespace ink::import
