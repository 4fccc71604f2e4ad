#pragma once

#include <cstdint>
#include <glm/vec2.hpp>
#include <span>
#include <vector>

#include "edge/edge_image.h"

namespace ink::methods {

/// A straight piece of a line in samples: sample (x, y) lies at
/// (x, y). A round pen draws it, whose radius runs evenly from the one end to the other.
struct Piece {
    glm::dvec2 a{0};
    glm::dvec2 b{0};
    float half_a_px = 0;
    float half_b_px = 0;

    Piece() = default;
    Piece(const glm::dvec2& from, const glm::dvec2& to, float half_from_px, float half_to_px)
        : a(from), b(to), half_a_px(half_from_px), half_b_px(half_to_px) {}
};

/// A piece from (x, y), in px from the corner of a tile, and what is always asked of it.
struct InkPiece {
    float x = 0, y = 0;
    float dx = 0, dy = 0;    ///< to its other end
    float per_length2 = 0;   ///< 1 / (dx^2 + dy^2); 0 of a point
    float half_px = 0;       ///< half its width at (x, y)
    float half_more_px = 0;  ///< and how much more at the other end
    float y_low = 0;         ///< of what it may reach
    float y_high = 0;
};

/// How far a pen reaches beyond its radius into what is asked of a quarter of a pixel.
inline constexpr float kPenReach_px = 0.36F;

/// A tile of an image, row by row.
struct InkTile {
    std::uint8_t* first = nullptr;
    std::ptrdiff_t stride = 0;
    int width_px = 0;  ///< at most 64, as the height
    int height_px = 0;
};

/// Writes 255 times the share of pixels that pieces cover, where they come near; others stay as
/// they are. Of each quarter of a pixel it is the share within the two sides, as good as straight,
/// of the stroke that reaches furthest over its middle. Nothing counts twice. The same on every
/// SIMD target.
void draw_ink(std::span<const InkPiece> pieces, const InkTile& tile);

/// Where the frame's pixels are among samples: pixel (0, 0) is the cell of this sample.
struct InkFrame {
    int columns = 0;    ///< tiles of samples
    int margin_px = 0;  ///< cells before the first pixel
    int threads = 1;
};

/// Draws the pieces of all tiles of samples, which may reach into other tiles, into every pixel of
/// an image. The same for every number of threads.
void draw_pieces(const std::vector<std::vector<Piece>>& of_tiles,
                 const InkFrame& frame,
                 edge::EdgeImage& out);

}  // namespace ink::methods
