#include "score/attribution.h"

#include <algorithm>
#include <cassert>
#include <utility>

#include "core/vocabulary.h"
#include "score/pixel_list.h"

namespace ink::score {
namespace {

/// The pixels of `from` that are not in a mask.
std::vector<Pixel> outside(const PixelList& from, const edge::BitMask& mask) {
    std::vector<Pixel> pixels;
    from.visit([&](int x, int y) {
        if (!mask.is_set(x, y)) pixels.push_back({x, y});
    });
    return pixels;
}

/// Whether a crack runs between two pixels that are neighbours, `b` right of or below `a`.
bool is_cracked(const TruthStencils& stencils, Pixel a, Pixel b) {
    return (a.y_px == b.y_px ? stencils.cracks.right : stencils.cracks.below).at(a.x_px, a.y_px) !=
           0;
}

/// The 3 x 3 pixels round one that has eight neighbours.
class Square {
  public:
    Square(const TruthStencils& stencils, Pixel middle) : stencils_(stencils), middle_(middle) {}

    [[nodiscard]] bool is_uniform(const core::Image<std::uint32_t>& ids) const {
        const std::uint32_t first = ids.at(middle_.x_px, middle_.y_px);
        for (int y = middle_.y_px - 1; y <= middle_.y_px + 1; ++y) {
            for (int x = middle_.x_px - 1; x <= middle_.x_px + 1; ++x) {
                if (ids.at(x, y) != first) return false;
            }
        }
        return true;
    }

    [[nodiscard]] bool has_crack() const {
        const int right = middle_.x_px + 1;
        const int bottom = middle_.y_px + 1;
        for (int y = middle_.y_px - 1; y <= bottom; ++y) {
            for (int x = middle_.x_px - 1; x <= right; ++x) {
                if (x < right && is_cracked(stencils_, {x, y}, {x + 1, y})) return true;
                if (y < bottom && is_cracked(stencils_, {x, y}, {x, y + 1})) return true;
            }
        }
        return false;
    }

  private:
    const TruthStencils& stencils_;
    Pixel middle_;
};

/// The pixels within the tolerance of true ones that the band took out of the comparison.
edge::BitMask near_band_truth(const core::Image<std::uint8_t>& labels,
                              const ScoreOptions& options) {
    core::Image<std::uint8_t> inner = labels;
    clear_band(inner, options.band_px);
    edge::Mask taken_out(labels.width_px(), labels.height_px());
    for (std::size_t i = 0; i < taken_out.size(); ++i) {
        const int label = labels.data()[i];
        const bool is_true = label != 0 && label != options.ignore_label;
        taken_out.data()[i] = is_true && inner.data()[i] == 0 ? 1 : 0;
    }
    return reach_of(PixelList(taken_out), Disk(options.tolerance_px));
}

Cause false_positive_cause(const TruthStencils& stencils, const edge::BitMask& band, Pixel pixel) {
    const auto [x, y] = pixel;
    const bool has_neighbours = x > 0 && y > 0 && x < stencils.triangle.width_px() - 1 &&
                                y < stencils.triangle.height_px() - 1;
    if (!has_neighbours || band.is_set(x, y)) return Cause::frame;
    const Square square(stencils, pixel);
    if (square.is_uniform(stencils.triangle)) return Cause::one_triangle;
    if (square.has_crack()) return Cause::crack;
    return square.is_uniform(stencils.patch) ? Cause::one_patch : Cause::other;
}

Cause false_negative_cause(const std::vector<Pixel>& seeing,
                           const edge::Mask& drawn,
                           Cause predicted) {
    if (seeing.empty()) return Cause::sub_pixel;
    if (predicted == Cause::cancelled || predicted == Cause::below_threshold) return predicted;
    const bool is_drawn = std::any_of(
        seeing.begin(), seeing.end(), [&](Pixel p) { return drawn.at(p.x_px, p.y_px) != 0; });
    return is_drawn ? Cause::thinned : predicted;
}

}  // namespace

WrongPixels wrong_pixels(const Strokes& strokes,
                         const PixelList& drawn,
                         const TruthLists& lists,
                         const ScoreOptions& options) {
    WrongPixels wrong{.false_positives = outside(drawn, reach_of(lists.truth, lists.disk)),
                      .false_negatives = outside(lists.truth, reach_of(drawn, lists.disk)),
                      .drawn = strokes.drawn};
    clear_band(wrong.drawn, options.band_px);
    return wrong;
}

std::string_view name(Cause cause) {
    return core::vocabulary().causes[static_cast<std::size_t>(cause)].name;
}

bool sees_line(const TruthStencils& stencils, Pixel pixel) {
    const auto [x, y] = pixel;
    const std::pair<Pixel, Pixel> pairs[4] = {
        {{x - 1, y}, pixel}, {pixel, {x + 1, y}}, {{x, y - 1}, pixel}, {pixel, {x, y + 1}}};
    const core::Image<std::uint32_t>& ids = stencils.triangle;
    bool has_crack = false;
    bool has_two_triangles = false;
    for (const auto& [a, b] : pairs) {
        if (!ids.contains(a.x_px, a.y_px) || !ids.contains(b.x_px, b.y_px)) continue;
        has_crack = has_crack || is_cracked(stencils, a, b);
        has_two_triangles = has_two_triangles || ids.at(a.x_px, a.y_px) != ids.at(b.x_px, b.y_px);
    }
    return has_crack && has_two_triangles;
}

std::vector<Pixel> seeing_stencils(const TruthStencils& stencils, Pixel pixel) {
    std::vector<Pixel> seeing;
    for (int y = pixel.y_px - 1; y <= pixel.y_px + 1; ++y) {
        for (int x = pixel.x_px - 1; x <= pixel.x_px + 1; ++x) {
            if (stencils.triangle.contains(x, y) && sees_line(stencils, {x, y})) {
                seeing.push_back({x, y});
            }
        }
    }
    return seeing;
}

Attribution attribute(const WrongPixels& wrong,
                      const TruthStencils& stencils,
                      std::span<const Cause> predicted,
                      const ScoreOptions& options) {
    assert(predicted.empty() || predicted.size() == wrong.false_negatives.size());
    Attribution result;
    const auto add = [&result](Pixel pixel, Cause cause) {
        result.pixels.push_back({pixel, cause});
        ++result.counts[cause];
    };
    const edge::BitMask band = near_band_truth(stencils.labels, options);
    for (const Pixel pixel : wrong.false_positives)
        add(pixel, false_positive_cause(stencils, band, pixel));
    for (std::size_t i = 0; i < wrong.false_negatives.size(); ++i) {
        const Pixel pixel = wrong.false_negatives[i];
        const Cause cause = predicted.empty() ? Cause::undeclared : predicted[i];
        assert(is_miss(cause));
        add(pixel, false_negative_cause(seeing_stencils(stencils, pixel), wrong.drawn, cause));
    }
    return result;
}

}  // namespace ink::score
