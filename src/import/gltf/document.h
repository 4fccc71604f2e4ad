#pragma once

#include <filesystem>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "import/gltf/json.h"

namespace ink::import {

/// The bytes of a .glb (glTF 2.0, section 4.4): `json`, and `binary` as the chunk of its first
/// buffer, which is left out if it is empty. Throws core::Error (where = `path`) if they need more
/// than the 4 GiB that the format holds.
[[nodiscard]] std::string glb_bytes(std::string_view json,
                                    std::string_view binary,
                                    const std::filesystem::path& path);

/// A glTF 2.0 file: its JSON, and the binary chunk of a .glb.
struct GltfDocument {
    std::filesystem::path folder;     ///< of the file
    std::vector<std::byte> bytes;     ///< the whole file
    std::span<const std::byte> text;  ///< its JSON, in `bytes`
    std::shared_ptr<const nlohmann::json> json;
    std::span<const std::byte> binary;  ///< in `bytes`
    bool has_binary = false;

    // The lists of the JSON that models are made of.
    std::vector<JsonObject> accessors, buffer_views, buffers, meshes, nodes, scenes, skins,
        animations, cameras, materials;

    [[nodiscard]] JsonObject root() const { return {*json, ""}; }
};

/// The document in the file at `path`; nothing if it is not glTF, by its first bytes. Throws Error
/// if it is damaged, and Refusal if it is of another version.
[[nodiscard]] std::optional<GltfDocument> open_gltf(const std::filesystem::path& path);

/// As `open_gltf`, of a file's bytes; what its URIs name lies in `folder`.
[[nodiscard]] std::optional<GltfDocument> parse_gltf(std::vector<std::byte> bytes,
                                                     const std::filesystem::path& folder);

}  // namespace ink::import
