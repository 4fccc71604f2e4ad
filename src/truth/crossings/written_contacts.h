#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "truth/crossings/pierce.h"

namespace ink::truth {

/// Two triangles that touch as far as the digits of their coordinates can tell (scene/
/// precision/written_digits.h), though as given they cross or stand apart: parts that were made to
/// touch, and were written with four decimals.
///
/// The digits may have moved both farther than an image takes for one place. So this is no contact
/// until a view says that it cannot show the difference (EyeView::by_digits).
struct WrittenContact {
    std::uint32_t face0 = 0;  ///< face0 < face1
    std::uint32_t face1 = 0;
    double rounding_world = 0;         ///< how far digits may have moved a vertex of either
    Meeting touching;                  ///< without a crossing; nothing at all where points touch
    std::optional<Crossing> as_given;  ///< what they have in common as they are, if they cross
};

/// Which way a triangle leaves another that it is near to.
struct WrittenSides {
    std::uint32_t face0 = 0;  ///< face0 < face1
    std::uint32_t face1 = 0;
    Sides of_face0, of_face1;  ///< the corners of either, at the other's plane
};

/// What the search for crossings finds of digits.
struct WrittenPairs {
    std::vector<WrittenContact> contacts;  ///< sorted by (face0, face1)
    std::vector<WrittenSides> sides;       ///< of pairs without a common vertex, in any order

    /// Adds two triangles that are not apart by their digits; `as_given` is what they have in
    /// common by the floats.
    void add(const scene::Topology& topology,
             const Meeting& as_given,
             std::uint32_t f,
             std::uint32_t g);
};

/// What a smooth surface is to the rule below.
struct SmoothFaces {
    std::span<const std::uint32_t> patch;     ///< per face (Model::patch)
    std::span<const std::int8_t> runs;        ///< as Model::runs
    std::span<const std::uint8_t> is_smooth;  ///< per edge 1 if the patch goes on over it
};

/// Takes away the contacts of smooth surfaces that leave each other on both sides: where each has
/// corners surely above and surely below the other, beside the places where digits leave it open,
/// the two cross, however shallow, and there is no contact. A sheet that stands on a plate stays on
/// one side of it, and of a decal no corner is surely on either.
void keep_one_sided(const scene::Topology& topology,
                    const SmoothFaces& smooth,
                    WrittenPairs& pairs);

}  // namespace ink::truth
