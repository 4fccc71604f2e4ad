#pragma once

#include <cstddef>
#include <filesystem>
#include <nlohmann/json.hpp>
#include <span>
#include <string>
#include <vector>

#include "bake/used_bytes.h"
#include "import/gltf/accessors.h"
#include "import/gltf/buffers.h"
#include "import/gltf/document.h"

namespace ink::bake {

using Json = nlohmann::ordered_json;

/// A glTF file that is added to: its JSON as the user has it, every key in its place, and bytes
/// that go where nothing uses those of its buffer any more, else behind them.
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
    /// The same in place of an old one that was used so many times, if nothing else uses it.
    std::size_t replace_accessor(std::size_t old, std::size_t uses, Json accessor);
    /// Bytes of the file that bytes_for() made that nothing uses any more.
    [[nodiscard]] std::size_t idle_bytes() const { return idle_bytes_; }

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

    [[nodiscard]] std::vector<ByteRange> free_bytes(std::size_t size) const;
    void drop_fallback_buffers();
    void hold_buffers();
    void hold_images(std::vector<std::string>& notes);
    [[nodiscard]] bool names_files() const;
    [[nodiscard]] std::string glb_for(const std::filesystem::path& path,
                                      std::vector<std::string>& notes);
    [[nodiscard]] std::string gltf_for();
    /// The bytes of the buffer that is added to, and what was added: where nothing uses its bytes
    /// any more, then behind it. `buffer` is its number.
    [[nodiscard]] std::string filled(std::size_t buffer);

    import::GltfDocument document_;
    import::GltfBuffers buffers_;
    import::GltfAccessors accessors_;
    Json json_;
    std::vector<std::size_t> kept_buffers_;  ///< of the document, one for each in json_
    std::vector<Added> added_;
    bool may_reuse_ = false;              ///< old bytes and accessors that nothing uses
    std::vector<ByteRange> used_before_;  ///< of the first buffer
    std::vector<std::size_t> uses_;       ///< of the document's accessors
    std::size_t idle_bytes_ = 0;
};

}  // namespace ink::bake
