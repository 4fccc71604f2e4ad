#include "shade/dither.h"

namespace ink::shade {

std::array<int, 3> top_levels(DitherFormat format) {
    switch (format) {
        case DitherFormat::rgb565:
            return {31, 63, 31};
        case DitherFormat::rgb332:
            return {7, 7, 3};
        case DitherFormat::none:
            break;
    }
    return {255, 255, 255};
}

core::Image<Rgb> dither(core::Image<Rgb> image, DitherFormat format) {
    const std::array<int, 3> top = top_levels(format);
    for (int y = 0; y < image.height_px(); ++y) {
        Rgb* row = image.row(y);
        for (int x = 0; x < image.width_px(); ++x) {
            const int rank =
                kBayer4[static_cast<std::size_t>(y & 3)][static_cast<std::size_t>(x & 3)];
            for (int c = 0; c < 3; ++c) {
                const int steps = top[static_cast<std::size_t>(c)];
                const int scaled = row[x][c] * steps;
                const int rest = scaled % 255;
                const int level = scaled / 255 + (32 * rest > 255 * (2 * rank + 1) ? 1 : 0);
                row[x][c] = static_cast<std::uint8_t>((level * 255 + steps / 2) / steps);
            }
        }
    }
    return image;
}

}  // namespace ink::shade
