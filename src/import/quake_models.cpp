#include "import/quake_models.h"

#include <algorithm>
#include <array>
#include <cassert>
#include <string_view>
#include <system_error>

namespace ink::import {
namespace {

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
