#include "draw/error_image.h"

#include <algorithm>
#include <array>
#include <cassert>
#include <utility>
#include <vector>

#include "draw/palette.h"
#include "edge/thin.h"
#include "score/drawing.h"
#include "score/pixel_list.h"
#include "truth/line_class.h"

namespace ink::draw {
namespace {

using truth::LineClass;

constexpr auto kIgnoreLabel = static_cast<std::uint8_t>(LineClass::ignore);

/// 1 at the pixels of `from` that have a pixel of `to` within the tolerance.
edge::Mask near(const edge::Mask& from, const edge::Mask& to, double tolerance_px) {
    const score::PixelList pixels(from);
    const auto is_near =
        score::within_reach(pixels, score::PixelList(to), score::Disk(tolerance_px));
    edge::Mask mask(from.width_px(), from.height_px());
    for (int y = 0; y < from.height_px(); ++y) {
        for (std::size_t i = pixels.row_begin(y); i < pixels.row_begin(y + 1); ++i) {
            mask.at(pixels.x(i), y) = is_near[i];
        }
    }
    return mask;
}

/// Gives each drawn pixel that has no owner yet the owner of the thinned pixel that is nearest
/// along the drawing. `owner` comes with each thinned pixel owning itself and -1 elsewhere.
/// Thinning never removes a whole piece, so all are reached.
void spread_owners(const edge::Mask& drawn, std::vector<int>& owner) {
    std::vector<int> front;
    for (std::size_t i = 0; i < owner.size(); ++i) {
        if (owner[i] >= 0) front.push_back(static_cast<int>(i));
    }
    const int width = drawn.width_px();
    // A breadth-first walk; the four straight neighbours first, since they are nearer.
    constexpr std::array<std::pair<int, int>, 8> kSteps = {
        {{1, 0}, {-1, 0}, {0, 1}, {0, -1}, {1, 1}, {-1, 1}, {1, -1}, {-1, -1}}};
    for (std::size_t next = 0; next < front.size(); ++next) {
        const int i = front[next];
        for (const auto& [dx, dy] : kSteps) {
            const int x = i % width + dx;
            const int y = i / width + dy;
            if (!drawn.contains(x, y) || drawn.at(x, y) == 0) continue;
            int& other = owner[static_cast<std::size_t>(y * width + x)];
            if (other >= 0) continue;
            other = owner[static_cast<std::size_t>(i)];
            front.push_back(y * width + x);
        }
    }
}

/// What thinned pixels are, outside the band: off the truth they are wrong, unless an ignored pixel
/// excuses them.
struct ThinMarks {
    edge::Mask is_counted;
    edge::Mask is_hit;
    edge::Mask is_excused;

    [[nodiscard]] Mark of(std::size_t i, Mark if_wrong) const {
        if (is_counted.data()[i] == 0) return Mark::ignored;
        if (is_hit.data()[i] != 0) return Mark::hit;
        return is_excused.data()[i] != 0 ? Mark::ignored : if_wrong;
    }
};

/// The marks that pixels have if they are wrong: their causes, or what stands for an unknown one.
struct WrongMarks {
    Marks false_positives;
    Marks false_negatives;

