#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "methods/surface_codes/smooth_mesh.h"

namespace ink::methods {

/// The borders of a mesh's patches, listed by patch: each of SmoothMesh::borders twice.
class PatchBorders {
  public:
    /// A face at a border, and the one beyond it.
    struct Side {
        std::uint32_t face = 0;
        std::uint32_t beyond = 0;
        double length = 0;  ///< of their edge, world units
    };

    explicit PatchBorders(const SmoothMesh& mesh);

    [[nodiscard]] std::span<const Side> of(std::uint32_t patch) const {
        return {sides_.data() + first_[patch], first_[patch + 1] - first_[patch]};
    }

  private:
    std::vector<Side> sides_;
    std::vector<std::size_t> first_;  ///< per patch, and the end
};

/// Patches, the largest area first: the order in which they choose their codes.
[[nodiscard]] std::vector<std::uint32_t> patches_by_area(const SmoothMesh& mesh);

/// A number below `count`, far apart for patches that follow each other: multiples of the golden
/// section. Knuth 1973, volume 3, section 6.4.
[[nodiscard]] std::uint32_t scattered(std::uint32_t patch, std::uint32_t count);

}  // namespace ink::methods
