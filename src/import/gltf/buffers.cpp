#include "import/gltf/buffers.h"

#include <meshoptimizer.h>

#include <algorithm>
#include <filesystem>
#include <string>
#include <string_view>

#include "core/parse_number.h"
#include "import/gltf/json.h"
#include "import/model_bytes.h"

namespace ink::import {

namespace {

// EXT_meshopt_compression and KHR_meshopt_compression, by libmeshoptimizer. What it only asserts is
// checked here.

// A stream unpacks to at most a thousandfold: blocks of 256 vertices have at least one bit per two
// of a vertex's bytes.
constexpr std::uint64_t kMostGrowth = 4096;
constexpr std::uint64_t kMostStride = 256;
constexpr int kUnknownVersion = -1;

struct Layout {
    std::size_t count = 0;
    std::size_t stride = 0;
};

/// Fails unless a stride fits what is packed.
void check_stride(bool is_good,
                  const Layout& layout,
                  const char* accepted,
                  const JsonObject& json) {
    if (!is_good) json.fail("byteStride is " + std::to_string(layout.stride), accepted);
}

using Decoder = int (*)(void*, std::size_t, std::size_t, const unsigned char*, std::size_t);

Decoder decoder_of(const std::string& mode) {
    if (mode == "ATTRIBUTES") return meshopt_decodeVertexBuffer;
    if (mode == "TRIANGLES") return meshopt_decodeIndexBuffer;
    return meshopt_decodeIndexSequence;
}

void check_mode(const std::string& mode, const Layout& layout, const JsonObject& json) {
    if (mode == "ATTRIBUTES") {
        check_stride(layout.stride > 0 && layout.stride % 4 == 0, layout, "4, 8 .. 256", json);
    } else if (mode == "TRIANGLES" || mode == "INDICES") {
        check_stride(layout.stride == 2 || layout.stride == 4, layout, "2 or 4", json);
        if (mode == "TRIANGLES" && layout.count % 3 != 0)
            json.fail("count is " + std::to_string(layout.count), "three indices per triangle");
    } else {
        json.refuse("the mode " + mode + " is not read", "ATTRIBUTES, TRIANGLES or INDICES");
    }
}

void unfilter(const std::string& filter,
              const Layout& layout,
              std::byte* bytes,
              const JsonObject& json) {
    if (filter == "OCTAHEDRAL") {
        check_stride(layout.stride == 4 || layout.stride == 8, layout, "4 or 8", json);
        meshopt_decodeFilterOct(bytes, layout.count, layout.stride);
    } else if (filter == "QUATERNION") {
        check_stride(layout.stride == 8, layout, "8", json);
        meshopt_decodeFilterQuat(bytes, layout.count, layout.stride);
    } else if (filter == "EXPONENTIAL") {
        check_stride(layout.stride % 4 == 0, layout, "4, 8 .. 256", json);
        meshopt_decodeFilterExp(bytes, layout.count, layout.stride);
    } else if (!filter.empty() && filter != "NONE") {
        json.refuse("the filter " + filter + " is not read",
                    "NONE, OCTAHEDRAL, QUATERNION or EXPONENTIAL");
    }
}

/// The bytes that a stream of EXT_meshopt_compression holds; `json` is that extension of a
/// bufferView.
std::vector<std::byte> unpack_meshopt(std::span<const std::byte> packed, const JsonObject& json) {
    const std::string mode = json.text("mode");
    const std::string filter = json.text("filter");
    const Layout layout{.count = json.whole("count", packed.size() * kMostGrowth),
                        .stride = json.whole("byteStride", kMostStride)};
    check_mode(mode, layout, json);
    if (layout.count * layout.stride > packed.size() * kMostGrowth) {
        json.fail("count is " + std::to_string(layout.count),
                  "what " + std::to_string(packed.size()) + " bytes can hold");
    }
    std::vector<std::byte> bytes(layout.count * layout.stride);
    if (bytes.empty()) return bytes;
    const auto* from = reinterpret_cast<const unsigned char*>(packed.data());
    const int failure =
        decoder_of(mode)(bytes.data(), layout.count, layout.stride, from, packed.size());
    if (failure == kUnknownVersion) {
        json.refuse("this kind of stream is not read",
                    "what meshoptimizer " + std::to_string(MESHOPTIMIZER_VERSION) + " reads");
    }
    if (failure != 0) json.fail("its stream cannot be unpacked");
    unfilter(filter, layout, bytes.data(), json);
    return bytes;
}

constexpr std::string_view kBase64 =
    "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
constexpr std::size_t kMostShownChars = 60;

std::string shown(const std::string& uri) {
    return "the URI " + uri.substr(0, kMostShownChars) +
           (uri.size() > kMostShownChars ? "..." : "");
}

std::string decoded(const std::string& uri, const JsonObject& owner) {
    std::string path;
    for (std::size_t i = 0; i < uri.size(); ++i) {
        if (uri[i] != '%') {
            path += uri[i];
            continue;
        }
        const std::string digits = uri.substr(i + 1, 2);
        const unsigned code = core::parse_number<unsigned>(digits, 16).value_or(0);
        if (digits.size() < 2 || code == 0)
            owner.fail(shown(uri) + " has an escape that is none", "% and two digits, not %00");
        path += static_cast<char>(code);
        i += 2;
    }
    return path;
}

/// Whether something stands before the first colon that makes it an absolute URI, as in "http:".
bool has_scheme(const std::string& uri) {
    const std::size_t colon = uri.find(':');
    return colon != 0 && colon != std::string::npos && uri.find('/') > colon;
}

/// The bytes in a data URI; only base64 is read. `owner` is complained of.
std::vector<std::byte> bytes_of_data_uri(const std::string& uri, const JsonObject& owner) {
    const std::size_t comma = uri.find(',');
    const std::string_view head = std::string_view(uri).substr(0, comma);
    if (comma == std::string::npos || !head.ends_with(";base64"))
        owner.refuse(shown(uri) + " is not read", "data in base64");
    std::string_view text = std::string_view(uri).substr(comma + 1);
    for (int i = 0; i < 2 && text.ends_with('='); ++i)
        text.remove_suffix(1);
    std::vector<std::byte> bytes;
    bytes.reserve(text.size() / 4 * 3 + 2);
    std::uint32_t bits = 0;
    int count = 0;
    for (const char c : text) {
        const std::size_t digit = kBase64.find(c);
        if (digit == std::string_view::npos)
            owner.fail("its data has a character that base64 has not", "A-Z a-z 0-9 + /");
        bits = bits << 6 | static_cast<std::uint32_t>(digit);
        count += 6;
        if (count < 8) continue;
        count -= 8;
        bytes.push_back(static_cast<std::byte>(bits >> count & 0xff));
    }
    return bytes;
}

/// The file that a relative URI names, below `folder`: its percent-encoding is undone (RFC 3986).
/// `owner` is complained of where it names another computer, or leaves the folder.
std::filesystem::path path_of_uri(const std::string& uri,
                                  const std::filesystem::path& folder,
                                  const JsonObject& owner) {
    constexpr const char* kAccepted = "a path below the model's folder";
    if (has_scheme(uri)) owner.refuse(shown(uri) + " is not opened", kAccepted);
    const std::filesystem::path path = decoded(uri, owner);
    const bool is_below = path.is_relative() &&
                          std::none_of(path.begin(), path.end(), [](auto& p) { return p == ".."; });
    if (!is_below) owner.refuse(shown(uri) + " leaves the model's folder", kAccepted);
    return folder / path;
}

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
        if (uri.starts_with("data:")) {
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

std::optional<std::vector<std::byte>> GltfBuffers::bytes_at(const std::string& uri,
                                                            const JsonObject& owner) const {
    if (uri.starts_with("data:")) return bytes_of_data_uri(uri, owner);
    return read_file(path_of_uri(uri, document_.folder, owner), kMostBytes);
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
