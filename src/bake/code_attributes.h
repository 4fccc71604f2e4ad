#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "bake/baked_primitives.h"

namespace ink::bake {

/// The attribute that holds codes.
inline constexpr const char* kInk = "_INK";

/// What became of a file's vertices.
struct CodeCounts {
    std::size_t vertices = 0;  ///< of what has codes, in the file as it was
    std::size_t added = 0;
    std::size_t unstripped = 0;  ///< strips and fans that became triangles
    std::size_t undraco = 0;     ///< primitives that Draco had packed
    std::size_t filled = 0;      ///< primitives whose lower TEXCOORDs were missing
};

/// Where codes go.
struct CodeChannel {
    int texcoord = 0;       ///< 1 or 2: TEXCOORD_1 or _2, too; 0: the attribute _INK alone
    bool is_again = false;  ///< the file's own codes are ours, and are replaced
};

/// Gives every vertex of the primitives the code of its triangles (flat_codes), as unsigned bytes
/// in the attribute _INK. `codes` has one of 1..255 per triangle of the scene.
///
/// Vertices that need two codes are copied with all their attributes and targets, in the component
/// types of the file; primitives that share vertices go on sharing them. A copy in a TEXCOORD lies
/// on the same bytes: u is code / 255, v is 0; those below that are missing are filled with the
/// same. Updates triangles and turns of the primitives. Throws core::Error that names the primitive
/// if an attribute is taken.
CodeCounts add_codes(GltfEdit& edit,
                     std::vector<BakedPrimitive>& primitives,
                     std::span<const std::uint32_t> codes,
                     const CodeChannel& channel);

}  // namespace ink::bake
