#include "core/kept_file.h"

#include "core/byte_stream.h"
#include "core/error.h"
#include "core/hash.h"
#include "core/whole_file.h"

namespace ink::core {
namespace {

std::uint64_t hash_of(const void* data, std::size_t size) {
    return Hasher().bytes(data, size).result();
}

}  // namespace

std::string sealed(const KeptKind& kind, const std::string& key, std::string_view payload) {
    const std::uint64_t hash = hash_of(payload.data(), payload.size());
    return written_bytes([&](ByteWriter& out) {
               out.parts(kind, key, hash, static_cast<std::uint64_t>(payload.size()));
           })
        .append(payload);
}

std::optional<std::span<const std::byte>> unsealed(std::string_view bytes,
                                                   const KeptKind& kind,
                                                   const std::string& key) {
    ByteReader in(std::as_bytes(std::span(bytes)));
    KeptKind stored_kind{};
    std::string stored_key;
    std::uint64_t hash = 0, size = 0;
    in.parts(stored_kind, stored_key, hash, size);
    const std::span<const std::byte> payload = in.left();
    if (!in.is_good() || stored_kind != kind || stored_key != key || size != payload.size() ||
        hash != hash_of(payload.data(), payload.size())) {
        return std::nullopt;
    }
    return payload;
}

void keep_file(const std::filesystem::path& path, std::string_view bytes) {
    std::error_code error;
    std::filesystem::create_directories(path.parent_path(), error);
    if (error) return;
    try {
        write_whole_file(path, bytes);
    } catch (const Error&) {
        // As said above.
    }
}

}  // namespace ink::core