    WrongMarks(const Marks& marks, std::span<const score::WrongPixel> wrong)
        : false_positives(marks.width_px(), marks.height_px(), mark_of(score::Cause::other)),
          false_negatives(marks.width_px(), marks.height_px(), mark_of(score::Cause::undeclared)) {
        for (const auto& [pixel, cause] : wrong) {
            (score::is_miss(cause) ? false_negatives : false_positives).at(pixel.x_px, pixel.y_px) =
                mark_of(cause);
        }
    }
};

ThinMarks judge(const edge::Mask& thin,
                const score::ScoringTruth& truth,
                const MarkOptions& options) {
    ThinMarks marks;
    marks.is_counted = thin;
    score::clear_band(marks.is_counted, options.band_px);
    marks.is_hit = near(marks.is_counted, truth.labels, options.tolerance_px);
    marks.is_excused = near(marks.is_counted, truth.ignore, options.tolerance_px);
    return marks;
}

glm::u8vec3 colour_of_mark(Mark mark) {
    if (is_wrong(mark)) return colour_of(cause_of(mark)).rgb;
    if (mark == Mark::hit) return kHitColour.rgb;
    return mark == Mark::ignored ? kIgnoredColour.rgb : kPaper.rgb;
}

/// The most important pixel of each factor x factor block; `matters_more(a, b)` says a beats b.
template <class T, class Order>
core::Image<T> shrink_by(const core::Image<T>& image, int factor, Order matters_more) {
    assert(factor >= 1);
    const auto shrunk = [factor](int size) { return (size + factor - 1) / factor; };
    if (factor == 1) return image;
    core::Image<T> small(shrunk(image.width_px()), shrunk(image.height_px()));
    for (int y = 0; y < image.height_px(); ++y) {
        const T* from = image.row(y);
        T* const to = small.row(y / factor);
        for (int x = 0; x < small.width_px(); ++x) {
            const int end = std::min((x + 1) * factor, image.width_px()) - x * factor;
            for (int i = 0; i < end; ++i, ++from)
                if (matters_more(*from, to[x])) to[x] = *from;
        }
    }
    return small;
}

}  // namespace

RgbImage error_image(const Marks& marks) {
    return core::mapped<glm::u8vec3>(marks, colour_of_mark);
}

RgbImage truth_image(const core::Image<std::uint8_t>& labels) {
    return core::mapped<glm::u8vec3>(
        labels, [](std::uint8_t label) { return colour_of(static_cast<LineClass>(label)).rgb; });
}

Marks shrink(const Marks& image, int factor) {
    return shrink_by(image, factor, [](Mark a, Mark b) { return a > b; });
}

core::Image<std::uint8_t> shrink(const core::Image<std::uint8_t>& labels, int factor) {
    // 0, "nothing", is the lowest number but matters least.
    const auto rank = [](std::uint8_t label) { return label == 0 ? 256 : int{label}; };
    return shrink_by(
        labels, factor, [&](std::uint8_t a, std::uint8_t b) { return rank(a) < rank(b); });
}

ErrorMarker::ErrorMarker(const core::Image<std::uint8_t>& labels, const MarkOptions& options)
    : labels_(labels) {
    score::ScoreOptions scoring{.band_px = options.band_px, .ignore_label = kIgnoreLabel};
    truth_ = score::prepare_truth(labels, scoring, true);
}

Marks ErrorMarker::mark(const edge::EdgeImage& edge_response, const MarkOptions& options) const {
    assert(labels_.width_px() == edge_response.width_px() &&
           labels_.height_px() == edge_response.height_px());
    Marks marks(labels_.width_px(), labels_.height_px());
    if (marks.is_empty()) return marks;

    const edge::Mask drawn = edge::threshold(edge_response, options.threshold);
    const edge::Mask thin = edge::thin(drawn);
    const ThinMarks thin_marks = judge(thin, truth_, options);
    std::vector<int> owner(thin.size(), -1);
    for (std::size_t i = 0; i < owner.size(); ++i) {
        if (thin.data()[i] != 0) owner[i] = static_cast<int>(i);
    }
    spread_owners(drawn, owner);
    const WrongMarks wrong(marks, options.wrong);
    const edge::Mask is_found = near(truth_.labels, thin_marks.is_counted, options.tolerance_px);
    for (std::size_t i = 0; i < marks.size(); ++i) {
        if (drawn.data()[i] != 0) {
            const auto thinned = static_cast<std::size_t>(owner[i]);
            marks.data()[i] = thin_marks.of(thinned, wrong.false_positives.data()[thinned]);
        } else if (labels_.data()[i] == kIgnoreLabel) {
            marks.data()[i] = Mark::ignored;
        }
        const bool is_missing = truth_.labels.data()[i] != 0 && is_found.data()[i] == 0;
        if (is_missing) marks.data()[i] = wrong.false_negatives.data()[i];
    }
    return marks;
}

Marks mark_errors(const core::Image<std::uint8_t>& labels,
                  const edge::EdgeImage& edge_response,
                  const MarkOptions& options) {
    return ErrorMarker(labels, options).mark(edge_response, options);
}

}  // namespace ink::draw
