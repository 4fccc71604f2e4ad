#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <string_view>
#include <vector>

#include "core/image.h"
#include "edge/edge_image.h"
#include "score/drawing.h"
#include "score/score.h"
#include "truth/curve.h"

namespace ink::score {

/// A pixel of an image.
struct Pixel {
    int x_px = 0;
    int y_px = 0;

    friend bool operator==(const Pixel&, const Pixel&) = default;
};

/// The pixels that are wrong whatever matching is found, row by row: as many as score() counts.
///
/// Of unmatched duplicates and unmatched truth only the numbers are unique, so they are not here:
/// an unmatched pixel with a partner in reach can take the place of the one that partner is matched
/// to, and the matching is as large as before. No single one of them can be called wrong.
struct WrongPixels {
    std::vector<Pixel>
        false_positives;  ///< predicted (thinned) pixels without a truth pixel in reach
    std::vector<Pixel> false_negatives;  ///< truth pixels without a predicted pixel in reach
    edge::Mask drawn;  ///< 1 where something was drawn, not yet thinned; band taken out
};

/// Which pixels score() calls false positives and false negatives: `drawn` is what counts of the
/// strokes, with these options. Empty images have none.
[[nodiscard]] WrongPixels wrong_pixels(const Strokes& strokes,
                                       const PixelList& drawn,
                                       const TruthLists& lists,
                                       const ScoreOptions& options);

/// Why a pixel is wrong. The first five are of predicted pixels off every line
/// (`Score::false_positives`), the others of truth pixels that nothing was drawn near
/// (`Score::false_negatives`).
enum class Cause : std::uint8_t {
    one_triangle,  ///< its stencil sees a single triangle (or sky alone): grazing, quantisation
    one_patch,     ///< a single smooth patch, several triangles of it: tessellation
    crack,         ///< a true line crosses the stencil, out of reach: doubled or offset
    frame,         ///< the image ends in the stencil, or the band took a true pixel in reach away
    other,         ///< several surfaces without a true line between them

    cancelled,        ///< a channel of the declared code alone would have fired, their sum does not
    below_threshold,  ///< what changes is too little, also channel by channel
    sub_pixel,        ///< no stencil of pixel centres near it sees the line
    thinned,          ///< drawn, but lines ran together and thinning took this one away
    unexplained,      ///< the declared code should have drawn it, and it is not drawn
    undeclared,       ///< a stencil sees it, it is not drawn, and the method declares no code
};

inline constexpr std::array kFalsePositiveCauses = {
    Cause::one_triangle, Cause::one_patch, Cause::crack, Cause::frame, Cause::other};
inline constexpr std::array kFalseNegativeCauses = {Cause::cancelled,
                                                    Cause::below_threshold,
                                                    Cause::sub_pixel,
                                                    Cause::thinned,
                                                    Cause::unexplained,
                                                    Cause::undeclared};
inline constexpr std::size_t kCauseCount =
    kFalsePositiveCauses.size() + kFalseNegativeCauses.size();

[[nodiscard]] constexpr bool is_miss(Cause cause) {
    return cause >= kFalseNegativeCauses.front();
}

/// "one_triangle", ...: the one spelling of columns, keys and legends.
[[nodiscard]] std::string_view name(Cause cause);

/// Pixels per cause, in the enum's order.
struct CauseCounts {
    std::array<std::int64_t, kCauseCount> px{};

    [[nodiscard]] std::int64_t& operator[](Cause cause) {
        return px[static_cast<std::size_t>(cause)];
    }
    [[nodiscard]] std::int64_t operator[](Cause cause) const {
        return px[static_cast<std::size_t>(cause)];
    }
    friend bool operator==(const CauseCounts&, const CauseCounts&) = default;
};

/// What the truth says of pixel centres, borrowed; all of one size.
struct TruthStencils {
    const core::Image<std::uint32_t>& triangle;  ///< what is seen; sky has a number of its own
    const core::Image<std::uint32_t>& patch;     ///< the smooth patch of it; sky likewise
    const truth::Cracks& cracks;                 ///< where true lines run between centres
    const core::Image<std::uint8_t>& labels;     ///< the truth image, band not yet taken out
};

/// Whether the four-neighbour stencil round a pixel sees a line: a crack runs between its centre
/// and a neighbour inside the image, and its five centres do not all see the same triangle. A
/// crack between centres that do is the line of something thinner than their distance.
///
/// The two need not lie between the same two centres: of a line straight through a centre, cracks
/// and layers may say differently on which side the centre lies.
[[nodiscard]] bool sees_line(const TruthStencils& stencils, Pixel pixel);

/// The stencils that ought to find the line of a truth pixel: those of the 3 x 3 pixels round it
/// that see a line, row by row. Any line that crosses a pixel and goes on crosses one of them,
/// unless it is thinner or shorter than the grid can tell.
[[nodiscard]] std::vector<Pixel> seeing_stencils(const TruthStencils& stencils, Pixel pixel);

/// A wrong pixel and why.
struct WrongPixel {
    Pixel pixel;
    Cause cause = Cause::other;

    friend bool operator==(const WrongPixel&, const WrongPixel&) = default;
};

/// Every false positive and every false negative of a comparison with one cause, in the order of
/// WrongPixels, false positives first. The counts of kFalsePositiveCauses add up to
/// Score::false_positives, those of kFalseNegativeCauses to Score::false_negatives.
struct Attribution {
    std::vector<WrongPixel> pixels;
    CauseCounts counts;
};

/// Says of each wrong pixel why it is wrong, from the truth alone (design, section 7).
///
/// A false positive is judged by the 3 x 3 pixels round it, the smallest square that holds the
/// stencil of every filter in use (the cross of MOTE's Laplacian, Decaudin's square), so that the
/// counts of different methods mean the same. The first of these holds: `frame`, `one_triangle`,
/// `crack`, `one_patch`, `other`. `frame` comes first because there the truth itself was cut; one
/// triangle before a crack, because a line between centres that see the same triangle was seen by
/// no filter.
///
/// A false negative is `sub_pixel` if no stencil sees its line (seeing_stencils() is empty). Else
/// it is what `predicted` says of it: `cancelled`, `below_threshold` or `unexplained` for each of
/// `wrong.false_negatives`, or nothing at all for a method that declares no code (`undeclared`).
/// Neither of the first two looks at an image; the last two do, and become `thinned` where one of
/// the stencils that see the line was drawn before thinning.
///
/// `options` are those that `wrong` was found with.
[[nodiscard]] Attribution attribute(const WrongPixels& wrong,
                                    const TruthStencils& stencils,
                                    std::span<const Cause> predicted,
                                    const ScoreOptions& options);

}  // namespace ink::score
