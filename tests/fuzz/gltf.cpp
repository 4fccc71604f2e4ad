// Any glTF file gives a sound scene or an Error. A file is given as its JSON, a zero byte, and its
// binary chunk, so that made-up ones have the right lengths; what begins with "glTF" is a .glb.

#include <algorithm>
#include <array>
#include <vector>

#include "import/gltf/gltf_reader.h"
#include "tests/fuzz/fuzz.h"

namespace ink::fuzz {
namespace {

using FileBytes = std::vector<std::byte>;

void put_word(std::size_t value, FileBytes& file) {
    for (int shift = 0; shift < 32; shift += 8)
        file.push_back(static_cast<std::byte>(value >> shift & 0xff));
}

void put_chunk(Bytes content, std::uint32_t type, FileBytes& file) {
    put_word(content.size(), file);
    put_word(type, file);
    const auto bytes = std::as_bytes(content);
    file.insert(file.end(), bytes.begin(), bytes.end());
}

FileBytes glb_of(Bytes bytes) {
    constexpr std::uint32_t kMagic = 0x46546c67, kJson = 0x4e4f534a, kBinary = 0x004e4942;
    const auto zero = std::find(bytes.begin(), bytes.end(), std::uint8_t{0});
    const auto json_size = static_cast<std::size_t>(zero - bytes.begin());
    const Bytes binary = bytes.subspan(std::min(json_size + 1, bytes.size()));
    FileBytes file;
    put_word(kMagic, file);
    put_word(2, file);
    put_word(28 + json_size + binary.size(), file);
    put_chunk(bytes.first(json_size), kJson, file);
    put_chunk(binary, kBinary, file);
    return file;
}

bool is_whole(Bytes bytes) {
    constexpr std::array<std::uint8_t, 4> kMagic{'g', 'l', 'T', 'F'};
    return bytes.size() >= 4 && std::equal(kMagic.begin(), kMagic.end(), bytes.begin());
}

/// Every part of a mesh leads back to vertices that the mesh has.
void check_parts(const import::ImportReply& reply) {
    for (const import::ImportedMesh& mesh : reply.meshes)
        for (std::size_t p = 0; p < mesh.parts.size(); ++p) {
            const std::size_t end = p + 1 < mesh.parts.size() ? mesh.parts[p + 1].first_triangle
                                                              : mesh.triangles.size();
            for (std::size_t t = mesh.parts[p].first_triangle; t < end; ++t)
                for (const std::uint32_t v : mesh.triangles[t])
                    expect(v >= mesh.parts[p].first_vertex && v < mesh.positions.size(),
                           "a corner is a vertex of its primitive");
        }
}

}  // namespace

void check_gltf(Bytes bytes) {
    const auto all = std::as_bytes(bytes);
    const auto reply = unless_refused([&]() -> std::optional<import::ImportReply> {
        const auto document = import::parse_gltf(
            is_whole(bytes) ? FileBytes(all.begin(), all.end()) : glb_of(bytes), "absent");
        if (!document) return std::nullopt;
        return import::read_gltf(*document, {});
    });
    if (!reply || !*reply) return;
    check_parts(**reply);
    expect_scene_or_error(**reply);
}

}  // namespace ink::fuzz
