#pragma once

#include <array>
#include <bitset>
#include <cstddef>
#include <cstdint>
#include <string_view>

namespace ink::raster {

/// What can be left undone because the image does not need it. A skip never changes a bit.
enum class Skip {
    attributes,         ///< channels of the surface that no declared code reads
    frustum_culling,    ///< clusters outside the image
    back_face_culling,  ///< clusters turned away, of solids watertight but for holes elsewhere
    no_sample,          ///< triangles that cover no pixel centre
    occlusion_culling,  ///< triangles and blocks behind what is drawn already
    empty_tiles,        ///< tiles that nobody draws to
    flat_tiles,         ///< tiles inside one plane, where a filter answers 0
    temporal_reuse,     ///< tiles that nothing moved in since the last frame
};
inline constexpr std::size_t kSkipCount = 8;

/// A row of the table of skips.
struct SkipInfo {
    Skip skip;
    std::string_view name;  ///< = row column `skip_<name>` = option value = legend
    std::string_view unit;  ///< what is counted
    std::string_view summary;
};

/// All skips in the order of the enumeration.
[[nodiscard]] const std::array<SkipInfo, kSkipCount>& skip_infos();

/// Which skips are allowed; all of them by default.
class SkipSet {
  public:
    SkipSet() { on_.set(); }
    [[nodiscard]] static SkipSet none() {
        SkipSet set;
        set.on_.reset();
        return set;
    }
    [[nodiscard]] bool has(Skip skip) const { return on_[static_cast<std::size_t>(skip)]; }
    SkipSet& set(Skip skip, bool is_on) {
        on_[static_cast<std::size_t>(skip)] = is_on;
        return *this;
    }
    friend bool operator==(const SkipSet&, const SkipSet&) = default;

  private:
    std::bitset<kSkipCount> on_;
};

/// How much one skip left undone in one frame.
struct SkipCount {
    std::uint64_t skipped = 0;
    std::uint64_t of = 0;  ///< what there was to do, in the same unit; 0 where it does not apply
};

/// One count per Skip.
using SkipCounts = std::array<SkipCount, kSkipCount>;

[[nodiscard]] inline SkipCount& count_of(SkipCounts& counts, Skip skip) {
    return counts[static_cast<std::size_t>(skip)];
}

}  // namespace ink::raster
