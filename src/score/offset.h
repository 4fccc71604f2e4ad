#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "core/image.h"
#include "score/moments.h"
#include "score/pixel_list.h"
#include "truth/curve.h"

namespace ink::score {

/// A pixel's centre as seen from the nearest point of a curve.
struct CurveOffset {
    double offset_px = 0;  ///< signed distance; see NearestCurves
    double normal_x = 0;   ///< unit normal of the curve, to the side that is positive
    double normal_y = 0;
    std::uint8_t label = 0;      ///< truth::LineClass of the curve
    bool is_beyond_end = false;  ///< further along the curve, past its end, than across it
};

/// For every pixel whose centre lies within 2 px of a curve, the nearest curve point; made once a
/// view.
///
/// An offset is positive outwards, to the side without a face (Curve::empty_side). Lines that have
/// both sides count as positive to the right (+x) where they are steeper than 45 degrees, else
/// downwards (+y). Of curves equally near, that one counts from which the centre lies further
/// across (round a corner both of its lines do, past the end of a line none does), then the lower
/// class, then the first.
struct NearestCurves {
    core::Image<std::uint32_t> index;  ///< 0 none in reach, else into `offsets` plus one
    std::vector<CurveOffset> offsets;

    /// The offset of the centre of pixel (x, y) inside the image; null if no curve is in reach.
    [[nodiscard]] const CurveOffset* find(int x, int y) const {
        const std::uint32_t i = index.at(x, y);
        return i == 0 ? nullptr : &offsets[i - 1];
    }
};

/// Finds them; costs about the length of the curves.
[[nodiscard]] NearestCurves find_nearest_curves(std::span<const truth::Curve> curves,
                                                int width_px,
                                                int height_px);

/// A translation of the image.
struct Shift {
    double x_px = 0;
    double y_px = 0;
};

/// Where drawn lines lie beside the true ones; every number is empty if no pixel is near a curve.
struct Offsets {
    Moments all;                     ///< px
    std::array<Moments, 8> classes;  ///< by truth::LineClass of the nearest curve
    /// The translation that explains the offsets best (least squares over the normals): an image
    /// drawn half a pixel too far right and down has (0.5, 0.5), one drawn all round outside
    /// (0, 0). Thinning moves lines too, to the left above all: of lines two pixels wide by half a
    /// pixel, which measuring the drawing before thinning shows. Nothing if the curves run in
    /// nearly one direction only.
    std::optional<Shift> shift;
};

/// The offsets of drawn pixels, thinned and with band and ignore taken out (counted_pixels), of an
/// image of the curves' size. Pixels out of reach of every curve, or past the end of the nearest,
/// have none.
[[nodiscard]] Offsets measure_offsets(const PixelList& drawn, const NearestCurves& curves);

}  // namespace ink::score
