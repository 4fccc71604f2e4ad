#pragma once

#include <cstddef>
#include <filesystem>
#include <nlohmann/json.hpp>
#include <span>
#include <string>
#include <vector>

#include "import/gltf/accessors.h"
#include "import/gltf/buffers.h"
#include "import/gltf/document.h"

namespace ink::bake {

using Json = nlohmann::ordered_json;

/// A glTF file that is added to: its JSON as the user has it, every key in its place, and bytes
/// that go behind those of its buffer. What nothing names any more stays.
///
/// What is read comes from the document as it was, checked; what is changed is the copy in json().
class GltfEdit {
  public:
    /// What a bufferView is for.
    enum class Use { other = 0, vertices = 34962, indices = 34963 };

    explicit GltfEdit(import::GltfDocument document);
    GltfEdit(const GltfEdit&) = delete;
    GltfEdit& operator=(const GltfEdit&) = delete;

    [[nodiscard]] const import::GltfDocument& document() const { return document_; }
    [[nodiscard]] import::GltfBuffers& buffers() { return buffers_; }
    [[nodiscard]] import::GltfAccessors& accessors() { return accessors_; }
    [[nodiscard]] Json& json() { return json_; }

    /// Adds bytes as a bufferView; returns its number. `stride_bytes` 0: without gaps.
    std::size_t add_view(std::span<const std::byte> bytes, std::size_t stride_bytes, Use use);
    /// Puts bytes behind the others in place of what an old bufferView had.
    void replace_view(std::size_t view, std::span<const std::byte> bytes);
    /// Adds an accessor; returns its number.
    std::size_t add_accessor(Json accessor);

    /// Adds a name to extensionsUsed, never to extensionsRequired.
    void use_extension(const char* name);
    /// Takes a name out of both.
    void drop_extension(const char* name);

    /// Unpacks the bufferViews of EXT_ and KHR_meshopt_compression; how many there were.
    std::size_t unpack_views();

    /// The file that `path` is to hold, by its ending: a .glb holds buffers and images that stood
    /// beside a .gltf, a .gltf has what was added as a data URI. Appends a sentence to `notes` for
    /// each image that cannot be taken in. Throws core::Error if a .gltf names files beside it and
    /// `path` is in another folder.
    [[nodiscard]] std::string bytes_for(const std::filesystem::path& path,
                                        std::vector<std::string>& notes);

  private:
    /// Bytes that are not yet in a buffer, and the views that begin so far in them.
    struct Added {
        std::string bytes;
        std::vector<std::pair<std::size_t, std::size_t>> views;
    };

    void drop_fallback_buffers();
    void hold_buffers();
    void hold_images(std::vector<std::string>& notes);
    [[nodiscard]] bool names_files() const;
    [[nodiscard]] std::string glb_for(const std::filesystem::path& path,
                                      std::vector<std::string>& notes);
    [[nodiscard]] std::string gltf_for();
    /// The bytes of the buffer that is added to, and behind them what was added. `buffer` is its
    /// number.
    [[nodiscard]] std::string filled(std::size_t buffer);

    import::GltfDocument document_;
    import::GltfBuffers buffers_;
    import::GltfAccessors accessors_;
    Json json_;
    std::vector<std::size_t> kept_buffers_;  ///< of the document, one for each in json_
    std::vector<Added> added_;
};

}  // namespace ink::bake
