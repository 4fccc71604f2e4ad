#include "truth/curve_map.h"

namespace ink::truth {

core::Image<std::uint32_t> draw_curve_map(std::span<const Curve> curves,
                                          int width_px,
                                          int height_px) {
    core::Image<std::uint32_t> map(width_px, height_px, kNoCurve);
    for (std::uint32_t i = 0; i < curves.size(); ++i) {
        visit_pixels(curves[i], [&](int x, int y) {
            if (!map.contains(x, y)) return;
            std::uint32_t& pixel = map.at(x, y);
            if (pixel == kNoCurve || curves[i].line_class < curves[pixel].line_class) pixel = i;
        });
    }
    return map;
}

}  // namespace ink::truth
