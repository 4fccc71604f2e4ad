#include "import/gltf/buffers.h"

#include "import/gltf/meshopt_view.h"
#include "import/gltf/uri.h"

namespace ink::import {

namespace {

constexpr std::uint64_t kMostBytes = std::uint64_t{1} << 40;

}  // namespace

GltfBuffers::GltfBuffers(const GltfDocument& document)
    : document_(document),
      bytes_known_(document.bytes.size()),
      buffers_(document.buffers.size()),
      unpacked_(document.buffer_views.size()) {}

std::span<const std::byte> GltfBuffers::buffer(std::size_t index) {
    const JsonObject& json = document_.buffers[index];
    const std::uint64_t size = json.whole("byteLength", kMostBytes);
    const auto check = [&](std::uint64_t found) {
        if (found >= size) return;
        json.fail("byteLength is " + std::to_string(size), "0.." + std::to_string(found));
    };
    if (!json.has("uri")) {
        if (index != 0 || !document_.has_binary)
            json.fail("it has no uri, and the file no binary chunk for it");
        check(document_.binary.size());
        return document_.binary.first(size);
    }
    auto& kept = buffers_[index];
    if (!kept) {
        const std::string uri = json.text("uri");
        if (is_data_uri(uri)) {
            kept = bytes_of_data_uri(uri, json);
        } else {
            kept = read_file(path_of_uri(uri, document_.folder, json), size);
            if (!kept) json.fail("the file " + uri + " cannot be read", "a file beside the model");
        }
        count_bytes(kept->size());
    }
    check(kept->size());
    return std::span<const std::byte>(*kept).first(size);
}

std::span<const std::byte> GltfBuffers::part(const JsonObject& of) {
    const auto whole = buffer(of.index("buffer", document_.buffers.size()));
    const std::uint64_t offset = of.whole_or("byteOffset", whole.size(), 0);
    const std::uint64_t size = of.whole("byteLength", whole.size() - offset);
    return whole.subspan(offset, size);
}

std::span<const std::byte> GltfBuffers::view(std::size_t index) {
    const JsonObject& json = document_.buffer_views[index];
    for (const char* name : {"EXT_meshopt_compression", "KHR_meshopt_compression"}) {
        const auto packed = json.extension(name);
        if (!packed) continue;
        auto& kept = unpacked_[index];
        if (!kept) {
            kept = unpack_meshopt(part(*packed), *packed);
            count_bytes(kept->size());
        }
        return *kept;
    }
    return part(json);
}

}  // namespace ink::import
