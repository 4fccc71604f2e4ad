#pragma once

#include <cstddef>
#include <nlohmann/json.hpp>
#include <set>
#include <vector>

namespace ink::bake {

/// Bytes first..end-1 of a buffer.
struct ByteRange {
    std::size_t first = 0;
    std::size_t end = 0;

    [[nodiscard]] bool operator==(const ByteRange&) const = default;
};

/// Whether all extensions of a glTF file are known to refer to accessors and bufferViews by no
/// other keys than those that are looked at here.
[[nodiscard]] bool knows_all_references(const nlohmann::ordered_json& gltf);

/// The bytes of a buffer of `size` bytes that anything in the file uses, ascending, apart from each
/// other: accessors theirs, all else whole bufferViews. Views in `left_out` do not count. All of
/// the buffer if anything in the file is not as it should be.
[[nodiscard]] std::vector<ByteRange> used_bytes(const nlohmann::ordered_json& gltf,
                                                std::size_t buffer,
                                                std::size_t size,
                                                const std::set<std::size_t>& left_out = {});

/// What is in `all` and not in `taken`, both ascending.
[[nodiscard]] std::vector<ByteRange> without(const std::vector<ByteRange>& all,
                                             const std::vector<ByteRange>& taken);

/// How often each accessor is used by meshes, skins, animations and instances of nodes.
[[nodiscard]] std::vector<std::size_t> accessor_uses(const nlohmann::ordered_json& gltf);

}  // namespace ink::bake
