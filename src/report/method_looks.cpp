#include "report/method_looks.h"

#include <fmt/format.h>

#include <string>
#include <vector>

namespace ink::report {
namespace {

struct KnownLook {
    std::string_view method;
    Family family;
    Shape shape;
};

// A new method gets a line here; tests hold that no two registered methods look alike.
constexpr KnownLook kLooks[] = {
    {"mote2", Family::packed, Shape::circle},
    {"mote4", Family::packed, Shape::square},
    {"mote16", Family::packed, Shape::diamond},
    {"auto", Family::packed, Shape::up},
    {"canny", Family::packed, Shape::down},
    {"decaudin", Family::full_buffers, Shape::circle},
    {"roberts", Family::full_buffers, Shape::square},
    {"sobel", Family::full_buffers, Shape::diamond},
    {"plane_distance", Family::full_buffers, Shape::up},
    {"ids", Family::ids, Shape::circle},
    {"jump_flood", Family::ids, Shape::square},
    {"edge_list", Family::edges, Shape::circle},
    {"edge_hash", Family::edges, Shape::square},
    {"polygon_offset", Family::edges, Shape::diamond},
    {"back_faces", Family::edges, Shape::up},
    {"inverted_hull", Family::edges, Shape::down},
};

/// Corners of the shape round (x, y), of about the area of a circle of radius r; none for a circle.
std::vector<double> corners(Shape shape, double x, double y, double r) {
    switch (shape) {
        case Shape::square: {
            const double a = 0.9 * r;
            return {x - a, y - a, x + a, y - a, x + a, y + a, x - a, y + a};
        }
        case Shape::diamond: {
            const double a = 1.3 * r;
            return {x, y - a, x + a, y, x, y + a, x - a, y};
        }
        case Shape::up:
            return {x, y - 1.3 * r, x + 1.25 * r, y + 0.95 * r, x - 1.25 * r, y + 0.95 * r};
        case Shape::down:
            return {x, y + 1.3 * r, x + 1.25 * r, y - 0.95 * r, x - 1.25 * r, y - 0.95 * r};
        case Shape::circle:
            break;
    }
    return {};
}

void draw_shape(Svg& svg, double x, double y, double r, Shape shape, std::string_view style) {
    if (shape == Shape::circle) return svg.circle(x, y, r, style);
    svg.polygon(corners(shape, x, y, r), style);
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
        case Family::edges:
            return draw::kPurple;
        case Family::other:
            return draw::kInk;
    }
    return draw::kInk;
}

std::string_view label_of(Family family) {
    switch (family) {
        case Family::packed:
            return "packed";
        case Family::full_buffers:
            return "full buffers";
        case Family::ids:
            return "ids";
        case Family::edges:
            return "edges, hulls";
        case Family::other:
            return "other";
    }
    return "other";
}

draw::Colour Look::colour() const {
    return colour_of(family);
}

Look look_of(std::string_view method, std::size_t nth) {
    constexpr std::string_view kTuned = "_tuned";
    Look look;
    look.is_hollow = method.ends_with(kTuned);
    if (look.is_hollow) method.remove_suffix(kTuned.size());
    for (const KnownLook& known : kLooks) {
        if (known.method != method) continue;
        look.family = known.family;
        look.shape = known.shape;
        return look;
    }
    look.shape = static_cast<Shape>(nth % 5);
    return look;
}

void draw_marker(Svg& svg, double x, double y, double radius, const Look& look) {
    const std::string_view hex = look.colour().hex;
    draw_shape(
        svg, x, y, radius + (radius > 4 ? 1.2 : 0.4), look.shape, R"(fill="#ffffff" class="rim")");
    const std::string style =
        look.is_hollow
            ? fmt::format(R"(fill="#ffffff" stroke="{}" stroke-width="{:g}")", hex, radius / 3)
            : fmt::format(R"(fill="{}")", hex);
    draw_shape(svg, x, y, look.is_hollow ? radius * 0.85 : radius, look.shape, style);
}

}  // namespace ink::report
