#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "import/gltf/document.h"

namespace ink::import {

/// The bytes of a document's buffers and of their views. Each is read when it is first asked for,
/// so that what nobody needs may be missing. Borrows the document.
class GltfBuffers {
  public:
    explicit GltfBuffers(const GltfDocument& document);

    /// The bytes of a bufferView, decompressed where they are compressed.
    [[nodiscard]] std::span<const std::byte> view(std::size_t index);
    /// All bytes of a buffer.
    [[nodiscard]] std::span<const std::byte> buffer(std::size_t index);
    /// The bytes that a URI of `owner` holds as data, or of the file that it names below the
    /// document's folder; nothing if that cannot be read. Fails for a URI that leaves the folder.
    [[nodiscard]] std::optional<std::vector<std::byte>> bytes_at(const std::string& uri,
                                                                 const JsonObject& owner) const;
    /// The file's bytes and all that was read or unpacked so far: no list in the file can sensibly
    /// be longer.
    [[nodiscard]] std::uint64_t bytes_known() const { return bytes_known_; }
    void count_bytes(std::uint64_t more) { bytes_known_ += more; }

  private:
    /// The part of a buffer that `of` names: a bufferView, or what compresses one.
    [[nodiscard]] std::span<const std::byte> part(const JsonObject& of);

    const GltfDocument& document_;
    std::uint64_t bytes_known_ = 0;
    std::vector<std::optional<std::vector<std::byte>>> buffers_;   // from outside the file
    std::vector<std::optional<std::vector<std::byte>>> unpacked_;  // per compressed view
};

}  // namespace ink::import
