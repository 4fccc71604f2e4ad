#include "raster/fragments/cluster_fragments.h"
#include "raster/pass/tile_buffer.h"

namespace ink::raster {
namespace {

/// The buffer's first element, of which places count.
constexpr int kFirstRow_px = -kMaxHalo_px;

/// Depth and, unless it is null, a plane; `value_of` a fragment by number.
template <class T, class ValueOf>
void fill(const FragmentBlock& block,
          std::size_t count,
          float* depth,
          T* plane,
          const ValueOf& value_of) {
    const std::uint32_t* const words = block.words();
    const float* const q = block.q();
    for (std::size_t i = 0; i < count; ++i) {
        const std::size_t at = words[i] & 0xffffU;
        const float old = depth[at];
        const bool is_seen = q[i] > old;
        depth[at] = is_seen ? q[i] : old;
        if (plane != nullptr) plane[at] = is_seen ? static_cast<T>(value_of(i)) : plane[at];
    }
}

}  // namespace

void fill_fragments(const PassFormat& format,
                    const FragmentBlock& block,
                    std::size_t count,
                    TileBuffer& to) {
    const int row = to.own().y0 + kFirstRow_px;
    const int column = to.own().x0 - kTileMargin_px;
    float* const depth = to.depth_row<float>(row) + column;
    const auto narrow = [&](std::size_t i) { return block.words()[i] >> 16; };
    const auto plane = [&]<class T>(T) { return to.plane_row<T>(0, row) + column; };
    if (format.store == Store::none)
        return fill(block, count, depth, static_cast<std::uint8_t*>(nullptr), narrow);
    if (FragmentBlock::has_wide_values(format)) {
        const std::uint32_t* const values = block.values();
        return fill(block, count, depth, plane(std::uint32_t{}), [values](std::size_t i) {
            return values[i];
        });
    }
    if (!format.constant) return fill(block, count, depth, plane(std::uint32_t{}), narrow);
    fill(block, count, depth, plane(std::uint8_t{}), narrow);
}

}  // namespace ink::raster
