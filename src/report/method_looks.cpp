#include "report/method_looks.h"

#include <fmt/format.h>

#include <algorithm>
#include <numbers>
#include <string>
#include <vector>

#include "methods/registry.h"

namespace ink::report {
namespace {

using method::Family;
using method::Marker;

/// The row of the registry called `name`; null if there is none.
const method::MethodInfo* find_row(std::string_view name) {
    const auto& rows = methods::registry();
    const auto found = std::find_if(
        rows.begin(), rows.end(), [&](const method::MethodInfo& row) { return row.name == name; });
    return found == rows.end() ? nullptr : &*found;
}

/// A plus whose arms reach `a` from (x, y) and are 2 b wide.
std::vector<double> plus_corners(double x, double y, double a, double b) {
    return {x - b, y - a, x + b, y - a, x + b, y - b, x + a, y - b, x + a, y + b, x + b, y + b,
            x + b, y + a, x - b, y + a, x - b, y + b, x - a, y + b, x - a, y - b, x - b, y - b};
}

/// Corners of the marker round (x, y), of about the area of a circle of radius r; none for a
/// circle.
std::vector<double> corners(Marker marker, double x, double y, double r) {
    switch (marker) {
        case Marker::square: {
            const double a = 0.9 * r;
            return {x - a, y - a, x + a, y - a, x + a, y + a, x - a, y + a};
        }
        case Marker::diamond: {
            const double a = 1.3 * r;
            return {x, y - a, x + a, y, x, y + a, x - a, y};
        }
        case Marker::up:
            return {x, y - 1.3 * r, x + 1.25 * r, y + 0.95 * r, x - 1.25 * r, y + 0.95 * r};
        case Marker::down:
            return {x, y + 1.3 * r, x + 1.25 * r, y - 0.95 * r, x - 1.25 * r, y - 0.95 * r};
        case Marker::left:
            return {x - 1.3 * r, y, x + 0.95 * r, y - 1.25 * r, x + 0.95 * r, y + 1.25 * r};
        case Marker::right:
            return {x + 1.3 * r, y, x - 0.95 * r, y - 1.25 * r, x - 0.95 * r, y + 1.25 * r};
        case Marker::plus:
            return plus_corners(x, y, 1.2 * r, 0.45 * r);
        case Marker::cross: {
            std::vector<double> xy = plus_corners(0, 0, 1.3 * r, 0.45 * r);
            for (std::size_t i = 0; i < xy.size(); i += 2) {
                const double along = xy[i];
                xy[i] = x + (along - xy[i + 1]) * std::numbers::sqrt2 / 2;
                xy[i + 1] = y + (along + xy[i + 1]) * std::numbers::sqrt2 / 2;
            }
            return xy;
        }
        case Marker::circle:
            break;
    }
    return {};
}

void draw_shape(Svg& svg, double x, double y, double r, Marker marker, std::string_view style) {
    if (marker == Marker::circle) return svg.circle(x, y, r, style);
    svg.polygon(corners(marker, x, y, r), style);
}

}  // namespace

draw::Colour colour_of(Family family) {
    switch (family) {
        case Family::packed:
            return draw::kBlue;
        case Family::full_buffers:
            return draw::kVermilion;
        case Family::ids:
            return draw::kGreen;
        case Family::edges_and_hulls:
            return draw::kPurple;
        case Family::other:
            return draw::kInk;
    }
    return draw::kInk;
}

draw::Colour Look::colour() const {
    return colour_of(family);
}

std::string_view base_of(std::string_view method) {
    constexpr std::string_view kTuned = "_tuned";
    const method::MethodInfo* row = find_row(method);
    if (row != nullptr) return row->preset_of.empty() ? row->name : row->preset_of;
    if (method.ends_with(kTuned)) method.remove_suffix(kTuned.size());
    return method;
}

Look look_of(std::string_view method, std::size_t nth) {
    const std::string_view base = base_of(method);
    const method::MethodInfo* row = find_row(base);
    const bool is_hollow = base != method;
    if (row != nullptr) return {row->family, row->marker, is_hollow};
    return {Family::other, method::kMarkers[nth % method::kMarkers.size()], is_hollow};
}

void draw_marker(Svg& svg, double x, double y, double radius, const Look& look) {
    const std::string_view hex = look.colour().hex;
    draw_shape(
        svg, x, y, radius + (radius > 4 ? 1.2 : 0.4), look.marker, R"(fill="#ffffff" class="rim")");
    const std::string style =
        look.is_hollow
            ? fmt::format(R"(fill="#ffffff" stroke="{}" stroke-width="{:g}")", hex, radius / 3)
            : fmt::format(R"(fill="{}")", hex);
    draw_shape(svg, x, y, look.is_hollow ? radius * 0.85 : radius, look.marker, style);
}

}  // namespace ink::report
