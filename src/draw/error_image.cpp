#include "draw/error_image.h"

#include <algorithm>
#include <array>
#include <cassert>
#include <utility>
#include <vector>

#include "draw/palette.h"
#include "edge/thin.h"
#include "truth/line_class.h"

namespace ink::draw {
namespace {

using truth::LineClass;

constexpr auto kIgnoreLabel = static_cast<std::uint8_t>(LineClass::ignore);

/// Gives each drawn pixel the mark of the thinned pixel that is nearest along the drawing. `drawn`
/// comes without those that `front` begins with, the thinned ones, and ends empty: thinning never
/// removes a whole piece.
void spread(std::vector<int> front, edge::Mask& drawn, Marks& marks) {
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
            drawn.at(x, y) = 0;
            marks.at(x, y) = marks.at(i % width, i / width);
            front.push_back(y * width + x);
        }
    }
}

/// Calls `visit(x, y, i)` for each pixel of a list, the i-th.
template <class Visit>
void visit_numbered(const score::PixelList& pixels, Visit visit) {
    std::size_t i = 0;
    pixels.visit([&](int x, int y) { visit(x, y, i++); });
}

glm::u8vec3 colour_of_mark(Mark mark) {
    if (is_wrong(mark)) return colour_of(cause_of(mark)).rgb;
    if (mark == Mark::hit) return kHitColour.rgb;
    return mark == Mark::ignored ? kIgnoredColour.rgb : kPaper.rgb;
}

}  // namespace

RgbImage error_image(const Marks& marks) {
    return core::mapped<glm::u8vec3>(marks, colour_of_mark);
}

RgbImage truth_image(const core::Image<std::uint8_t>& labels) {
    return core::mapped<glm::u8vec3>(
        labels, [](std::uint8_t label) { return colour_of(static_cast<LineClass>(label)).rgb; });
}

ErrorMarker::ErrorMarker(const core::Image<std::uint8_t>& labels, const MarkOptions& options) {
    score::ScoreOptions scoring{.band_px = options.band_px, .ignore_label = kIgnoreLabel};
    const score::ScoringTruth truth = score::prepare_truth(labels, scoring, true);
    truth_ = score::PixelList(truth.labels);
    ignored_ = score::PixelList(truth.ignore);
    undrawn_ = core::mapped<Mark>(
        labels, [](int label) { return label == kIgnoreLabel ? Mark::ignored : Mark::paper; });
}

Marks ErrorMarker::mark(const edge::EdgeImage& edge_response, const MarkOptions& options) const {
    Marks marks = undrawn_;
    assert(marks.width_px() == edge_response.width_px() &&
           marks.height_px() == edge_response.height_px());
    if (marks.is_empty()) return marks;

    edge::Mask drawn = edge::threshold(edge_response, options.threshold);
    edge::BitMask thin(drawn);
    edge::thin(thin);
    std::vector<int> front;
    score::PixelList(thin, 0).visit([&](int x, int y) {
        marks.at(x, y) = Mark::ignored;  // unless it counts
        drawn.at(x, y) = 0;
        front.push_back(y * marks.width_px() + x);
    });
    const score::Disk disk(options.tolerance_px);
    const score::PixelList counted(thin, options.band_px);
    const auto is_hit = score::within_reach(counted, truth_, disk);
    const auto is_excused = score::within_reach(counted, ignored_, disk);
    constexpr Mark kFalse = mark_of(score::Cause::other);
    visit_numbered(counted, [&](int x, int y, std::size_t i) {
        if (is_hit[i] != 0) {
            marks.at(x, y) = Mark::hit;
        } else if (is_excused[i] == 0) {
            marks.at(x, y) = kFalse;
        }
    });
    // Those of one kind that stand on pixels which are wrong that way get their cause.
    const auto name_causes = [&](bool of_misses, Mark unknown) {
        for (const auto& [pixel, cause] : options.wrong) {
            Mark& mark = marks.at(pixel.x_px, pixel.y_px);
            if (score::is_miss(cause) == of_misses && mark == unknown) mark = mark_of(cause);
        }
    };
    name_causes(false, kFalse);
    spread(std::move(front), drawn, marks);
    const auto is_found = score::within_reach(truth_, counted, disk);
    constexpr Mark kMissing = mark_of(score::Cause::undeclared);
    visit_numbered(truth_, [&](int x, int y, std::size_t i) {
        if (is_found[i] == 0) marks.at(x, y) = kMissing;
    });
    name_causes(true, kMissing);
    return marks;
}

Marks mark_errors(const core::Image<std::uint8_t>& labels,
                  const edge::EdgeImage& edge_response,
                  const MarkOptions& options) {
    return ErrorMarker(labels, options).mark(edge_response, options);
}

}  // namespace ink::draw
