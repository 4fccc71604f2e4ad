#pragma once

#include <string>

#include "raster/pass/pass.h"

namespace ink::method {

/// Bytes of buffers and images that are moved for one pixel. Fractions mean nothing; numbers are
/// real because they are multiplied.
struct PixelBytes {
    double read = 0;  ///< what a stencil reads again from a cache counts once
    double written = 0;
};

PixelBytes operator+(const PixelBytes& a, const PixelBytes& b);
PixelBytes operator*(double times, const PixelBytes& bytes);

/// What a method declares a frame of it to do, by its settings alone: never measured, never
/// dependent on a scene. The cost model turns it into a time.
struct Cost {
    int passes = 0;               ///< over the scene's triangles; 0: nothing is declared
    int interpolants = 0;         ///< planes set up per triangle, beside that of depth
    int values_per_vertex = 0;    ///< numbers computed at a vertex to be interpolated
    bool shares_vertices = true;  ///< false: every triangle has three of its own
    PixelBytes fill;              ///< per covered pixel of a triangle, hidden ones too
    PixelBytes filter;            ///< per pixel of the frame, empty ones too
    int buffer_bytes_per_px = 0;  ///< cleared once a frame, depth included

    [[nodiscard]] bool is_declared() const { return passes > 0; }
};

/// A pass of this format over shared vertices, without a filter: each covered pixel has its depth
/// read, and all it holds written.
[[nodiscard]] Cost pass_cost(const raster::PassFormat& format);

/// The declared cost in a line of plain text, as methods' pages have it: "1 pass, 1 interpolant,
/// ..."; "not declared".
[[nodiscard]] std::string cost_sentence(const Cost& cost);

}  // namespace ink::method
