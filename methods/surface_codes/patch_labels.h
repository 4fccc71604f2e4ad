#pragma once

#include <cstdint>
#include <vector>

#include "core/keyed_lists.h"
#include "methods/surface_codes/smooth_mesh.h"

namespace ink::methods {

/// A face at the border of a patch, and the one beyond it.
struct BorderSide {
    std::uint32_t face = 0;
    std::uint32_t beyond = 0;
    double length = 0;  ///< of their edge, world units
};

/// The borders of a mesh's patches, listed by patch: each of SmoothMesh::borders twice.
struct PatchBorders : core::KeyedLists<BorderSide> {
    explicit PatchBorders(const SmoothMesh& mesh);
};

/// Patches, the largest area first: the order in which they choose their codes.
[[nodiscard]] std::vector<std::uint32_t> patches_by_area(const SmoothMesh& mesh);

/// A number below `count`, far apart for patches that follow each other: multiples of the golden
/// section. Knuth 1973, volume 3, section 6.4.
[[nodiscard]] std::uint32_t scattered(std::uint32_t patch, std::uint32_t count);

/// What labels must keep apart where they meet.
struct LabelRange {
    int bits = 8;              ///< labels are numbers modulo 2^bits, 1..16
    int least_difference = 8;  ///< of m times two labels, for m = 1, 2 and 3, either way round
};

/// How far two labels are apart as a filter of four neighbours sees them: the least of m times
/// their difference, modulo 2^bits and either way round, for m = 1, 2 and 3. 128 apart in a byte
/// are nothing to a stencil with two of its neighbours across: 2 * 128 is 0 there.
[[nodiscard]] int seen_difference(std::uint32_t a, std::uint32_t b, int bits);

/// Per face the label of its patch, such that patches with a common border differ enough. Found
/// patch by patch, the largest area first, so that as little as possible of the borders with those
/// before has labels too near; where a patch is free, patches that follow each other in the file
/// get labels far apart. Deterministic; O(n log n).
[[nodiscard]] std::vector<std::uint32_t> patch_labels(const SmoothMesh& mesh,
                                                      const LabelRange& range);

}  // namespace ink::methods
