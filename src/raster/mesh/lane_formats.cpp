#include "raster/mesh/lane_triangles.h"

namespace ink::raster {

bool lanes_can_draw(const PassFormat& format) {
    if (format.interpolation != Interpolation::affine) return false;
    if (format.constant) {
        const bool is_whole = format.store == Store::u8 || format.store == Store::u32;
        return is_whole && format.interpolants == 0;
    }
    const int k = format.interpolants;
    return (format.store == Store::none && k == 0) ||
           (format.store == Store::u8 && (k == 1 || k == 2)) ||
           (format.store == Store::u16 && k == 1) || (format.store == Store::f32 && k == 4);
}

bool lanes_can_hold(const PassFormat& format, float least, float greatest) {
    switch (format.store) {
        case Store::u8:
            return least >= -4000 && greatest <= 8000;
        case Store::u16:
            return least >= -1 && greatest <= 66000;
        default:
            return least >= -0x1p20F && greatest <= 0x1p20F;
    }
}

}  // namespace ink::raster
