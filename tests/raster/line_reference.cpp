#include "line_reference.h"

#include <algorithm>

namespace ink::raster {
namespace {

__extension__ using Wide = __int128;

/// In OpenGL's window (y up), in units of 2^-28 of 1/256 px; e is 2^-14 of 1/256 px.
constexpr Wide kUnit = Wide{1} << 28;
constexpr Wide kE = Wide{1} << 14;
constexpr Wide kE2 = 1;
constexpr Wide kHalf = 128 * kUnit;

struct Point {
    Wide x;
    Wide y;
};

/// numerator / denominator, denominator > 0.
struct Fraction {
    Wide numerator;
    Wide denominator;
};

bool is_less(const Fraction& a, const Fraction& b) {
    return a.numerator * b.denominator < b.numerator * a.denominator;
}

/// The centre of the image's pixel in OpenGL's window of height 0: rows run downwards from it.
Point centre(const Pixel& p) {
    return {(256 * Wide{p.first} + 128) * kUnit, -(256 * Wide{p.second} + 128) * kUnit};
}

Wide size_of(Wide v) {
    return v < 0 ? -v : v;
}

bool is_in_diamond(const Point& p, const Point& at) {
    return size_of(p.x - at.x) + size_of(p.y - at.y) < kHalf;
}

/// Whether some t in [0, 1] brings a + t (b - a) within the open diamond round `at`.
bool meets_diamond(const Point& a, const Point& b, const Point& at) {
    Fraction low{0, 1};
    Fraction high{1, 1};
    bool is_low_open = false;
    bool is_high_open = false;
    for (const int sx : {-1, 1}) {
        for (const int sy : {-1, 1}) {
            // sx (x - at.x) + sy (y - at.y) < half, with x, y linear in t: c + t d < 0.
            const Wide c = sx * (a.x - at.x) + sy * (a.y - at.y) - kHalf;
            const Wide d = sx * (b.x - a.x) + sy * (b.y - a.y);
            if (d == 0) {
                if (c >= 0) return false;
                continue;
            }
            const Fraction t = d > 0 ? Fraction{-c, d} : Fraction{c, -d};
            if (d > 0 && !is_less(high, t)) {
                high = t;
                is_high_open = true;
            }
            if (d < 0 && !is_less(t, low)) {
                low = t;
                is_low_open = true;
            }
        }
    }
    return is_less(low, high) || (!is_low_open && !is_high_open && !is_less(high, low));
}

/// Pixels [x0, x1] x [y0, y1].
struct Box {
    int x0;
    int y0;
    int x1;
    int y1;
};

/// The fragments of width 1 within the box.
std::set<Pixel> fragments(const Point& from, const Point& to, const Box& box) {
    std::set<Pixel> result;
    for (int y = box.y0; y <= box.y1; ++y) {
        for (int x = box.x0; x <= box.x1; ++x) {
            const Point at = centre({x, y});
            if (meets_diamond(from, to, at) && !is_in_diamond(to, at)) result.insert({x, y});
        }
    }
    return result;
}

}  // namespace

std::set<Pixel> reference_line(const ScreenVertex& a, const ScreenVertex& b, int width_px) {
    const Wide dx = b.x - a.x;
    const Wide dy = b.y - a.y;
    if (dx == 0 && dy == 0) return {};
    const bool is_x_major = size_of(dx) >= size_of(dy);
    const int reach = width_px + 2;
    const Box box{std::min(a.x, b.x) / 256 - reach,
                  std::min(a.y, b.y) / 256 - reach,
                  std::max(a.x, b.x) / 256 + reach,
                  std::max(a.y, b.y) / 256 + reach};
    const auto place = [](Wide x, Wide y) { return Point{x * kUnit - kE, -y * kUnit - kE2}; };
    const auto thin = fragments(place(a.x, a.y), place(b.x, b.y), box);

    const Wide times = 512 / std::max(size_of(dx), size_of(dy)) + 1;  // 2 px at either end
    Point from = place(a.x - times * dx, a.y - times * dy);
    Point to = place(b.x + times * dx, b.y + times * dy);
    for (Point* p : {&from, &to})
        (is_x_major ? p->y : p->x) -= (width_px - 1) * kHalf;
    std::set<Pixel> result;
    for (const Pixel& at : fragments(from, to, box)) {
        const bool has_step = std::any_of(thin.begin(), thin.end(), [&](const Pixel& p) {
            return is_x_major ? p.first == at.first : p.second == at.second;
        });
        for (int i = 0; has_step && i < width_px; ++i)
            result.insert(is_x_major ? Pixel{at.first, at.second - i}
                                     : Pixel{at.first + i, at.second});
    }
    return result;
}

}  // namespace ink::raster
