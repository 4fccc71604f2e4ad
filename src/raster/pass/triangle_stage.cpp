#include "raster/pass/triangle_stage.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "core/parallel.h"
#include "raster/pass/clip.h"
#include "raster/pass/screen_vertex.h"

namespace ink::raster {
namespace {

constexpr double kOne = 1 << kCodeFractionBits;
constexpr double kSteepest = 0x1p40;  // times 2^16 pixels stays below 2^57
constexpr double kFarthest = 0x1p60;

/// Rounded to the nearest, halves up, so that no mode of the machine matters; limited to +-`limit`.
std::int64_t to_fixed(double value, double limit) {
    return static_cast<std::int64_t>(std::floor(std::clamp(value * kOne, -limit, limit) + 0.5));
}

std::int64_t floor_to_fixed(double value) {
    return static_cast<std::int64_t>(std::clamp(std::floor(value) * kOne, -kFarthest, kFarthest));
}

constexpr std::size_t kVerticesPerRun = 8192;

/// Every vertex of the input, put on the screen once.
struct VertexBuffer {
    std::vector<ScreenVertex> screen;  ///< of those with outcode kInside
    std::vector<std::uint8_t> outcodes;
};

/// Three corners on the screen and what they carry; values[k] is interpolant k.
struct Piece {
    std::array<ScreenVertex, 3> corners;
    std::array<PerCorner, kMaxPlanes> values;
};

VertexBuffer put_on_screen(const PassInput& input, int threads) {
    const std::size_t count = input.p_clip.size();
    VertexBuffer buffer;
    buffer.screen.resize(count);
    buffer.outcodes.resize(count);
    const std::size_t runs = (count + kVerticesPerRun - 1) / kVerticesPerRun;
    core::parallel_for(runs, threads, [&](std::size_t run) {
        const std::size_t last = std::min(count, (run + 1) * kVerticesPerRun);
        for (std::size_t i = run * kVerticesPerRun; i < last; ++i) {
            buffer.outcodes[i] = outcode(input.p_clip[i], input.near);
            if (buffer.outcodes[i] == kInside) buffer.screen[i] = to_screen(input.p_clip[i]);
        }
    });
    return buffer;
}

/// A fan has one apex; this one makes no triangle of it turn the wrong way, if there is such a one.
///
/// Snapping can dent a convex polygon by a subpixel. Fanned from the wrong corner it would cover
/// the dent, which belongs to the neighbour, twice.
int fan_apex(const std::array<ScreenVertex, ClipPolygon::kMaxCorners>& corners, int count) {
    const auto corner = [&](int i) { return corners[static_cast<std::size_t>(i % count)]; };
    for (int apex = 0; apex < count; ++apex) {
        bool some_left = false;
        bool some_right = false;
        for (int i = 1; i + 1 < count; ++i) {
            const std::int64_t area = area2(corner(apex), corner(apex + i), corner(apex + i + 1));
            some_left = some_left || area < 0;
            some_right = some_right || area > 0;
        }
        if (!some_left || !some_right) return apex;
    }
    return 0;
}

class TriangleStage {
  public:
    TriangleStage(const PassFormat& format,
                  const PassInput& input,
                  const VertexBuffer& vertices,
                  const PixelRect& image)
        : format_(format), input_(input), vertices_(vertices), image_(image) {}

    void run(std::size_t first, std::size_t last, Batch& batch) const;

  private:
    struct Tally {
        int drawn = 0;
        int no_sample = 0;
    };

    [[nodiscard]] const float* values_of(std::uint32_t triangle) const;
    void draw_scalar(std::uint32_t triangle, Batch& batch, Tally& tally) const;
    void draw_clipped(std::uint32_t triangle, Batch& batch, Tally& tally) const;
    void add(const Piece& piece, std::uint32_t triangle, Batch& batch, Tally& tally) const;
    void add_planes(const Piece& piece, const SetupTriangle& set, Batch& batch) const;

