#include "raster/pass/tile_fill.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace ink::raster {
namespace {

struct FloatRange {
    float least;
    float greatest;
};

/// What the depth test sees of a triangle in a rectangle.
FloatRange depth_in(const SetupTriangle& t, const PixelRect& rect) {
    const auto at = [&](int x, int y) {
        const double q_row = t.q.at_ref + t.q.dy * (y - t.ref_y);
        return static_cast<float>(std::clamp(q_row + t.q.dx * (x - t.ref_x), t.q_min, t.q_max));
    };
    const std::array<float, 4> corners = {at(rect.x0, rect.y0),
                                          at(rect.x1 - 1, rect.y0),
                                          at(rect.x0, rect.y1 - 1),
                                          at(rect.x1 - 1, rect.y1 - 1)};
    const auto [least, greatest] = std::ranges::minmax_element(corners);
    return {*least, *greatest};
}

bool covers(const SetupTriangle& t, const PixelRect& rect) {
    for (const EdgeFunction& e : t.edges) {
        const int x = e.dx > 0 ? rect.x0 : rect.x1 - 1;
        const int y = e.dy > 0 ? rect.y0 : rect.y1 - 1;
        if (e.at(x, y) < 0) return false;
    }
    return true;
}

bool touches(const SetupTriangle& t, const PixelRect& rect) {
    return t.bounds.x0 < rect.x1 && rect.x0 < t.bounds.x1 && t.bounds.y0 < rect.y1 &&
           rect.y0 < t.bounds.y1 && !misses(t, rect);
}

bool holds(const PixelRect& outer, const PixelRect& inner) {
    return inner.x0 >= outer.x0 && inner.y0 >= outer.y0 && inner.x1 <= outer.x1 &&
           inner.y1 <= outer.y1;
}

/// The pixels [begin, end) of one row.
struct Span {
    int begin = 0;
    int end = 0;
};

/// The centres of row y in [x0, x1) inside the triangle: convex, so one run.
Span covered_span(const SetupTriangle& t, const Span& row, int y) {
    std::int64_t e0 = t.edges[0].at(row.begin, y);
    std::int64_t e1 = t.edges[1].at(row.begin, y);
    std::int64_t e2 = t.edges[2].at(row.begin, y);
    const std::int64_t dx0 = t.edges[0].dx;
    const std::int64_t dx1 = t.edges[1].dx;
    const std::int64_t dx2 = t.edges[2].dx;
    const auto step = [&] {
        e0 += dx0;
        e1 += dx1;
        e2 += dx2;
    };
    Span span{row.begin, row.begin};
    for (; span.begin < row.end && (e0 | e1 | e2) < 0; ++span.begin)
        step();
    for (span.end = span.begin; span.end < row.end && (e0 | e1 | e2) >= 0; ++span.end)
        step();
    return span;
}

/// What a triangle leaves at a pixel, by the formulas that lanes follow.
class PixelWriter {
  public:
    PixelWriter(const FillJob& job, const BinEntry& entry, TileBuffer& to)
        : format_(job.format),
          depth_(format_.depth, job.input.near, job.input.far),
          batch_(job.batches[entry.batch]),
          t_(batch_.triangles[entry.index]),
          first_plane_(entry.index * static_cast<std::size_t>(format_.interpolants)),
          constant_(format_.constant ? job.input.constants[t_.triangle] : 0),
          to_(to) {}

    /// Whether it is nearer than what was there; writes it then.
    bool write(int x, int y, double q) {
        const bool is_nearer = format_.depth == DepthFormat::q32
                                   ? replace(to_.depth_row<float>(y)[x], static_cast<float>(q))
                                   : replace(to_.depth_row<std::uint32_t>(y)[x], depth_.of(q));
        if (!is_nearer || format_.store == Store::none) return is_nearer;
        if (format_.interpolants == 0) {
            write_constant(x, y);
            return true;
        }
        for (int k = 0; k < format_.interpolants; ++k) {
            if (format_.store == Store::f32) {
                to_.plane_row<float>(k, y)[x] = number(k, x, y, q);
            } else {
                to_.code_row(k, y)[x] = stored(fixed(k, x, y, q));
            }
        }
        return true;
    }

