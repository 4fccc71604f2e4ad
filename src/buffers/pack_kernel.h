#pragma once

#include <cstdint>
#include <span>

namespace ink::buffers {

/// One row of pixels: encoded depth (kNothingDrawn: `sky`) and interpolated normal.
struct PixelRow {
    const float* depth;
    const float* nx;
    const float* ny;
    const float* nz;
    int count;
    bool renormalise;
    int sky;
};

/// What a field adds up, and where its bits lie.
struct PackField {
    float depth = 0;  ///< the code's range of each channel
    float normal[3] = {};
    float offset = 0;  ///< added to their sum
    int bits = 8;
    int shift = 0;
};

/// How the channels of a pixel become a code.
struct PackRules {
    bool is_near_high = true;
    bool rounds_each = false;  ///< every channel by itself, before the sum is
    bool wraps = false;        ///< modulo a field's bits; else limited to them
};

/// The codes of a row, their fields side by side. Sums before they wrap must lie within 31 bits.
void pack_pixels(std::span<const PackField> fields,
                 const PackRules& rules,
                 const PixelRow& row,
                 std::uint8_t* codes);
void pack_pixels(std::span<const PackField> fields,
                 const PackRules& rules,
                 const PixelRow& row,
                 std::uint16_t* codes);

}  // namespace ink::buffers
