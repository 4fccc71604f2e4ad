#include "import/gltf/glb.h"

#include <cstdint>
#include <limits>

#include "core/error.h"

namespace ink::import {
namespace {

void append_word(std::string& bytes, std::size_t value) {
    for (int i = 0; i < 4; ++i)
        bytes += static_cast<char>(value >> (8 * i) & 0xff);
}

std::size_t up_to_word(std::size_t size) {
    return (size + 3) / 4 * 4;
}

void append_chunk(std::string& glb, std::string_view chunk, const char* type, char padding) {
    const std::size_t size = up_to_word(chunk.size());
    append_word(glb, size);
    glb.append(type, 4);
    glb += chunk;
    glb.append(size - chunk.size(), padding);
}

}  // namespace

std::string glb_bytes(std::string_view json,
                      std::string_view binary,
                      const std::filesystem::path& path) {
    constexpr std::size_t kHead_bytes = 12, kChunkHead_bytes = 8;
    std::size_t size = kHead_bytes + kChunkHead_bytes + up_to_word(json.size());
    if (!binary.empty()) size += kChunkHead_bytes + up_to_word(binary.size());
    if (size > std::numeric_limits<std::uint32_t>::max())
        throw core::Error(path.string(), "the scene is too large for binary glTF", "4 GiB");
    std::string glb = "glTF";
    glb.reserve(size);
    append_word(glb, 2);
    append_word(glb, size);
    append_chunk(glb, json, "JSON", ' ');
    if (!binary.empty()) append_chunk(glb, binary, "BIN\0", '\0');
    return glb;
}

}  // namespace ink::import