    const PassFormat& format_;
    const PassInput& input_;
    const VertexBuffer& vertices_;
    PixelRect image_;
};

const float* TriangleStage::values_of(std::uint32_t triangle) const {
    const bool is_back = !input_.facing.empty() && input_.facing[triangle] < 0;
    return is_back && !input_.values_back.empty() ? input_.values_back.data()
                                                  : input_.values.data();
}

void TriangleStage::add_planes(const Piece& piece, const SetupTriangle& set, Batch& batch) const {
    const PlaneMaker maker(piece.corners, set);
    const PerCorner q{piece.corners[0].q, piece.corners[1].q, piece.corners[2].q};
    const std::uint32_t constant = format_.constant ? input_.constants[set.triangle] : 0;
    for (std::size_t k = 0; k < static_cast<std::size_t>(format_.interpolants); ++k) {
        const PerCorner& values = piece.values[k];
        if (has_code_planes(format_)) {
            batch.code_planes.push_back(make_code_plane(maker, values, constant));
        } else if (format_.interpolation == Interpolation::affine) {
            batch.float_planes.push_back(make_affine_plane(maker, values));
        } else {
            batch.float_planes.push_back(make_perspective_plane(maker, values, q));
        }
    }
}

void TriangleStage::add(const Piece& piece,
                        std::uint32_t triangle,
                        Batch& batch,
                        Tally& tally) const {
    SetupTriangle& set = batch.triangles.emplace_back();
    set.triangle = triangle;
    const SetupResult result = set_up(piece.corners, image_.x1, image_.y1, set);
    if (result == SetupResult::drawn) {
        ++tally.drawn;
        return add_planes(piece, set, batch);
    }
    batch.triangles.pop_back();
    if (result == SetupResult::no_sample) ++tally.no_sample;
}

void TriangleStage::draw_scalar(std::uint32_t triangle, Batch& batch, Tally& tally) const {
    const auto k_count = static_cast<std::size_t>(format_.interpolants);
    const float* values = values_of(triangle);
    Piece piece;
    for (std::size_t i = 0; i < 3; ++i) {
        const std::size_t vertex = input_.triangles[triangle][i];
        piece.corners[i] = vertices_.screen[vertex];
        for (std::size_t k = 0; k < k_count; ++k)
            piece.values[k][i] = values[vertex * k_count + k];
    }
    add(piece, triangle, batch, tally);
}

void TriangleStage::draw_clipped(std::uint32_t triangle, Batch& batch, Tally& tally) const {
    const auto k_count = static_cast<std::size_t>(format_.interpolants);
    const float* values = values_of(triangle);
    std::array<ClipVertex, 3> whole;
    for (std::size_t i = 0; i < 3; ++i) {
        const std::size_t vertex = input_.triangles[triangle][i];
        whole[i].p_clip = input_.p_clip[vertex];
        for (std::size_t k = 0; k < k_count; ++k)
            whole[i].values[k] = values[vertex * k_count + k];
    }
    const ClipPolygon polygon = clip_triangle(whole, input_.near);
    if (polygon.count == 0) return;

    std::array<ScreenVertex, ClipPolygon::kMaxCorners> corners;
    for (std::size_t i = 0; i < static_cast<std::size_t>(polygon.count); ++i)
        corners[i] = to_screen(polygon.corners[i].p_clip);
    const int apex = fan_apex(corners, polygon.count);
    for (int i = 1; i + 1 < polygon.count; ++i) {
        const std::array<int, 3> fan{apex, apex + i, apex + i + 1};
        Piece piece;
        for (std::size_t c = 0; c < 3; ++c) {
            const auto at = static_cast<std::size_t>(fan[c] % polygon.count);
            piece.corners[c] = corners[at];
            for (std::size_t k = 0; k < k_count; ++k)
                piece.values[k][c] = polygon.corners[at].values[k];
        }
        add(piece, triangle, batch, tally);
    }
}

void TriangleStage::run(std::size_t first, std::size_t last, Batch& batch) const {
    for (std::size_t t = first; t < last; ++t) {
        const scene::Triangle& corners = input_.triangles[t];
        const std::uint8_t a = vertices_.outcodes[corners[0]];
        const std::uint8_t b = vertices_.outcodes[corners[1]];
        const std::uint8_t c = vertices_.outcodes[corners[2]];
        Tally tally;
        const bool is_lost = (a & b & c) != 0 || ((a | b | c) & kNotANumber) != 0;
        if ((a | b | c) == kInside) {
            draw_scalar(static_cast<std::uint32_t>(t), batch, tally);
        } else if (!is_lost) {
            draw_clipped(static_cast<std::uint32_t>(t), batch, tally);
        }
        if (tally.drawn == 0 && tally.no_sample > 0) ++batch.no_sample;
    }
}

}  // namespace

CodePlane make_code_plane(const PlaneMaker& maker,
                          const PerCorner& values,
                          std::uint32_t constant) {
    const Plane plane = maker.through(values);
    const auto offset = static_cast<std::int64_t>(constant) << kCodeFractionBits;
    const auto [lowest, highest] = std::minmax({values[0], values[1], values[2]});
    CodePlane code;
    code.at_ref = to_fixed(plane.at_ref, kFarthest) + offset;
    code.dx = to_fixed(plane.dx, kSteepest);
    code.dy = to_fixed(plane.dy, kSteepest);
    code.lowest = floor_to_fixed(lowest) + offset;
    code.highest = floor_to_fixed(highest) + offset;
    return code;
}

FloatPlane make_affine_plane(const PlaneMaker& maker, const PerCorner& values) {
    const auto [lowest, highest] = std::minmax({values[0], values[1], values[2]});
    return {maker.through(values), static_cast<float>(lowest), static_cast<float>(highest)};
}

FloatPlane make_perspective_plane(const PlaneMaker& maker,
                                  const PerCorner& values,
                                  const PerCorner& q) {
    FloatPlane result = make_affine_plane(maker, values);
    result.plane = maker.through({values[0] * q[0], values[1] * q[1], values[2] * q[2]});
    return result;
}

std::vector<Batch> set_up_batches(const PassFormat& format,
                                  const PassInput& input,
                                  const PixelRect& image,
                                  int threads) {
    const VertexBuffer vertices = put_on_screen(input, threads);
    const TriangleStage stage(format, input, vertices, image);
    const std::size_t count = input.triangles.size();
    std::vector<Batch> batches((count + kBatchTriangles - 1) / kBatchTriangles);
    core::parallel_for(batches.size(), threads, [&](std::size_t i) {
        const std::size_t first = i * kBatchTriangles;
        const std::size_t last = std::min(count, first + kBatchTriangles);
        batches[i].triangles.reserve(last - first);
        stage.run(first, last, batches[i]);
    });
    return batches;
}

void set_up_more(const PassFormat& format,
                 const PassInput& input,
                 const PixelRect& image,
                 Batch& batch) {
    const VertexBuffer vertices = put_on_screen(input, 1);
    TriangleStage(format, input, vertices, image).run(0, input.triangles.size(), batch);
}

}  // namespace ink::raster
