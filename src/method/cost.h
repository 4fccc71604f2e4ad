#pragma once

#include <string>

#include "raster/depth/depth.h"
#include "raster/pass/pass.h"

namespace ink::method {

/// What is done at one pixel. Fractions mean nothing; numbers are real because they are multiplied.
struct PixelWork {
    double bytes_read = 0;     ///< of buffers; what a stencil reads again from a cache counts once
    double bytes_written = 0;  ///< of buffers and of the image
    double operations = 0;     ///< on one number each: see cost.cpp for how they are counted
};

PixelWork operator+(const PixelWork& a, const PixelWork& b);
PixelWork operator*(double times, const PixelWork& work);

/// What a method declares a frame of it to do, counted from its formulas and its settings alone:
/// never measured, never dependent on a scene. The cost model turns it into a time.
struct Cost {
    int passes = 0;               ///< over the scene's triangles; 0: nothing is declared
    int interpolants = 0;         ///< planes set up per triangle, beside that of depth
    int values_per_vertex = 0;    ///< numbers computed at a vertex to be interpolated
    bool shares_vertices = true;  ///< false: every triangle has three of its own
    PixelWork fill;               ///< per covered pixel of a triangle, hidden ones too
    PixelWork filter;             ///< per pixel of the frame, empty ones too
    int buffer_bytes_per_px = 0;  ///< cleared once a frame, depth included

    [[nodiscard]] bool is_declared() const { return passes > 0; }
};

/// A division, a root or a logarithm counts as so many operations.
// Intel's Skylake starts an eight-lane division every 5 cycles and two additions every cycle (Fog,
// Instruction tables, 2022): 10. Rounded down, because half of a row hides behind other work.
inline constexpr double kSlowOperations = 8;

/// The fill of one pass: coverage, depth test, interpolants, store.
[[nodiscard]] PixelWork fill_work(const raster::PassFormat& format);

/// Depth as it is carried through the interpolation (method/depth_code.h) to depth as it is
/// encoded, per pixel; nothing where the two are the same.
[[nodiscard]] PixelWork encode_work(raster::DepthEncoding encoding,
                                    raster::Interpolation interpolation);

/// A normal of three floats scaled to length 1, per pixel.
[[nodiscard]] PixelWork renormalise_work();

/// The declared cost in a line of plain text: "1 pass, 1 interpolant, ..."; "not declared".
[[nodiscard]] std::string cost_sentence(const Cost& cost);

/// The declared cost as the Markdown table of a method's page.
[[nodiscard]] std::string cost_table(const Cost& cost);

}  // namespace ink::method
