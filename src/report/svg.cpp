#include "report/svg.h"

#include <fmt/format.h>

#include "core/escape.h"

namespace ink::report {
namespace {

constexpr const char* kFace =
    "system-ui,-apple-system,&quot;Segoe UI&quot;,Roboto,&quot;Noto Sans&quot;,&quot;DejaVu "
    "Sans&quot;,sans-serif";

std::string text_attributes(const TextStyle& style) {
    std::string text = fmt::format(R"(font-size="{:g}" fill="{}")", style.size, style.fill);
    if (style.anchor != "start") text += fmt::format(R"( text-anchor="{}")", style.anchor);
    if (style.is_bold) text += R"( font-weight="600")";
    return text;
}

std::string point_list(const std::vector<double>& xy) {
    std::string points;
    for (std::size_t i = 0; i + 1 < xy.size(); i += 2) {
        points += fmt::format("{}{:.1f},{:.1f}", i == 0 ? "" : " ", xy[i], xy[i + 1]);
    }
    return points;
}

}  // namespace

void Svg::line(double x1, double y1, double x2, double y2, std::string_view style) {
    body_ += fmt::format(
        R"(<line x1="{:.1f}" y1="{:.1f}" x2="{:.1f}" y2="{:.1f}" {}/>)", x1, y1, x2, y2, style);
}

void Svg::rect(const Box& box, std::string_view style) {
    body_ += fmt::format(R"(<rect x="{:.1f}" y="{:.1f}" width="{:.1f}" height="{:.1f}" {}/>)",
                         box.x,
                         box.y,
                         box.width,
                         box.height,
                         style);
}

void Svg::circle(double x, double y, double radius, std::string_view style) {
    body_ += fmt::format(R"(<circle cx="{:.1f}" cy="{:.1f}" r="{:.1f}" {}/>)", x, y, radius, style);
}

void Svg::polyline(const std::vector<double>& xy, std::string_view style) {
    body_ += fmt::format(R"(<polyline points="{}" fill="none" {}/>)", point_list(xy), style);
}

void Svg::polygon(const std::vector<double>& xy, std::string_view style) {
    body_ += fmt::format(R"(<polygon points="{}" {}/>)", point_list(xy), style);
}

void Svg::text(double x, double y, std::string_view text, const TextStyle& style) {
    body_ += fmt::format(R"(<text x="{:.1f}" y="{:.1f}" {}>{}</text>)",
                         x,
                         y,
                         text_attributes(style),
                         core::escape(text));
}

void Svg::vertical_text(double x, double y, std::string_view text, const TextStyle& style) {
    body_ += fmt::format(
        R"svg(<text transform="translate({:.1f} {:.1f}) rotate(-90)" text-anchor="middle" {}>{}</text>)svg",
        x,
        y,
        text_attributes({"start", style.fill, style.size, style.is_bold}),
        core::escape(text));
}

std::string Svg::inline_element(std::string_view title) const {
    return fmt::format(
        R"(<svg viewBox="0 0 {0:g} {1:g}" width="{0:g}" height="{1:g}" role="img" aria-label="{2}" font-family="{3}">{4}</svg>)",
        width_,
        height_,
        core::escape(title),
        kFace,
        body_);
}

std::string Svg::file(std::string_view title) const {
    return fmt::format(
        R"(<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 {0:g} {1:g}" width="{0:g}" height="{1:g}" role="img" font-family="{3}"><title>{2}</title><rect width="100%" height="100%" fill="#ffffff"/>{4}</svg>
)",
        width_,
        height_,
        core::escape(title),
        kFace,
        body_);
}

double text_width(std::string_view text, double size) {
    constexpr double kMeanAdvance_em = 0.6;
    return kMeanAdvance_em * size * static_cast<double>(text.size());
}

}  // namespace ink::report