  private:
    template <class T>
    static bool replace(T& old, T depth) {
        const bool is_nearer = depth > old;
        if (is_nearer) old = depth;
        return is_nearer;
    }
    void write_constant(int x, int y) {
        if (format_.store == Store::u8) {
            to_.plane_row<std::uint8_t>(0, y)[x] = static_cast<std::uint8_t>(constant_);
        } else {
            to_.plane_row<std::uint32_t>(0, y)[x] = constant_;
        }
    }
    [[nodiscard]] float number(int k, int x, int y, double q) const {
        const FloatPlane& p = batch_.float_planes[first_plane_ + static_cast<std::size_t>(k)];
        const bool is_perspective = format_.interpolation == Interpolation::perspective;
        const double at_row = p.plane.at_ref + p.plane.dy * (y - t_.ref_y);
        const double v = at_row + p.plane.dx * (x - t_.ref_x);
        const auto value = static_cast<float>(is_perspective ? v / q : v);
        return is_perspective || t_.is_thin ? std::clamp(value, p.lowest, p.highest) : value;
    }
    /// A code in 48.16.
    [[nodiscard]] std::int64_t fixed(int k, int x, int y, double q) const {
        if (!has_code_planes(format_)) {
            constexpr double kFarthest = 0x1p60;
            const double whole =
                std::floor(static_cast<double>(number(k, x, y, q)) * (1 << kCodeFractionBits));
            return static_cast<std::int64_t>(std::clamp(whole, -kFarthest, kFarthest)) +
                   (static_cast<std::int64_t>(constant_) << kCodeFractionBits);
        }
        const CodePlane& p = batch_.code_planes[first_plane_ + static_cast<std::size_t>(k)];
        const std::int64_t v = p.at_ref + p.dy * (y - t_.ref_y) + p.dx * (x - t_.ref_x);
        return t_.is_thin ? std::clamp(v, p.lowest, p.highest) : v;
    }
    [[nodiscard]] std::uint32_t stored(std::int64_t fixed) const {
        const std::int64_t most = format_.store == Store::u8 ? 0xff : 0xffff;
        const std::int64_t code = fixed >> kCodeFractionBits;
        return static_cast<std::uint32_t>(format_.overflow == Overflow::wrap
                                              ? code & most
                                              : std::clamp<std::int64_t>(code, 0, most));
    }

    const PassFormat& format_;
    QuantisedDepth depth_;
    const Batch& batch_;
    const SetupTriangle& t_;
    std::size_t first_plane_;
    std::uint32_t constant_;
    TileBuffer& to_;
};

/// Returns whether it is seen anywhere.
bool fill_plainly(const FillJob& job, const BinEntry& entry, TileBuffer& buffer) {
    bool is_seen = false;
    const SetupTriangle& t = job.batches[entry.batch].triangles[entry.index];
    const PixelRect& area = buffer.drawn();
    const Span row{std::max(t.bounds.x0, area.x0), std::min(t.bounds.x1, area.x1)};
    const int y_end = std::min(t.bounds.y1, area.y1);
    PixelWriter writer(job, entry, buffer);
    for (int y = std::max(t.bounds.y0, area.y0); y < y_end; ++y) {
        const Span span = covered_span(t, row, y);
        const double q_row = t.q.at_ref + t.q.dy * (y - t.ref_y);
        for (int x = span.begin; x < span.end; ++x) {
            const double q = std::clamp(q_row + t.q.dx * (x - t.ref_x), t.q_min, t.q_max);
            is_seen = writer.write(x, y, q) || is_seen;
        }
    }
    return is_seen;
}

}  // namespace

/// Depths of whole steps may be equal where these are not.
bool FlatProof::is_behind(const Listed& far, const Listed& near, const PixelRect& rect) const {
    return format_.depth == DepthFormat::q32 &&
           depth_in(far.triangle(), rect).greatest < depth_in(near.triangle(), rect).least;
}

/// A code that saturates anywhere in the rectangle is no floor of an affine function there.
bool FlatProof::is_unlimited(const Listed& listed, const PixelRect& rect) const {
    const SetupTriangle& t = listed.triangle();
    if (t.is_thin) return false;
    if (format_.overflow == Overflow::wrap) return true;
    const std::int64_t most = format_.store == Store::u8 ? 0xff : 0xffff;
    const auto planes = static_cast<std::size_t>(format_.interpolants);
    for (std::size_t k = 0; k < planes; ++k) {
        const CodePlane& plane = listed.batch->code_planes[listed.index * planes + k];
        for (const int x : {rect.x0, rect.x1 - 1}) {
            for (const int y : {rect.y0, rect.y1 - 1}) {
                const std::int64_t code =
                    (plane.at_ref + plane.dy * (y - t.ref_y) + plane.dx * (x - t.ref_x)) >>
                    kCodeFractionBits;
                if (code < 0 || code > most) return false;
            }
        }
    }
    return true;
}

bool FlatProof::is_flat(const PixelRect& rect) const {
    const auto owner = std::ranges::find_if(triangles_, [&](const Listed& l) {
        return holds(l.triangle().bounds, rect) && covers(l.triangle(), rect) &&
               std::ranges::all_of(triangles_, [&](const Listed& other) {
                   return (other.batch == l.batch && other.index == l.index) ||
                          !touches(other.triangle(), rect) || is_behind(other, l, rect);
               });
    });
    return owner != triangles_.end() && is_unlimited(*owner, rect);
}

bool fill_tile(const FillJob& job, std::span<const BinEntry> entries, TileBuffer& buffer) {
    bool is_seen = false;
    for (const BinEntry& entry : entries)
        is_seen = fill_plainly(job, entry, buffer) || is_seen;
    return is_seen;
}

}  // namespace ink::raster
