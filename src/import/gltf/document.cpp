#include "import/gltf/document.h"

#include <algorithm>
#include <cctype>
#include <cstdint>
#include <limits>
#include <nlohmann/json.hpp>
#include <string_view>

#include "core/error.h"
#include "import/model_bytes.h"

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

constexpr std::uint32_t kMagic = 0x46546c67;   // "glTF"
constexpr std::uint32_t kJson = 0x4e4f534a;    // "JSON"
constexpr std::uint32_t kBinary = 0x004e4942;  // "BIN"
constexpr std::size_t kHeaderBytes = 12;
constexpr std::size_t kChunkHeaderBytes = 8;
constexpr const char* kAccepted = "glTF 2.0";

constexpr auto word_at = number_at<std::uint32_t>;

bool is_binary(std::span<const std::byte> bytes) {
    return bytes.size() >= kHeaderBytes && word_at(bytes, 0) == kMagic;
}

/// Whether it is JSON that speaks of an asset: what all glTF files do, and no other model file.
bool is_text(std::span<const std::byte> bytes) {
    const std::string_view text = without_mark(text_of(bytes));
    const auto first = std::find_if(
        text.begin(), text.end(), [](unsigned char c) { return std::isspace(c) == 0; });
    return first != text.end() && *first == '{' && text.find("\"asset\"") != std::string_view::npos;
}

/// The chunks of a .glb (glTF 2.0, section 4.4): its JSON is returned, its binary goes into
/// `document`. Others are passed over, as they must be.
std::span<const std::byte> json_chunk(GltfDocument& document) {
    const std::span<const std::byte> file = document.bytes;
    const auto fail = [](std::size_t offset, const std::string& what, const std::string& accepted) {
        throw core::Error("", "byte " + std::to_string(offset) + ": " + what, accepted);
    };
    const std::uint32_t version = word_at(file, 4);
    if (version != 2)
        throw Refusal("", "glTF " + std::to_string(version) + " is not read", kAccepted);
    const std::uint32_t length = word_at(file, 8);
    if (length < kHeaderBytes || length > file.size()) {
        fail(8,
             "a length of " + std::to_string(length),
             std::to_string(kHeaderBytes) + ".." + std::to_string(file.size()));
    }
    std::span<const std::byte> json;
    for (std::size_t at = kHeaderBytes, chunk = 0; at < length; ++chunk) {
        if (length - at < kChunkHeaderBytes) fail(at, "half a chunk", "chunks with their headers");
        const std::size_t size = word_at(file, at);
        const std::uint32_t type = word_at(file, at + 4);
        const std::size_t left = length - at - kChunkHeaderBytes;
        if (size > left) {
            fail(at, "a chunk of " + std::to_string(size) + " bytes", "0.." + std::to_string(left));
        }
        const auto content = file.subspan(at + kChunkHeaderBytes, size);
        if ((chunk == 0) != (type == kJson)) fail(at, "a chunk out of order", "JSON first, once");
        if (chunk == 0) json = content;
        if (chunk == 1 && type == kBinary) {
            document.binary = content;
            document.has_binary = true;
        }
        at += kChunkHeaderBytes + size;
    }
    return json;
}

void check_version(const JsonObject& asset, const nlohmann::json& json) {
    // Files of glTF 1.0 may have a number there.
    const nlohmann::json version_json = json.value("version", nlohmann::json());
    const std::string version =
        version_json.is_number() ? version_json.dump() : asset.text("version");
    if (!version.starts_with("2.")) asset.refuse("glTF " + version + " is not read", kAccepted);
    const std::string least = asset.text("minVersion");
    if (!least.empty() && least != "2.0") asset.refuse("it needs glTF " + least, kAccepted);
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

std::optional<GltfDocument> open_gltf(const std::filesystem::path& path) {
    return parse_gltf(bytes_of(path), path.parent_path());
}

std::optional<GltfDocument> parse_gltf(std::vector<std::byte> bytes,
                                       const std::filesystem::path& folder) {
    GltfDocument document;
    document.folder = folder;
    document.bytes = std::move(bytes);
    const bool is_glb = is_binary(document.bytes);
    if (!is_glb && !is_text(document.bytes)) return std::nullopt;
    document.text = is_glb ? json_chunk(document) : std::span<const std::byte>(document.bytes);
    const auto json = std::make_shared<nlohmann::json>(parse_json(document.text));
    document.json = json;
    const JsonObject root = document.root();
    check_version(root.at("asset"), (*json)["asset"]);
    document.accessors = root.list("accessors", "accessor");
    document.buffer_views = root.list("bufferViews", "bufferView");
    document.buffers = root.list("buffers", "buffer");
    document.meshes = root.list("meshes", "mesh");
    document.nodes = root.list("nodes", "node");
    document.scenes = root.list("scenes", "scene");
    document.skins = root.list("skins", "skin");
    document.animations = root.list("animations", "animation");
    document.cameras = root.list("cameras", "camera");
    document.materials = root.list("materials", "material");
    return document;
}

}  // namespace ink::import
