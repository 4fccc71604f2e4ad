#include "draw/sheet.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <glm/common.hpp>
#include <glm/vec2.hpp>

#include "core/parse_number.h"

namespace ink::draw {
namespace {

struct Box {
    glm::dvec2 low{1e300};
    glm::dvec2 high{-1e300};
};

/// Of the lines, px; without any, a point.
Box box_of(const truth::TracedLines& lines) {
    Box box;
    for (const auto* pieces : {&lines.curves, &lines.hidden}) {
        for (const truth::Curve& piece : *pieces) {
            for (const truth::CurvePoint* p : {&piece.begin, &piece.end}) {
                box.low = glm::min(box.low, glm::dvec2(p->x_px, p->y_px));
                box.high = glm::max(box.high, glm::dvec2(p->x_px, p->y_px));
            }
        }
    }
    return box.low.x > box.high.x ? Box{{0, 0}, {0, 0}} : box;
}

constexpr double kAlmost = 1 + 1e-9;  // so that 200 mm fit in 200 mm

/// The largest of 1, 2 and 5 times a power of ten that is not above `most`.
double standard_scale(double most) {
    const double power = std::pow(10, std::floor(std::log10(most * kAlmost)));
    for (const double digit : {5.0, 2.0})
        if (digit * power <= most * kAlmost) return digit * power;
    return power;
}

}  // namespace

double usual_sheet_mm(int width_px) {
    constexpr double kMmPerInch = 25.4, kPxPerInch = 96;
    return width_px * kMmPerInch / kPxPerInch;
}

Sheet image_sheet(const scene::View& view, double width_mm) {
    const double mm_per_px = width_mm / view.width_px;
    return {width_mm, view.height_px * mm_per_px, mm_per_px};
}

std::optional<Sheet> paper_sheet(const Paper& paper,
                                 const scene::View& view,
                                 const truth::TracedLines& lines,
                                 std::optional<double> mm_per_unit) {
    const Box box = box_of(lines);
    const glm::dvec2 size_px = glm::max(box.high - box.low, glm::dvec2(1e-6));
    const glm::dvec2 upright(paper.short_mm, paper.long_mm), across(paper.long_mm, paper.short_mm);
    const auto most = [&](const glm::dvec2& size_mm) {
        const glm::dvec2 room = (size_mm - 2 * kBorder_mm) / size_px;
        return std::min(room.x, room.y);
    };
    const bool is_across = most(across) > most(upright);
    const glm::dvec2 size_mm = is_across ? across : upright;
    double mm_per_px = most(size_mm);
    if (view.camera.is_parallel()) {
        const double units_per_px = view.camera.height_world / view.height_px;
        const double scale = mm_per_unit.value_or(standard_scale(mm_per_px / units_per_px));
        if (scale * units_per_px > mm_per_px * kAlmost) return std::nullopt;
        mm_per_px = scale * units_per_px;
    }
    const glm::dvec2 corner = size_mm / 2.0 - (box.low + box.high) / 2.0 * mm_per_px;
    return Sheet{size_mm.x, size_mm.y, mm_per_px, corner.x, corner.y};
}

double mm_per_unit(const Sheet& sheet, const scene::View& view) {
    return sheet.mm_per_px * view.height_px / view.camera.height_world;
}

std::string scale_text(double mm_per_unit) {
    return mm_per_unit >= 1 ? fmt::format("{:.4g}:1", mm_per_unit)
                            : fmt::format("1:{:.4g}", 1 / mm_per_unit);
}

std::optional<double> parse_scale(const std::string& text) {
    const std::size_t colon = text.find(':');
    const auto paper = core::parse_number<double>(text.substr(0, colon));
    const auto model = colon == std::string::npos
                           ? std::optional(1.0)
                           : core::parse_number<double>(text.substr(colon + 1));
    if (!paper || !model || !(*paper > 0 && *model > 0)) return std::nullopt;
    const double scale = *paper / *model;
    return std::isfinite(scale) && scale > 0 ? std::optional(scale) : std::nullopt;
}

std::string doubt_of_size(const Sheet& sheet) {
    constexpr double kLeast_mm = 20;
    const auto [low, high] = std::minmax(sheet.width_mm, sheet.height_mm);
    const Paper& largest = kPapers.back();
    if (high < kLeast_mm) return fmt::format("smaller than {:g} mm", kLeast_mm);
    if (low <= largest.short_mm * kAlmost && high <= largest.long_mm * kAlmost) return "";
    return fmt::format(
        "larger than {} ({:g} x {:g} mm)", largest.name, largest.long_mm, largest.short_mm);
}

double same_line_px(const Sheet& sheet) {
    constexpr double kSame_mm = 0.02, kMost_px = 0.25;
    return std::min(kSame_mm / sheet.mm_per_px, kMost_px);
}

}  // namespace ink::draw
