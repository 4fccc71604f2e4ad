#pragma once

#include <cstdint>
#include <glm/vec3.hpp>
#include <span>

#include "core/image.h"
#include "edge/edge_image.h"
#include "score/attribution.h"
#include "score/pixel_list.h"
#include "score/score.h"

namespace ink::draw {

/// What a pixel of an image tells, in the order in which it wins when pixels are merged.
enum class Mark : std::uint8_t {
    paper,       ///< nothing is there and nothing was drawn
    ignored,     ///< under the ignore label, or so close to the frame that it does not count
    hit,         ///< drawn, and its line runs within the tolerance of a true one
    first_wrong  ///< from here on: wrong, for each cause in its order (mark_of)
};

/// The mark of a pixel that is wrong for this reason; missing lines come after false ones.
[[nodiscard]] constexpr Mark mark_of(score::Cause cause) {
    return static_cast<Mark>(static_cast<int>(Mark::first_wrong) + static_cast<int>(cause));
}
[[nodiscard]] constexpr bool is_wrong(Mark mark) {
    return mark >= Mark::first_wrong;
}
/// Why a wrong pixel is wrong.
[[nodiscard]] constexpr score::Cause cause_of(Mark mark) {
    return static_cast<score::Cause>(static_cast<int>(mark) - static_cast<int>(Mark::first_wrong));
}

using Marks = core::Image<Mark>;
using RgbImage = core::Image<glm::u8vec3>;

/// How an image is held against the truth.
struct MarkOptions {
    int threshold = 128;      ///< drawn is what has at least this edge response
    double tolerance_px = 2;  ///< centre to centre
    int band_px = 6;          ///< pixels this close to the frame do not count
    /// Why the wrong pixels are wrong, in any order, as found with the options above. One that is
    /// not among them is `other` where it was drawn and `undeclared` where it is missing.
    std::span<const score::WrongPixel> wrong = {};
};

/// Says of every pixel of `edge_response` where it is right and where it is wrong.
///
/// The lines are thinned as the score thins them, and each thinned pixel is a hit if a true one
/// lies within the tolerance. A drawn pixel that thinning removed is what its nearest thinned pixel
/// is, so lines keep their width on the image. This is distance alone: what is wrong of thinned
/// pixels is the score's `false_negatives` and `false_positives`, pixel for pixel, but its
/// `unmatched_truth` and `unmatched_duplicates` (two lines where there is one) look like hits,
/// since which of them is matched is nobody's to say. `labels` holds truth::LineClass and has the
/// size of `edge_response`; two empty images give an empty one.
[[nodiscard]] Marks mark_errors(const core::Image<std::uint8_t>& labels,
                                const edge::EdgeImage& edge_response,
                                const MarkOptions& options);

/// The same for many images of one view, whose truth is prepared once.
class ErrorMarker {
  public:
    /// The band of `options` is that of all images.
    ErrorMarker(const core::Image<std::uint8_t>& labels, const MarkOptions& options);

    /// mark_errors() with the same band again. Many threads may call it.
    [[nodiscard]] Marks mark(const edge::EdgeImage& edge_response,
                             const MarkOptions& options) const;

  private:
    score::PixelList truth_;
    score::PixelList ignored_;
    Marks undrawn_;  ///< of an image on which nothing was drawn, and nothing is missed
};

/// Marks in colour: paper white, hits dark, ignored grey, missing lines warm and false ones cool,
/// each cause in its own (palette.h).
[[nodiscard]] RgbImage error_image(const Marks& marks);

/// A truth image in colour, each class in its own (palette.h).
[[nodiscard]] RgbImage truth_image(const core::Image<std::uint8_t>& labels);

}  // namespace ink::draw
