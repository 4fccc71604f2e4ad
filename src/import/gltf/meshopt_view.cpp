// EXT_meshopt_compression and KHR_meshopt_compression, by libmeshoptimizer. What it only asserts is
// checked here.

#include "import/gltf/meshopt_view.h"

#include <meshoptimizer.h>

namespace ink::import {
namespace {

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

int decode(const std::string& mode,
           std::span<const std::byte> packed,
           const Layout& layout,
           std::byte* out) {
    const auto* from = reinterpret_cast<const unsigned char*>(packed.data());
    if (mode == "ATTRIBUTES")
        return meshopt_decodeVertexBuffer(out, layout.count, layout.stride, from, packed.size());
    if (mode == "TRIANGLES")
        return meshopt_decodeIndexBuffer(out, layout.count, layout.stride, from, packed.size());
    return meshopt_decodeIndexSequence(out, layout.count, layout.stride, from, packed.size());
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

}  // namespace

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
    const int failure = decode(mode, packed, layout, bytes.data());
    if (failure == kUnknownVersion) {
        json.refuse("this kind of stream is not read",
                    "what meshoptimizer " + std::to_string(MESHOPTIMIZER_VERSION) + " reads");
    }
    if (failure != 0) json.fail("its stream cannot be unpacked");
    unfilter(filter, layout, bytes.data(), json);
    return bytes;
}

}  // namespace ink::import
