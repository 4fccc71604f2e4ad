#pragma once

#include <array>
#include <cstdint>

#include "buffers/surface_method.h"
#include "buffers/surface_pass.h"
#include "buffers/tile_buffer.h"
#include "edge/edge_image.h"
#include "method/cost.h"
#include "scene/camera.h"

namespace ink::buffers {

/// The four planes of a full buffer: depth as it was carried, and the view-space normal.
class FullBuffers : public SurfacePass {
  public:
    FullBuffers(const InputParams& params, int halo_px);

    /// How this frame's depth is carried. Before draw(), for the sink.
    [[nodiscard]] method::DepthCarrier see(const method::Frame& frame);
    /// Draws the frame that was seen. Where nothing is, normals are null and depth is `sky`, or
    /// kNothingDrawn where the carrier's depth is yet to be encoded.
    [[nodiscard]] raster::SkipCounts draw(const method::Frame& frame,
                                          const method::DepthCarrier& carrier,
                                          float sky,
                                          raster::TileSink& sink,
                                          edge::EdgeImage& out);

    /// `depth`: its codes 0..1 from black to white, sky black; `normal`: (n + 1) / 2 of x, y, z as
    /// red, green, blue, sky black. Drawn anew.
    [[nodiscard]] std::vector<method::Layer> layers(const method::Frame& frame);

  private:
    InputParams params_;
};

/// Encoded depth of a tile, halo included: its own plane if that holds it, else made in `buffer`.
[[nodiscard]] TilePlane encoded_depth(const raster::Tile& tile,
                                      const method::DepthCarrier& carrier,
                                      DepthSign sign,
                                      float sky,
                                      TileFloats& buffer);

/// 1 / distance of a tile whose sky is kNothingDrawn, halo included; 0 there. `carrier` carries
/// what is encoded as it stands, over `range`.
[[nodiscard]] TilePlane inverse_distance(const raster::Tile& tile,
                                         const method::DepthCarrier& carrier,
                                         const raster::DepthRange& range,
                                         TileFloats& buffer);

/// The view-space normals of a tile, halo included: its own planes, or scaled to length 1 in
/// `buffers`; a null normal stays null.
[[nodiscard]] std::array<TilePlane, 3> view_normals(const raster::Tile& tile,
                                                    bool renormalise,
                                                    std::array<TileFloats, 3>& buffers);

/// Where a view's pixel centres lie in view space: at distance 1 along the view direction, so that
/// the surface at distance w of pixel (x, y) is at w * (x(x), y(y), -1); under a parallel camera
/// anywhere, and that surface is at (x(x), y(y), -w).
class PixelPlaces {
  public:
    explicit PixelPlaces(const scene::View& view);

    [[nodiscard]] float x(int x_px) const {
        return (static_cast<float>(x_px) + 0.5F - center_x_px_) * per_px_;
    }
    [[nodiscard]] float y(int y_px) const {
        return (center_y_px_ - (static_cast<float>(y_px) + 0.5F)) * per_px_;
    }

    /// What one pixel is worth.
    [[nodiscard]] float per_px() const { return per_px_; }

  private:
    float center_x_px_;
    float center_y_px_;
    float per_px_;
};

/// `params` with depth as the interpolation carries it, 1/w or w: both tell the distance.
[[nodiscard]] InputParams with_distances(InputParams params);

/// |n . v| of every pixel and its halo, v the unit direction to the eye: 1 seen face-on, 0 on edge
/// and where nothing is.
void facing_ratio(const raster::Tile& tile,
                  const std::array<TilePlane, 3>& normals,
                  const PixelPlaces& places,
                  bool is_parallel,
                  TileFloats& out);

/// Roberts' cross of a plane on a tile's own pixels, half of it: a step's own height where it runs
/// along rows or columns.
void half_cross(const raster::Tile& tile, const TilePlane& plane, TileFloats& out);

/// The length of the vector of half crosses of a normal: 2 sin(a / 2) across a crease of angle a, 1
/// against nothing.
void normal_cross(const raster::Tile& tile,
                  const std::array<TilePlane, 3>& normals,
                  TileFloats& out);

/// The largest and the least of the four pixels of a cross.
struct CrossRange {
    float least;
    float most;
};
[[nodiscard]] inline CrossRange cross_range(const float* upper, const float* lower) {
    const auto lesser = [](float a, float b) { return a < b ? a : b; };
    const auto larger = [](float a, float b) { return a < b ? b : a; };
    return {lesser(lesser(upper[0], upper[1]), lesser(lower[0], lower[1])),
            larger(larger(upper[0], upper[1]), larger(lower[0], lower[1]))};
}

/// How strong a line is that exceeds its threshold `ratio` times: 0 below once, then 64 a time, up
/// to 255.
[[nodiscard]] inline std::uint8_t response_of_ratio(float ratio) {
    if (!(ratio >= 1)) return 0;
    return ratio >= 4 ? 255 : static_cast<std::uint8_t>(ratio * 64);
}

/// What a filter over full buffers is told of its frame.
struct FullBufferFrame {
    method::DepthCarrier carrier;
    raster::DepthRange range;  ///< the distances that depth 1 and 0 stand for
    PixelPlaces places;
    scene::Projection projection;
    scene::DepthSlope per_distance;  ///< Projection::q_per_distance
};

/// What a cross over distances and normals reads of a tile, halo included.
class CrossPlanes {
  public:
    CrossPlanes(const raster::Tile& tile, const FullBufferFrame& frame, bool renormalise)
        : q(inverse_distance(tile, frame.carrier, frame.range, q_buffer_)),
          normals(view_normals(tile, renormalise, normal_buffers_)) {}
    CrossPlanes(const CrossPlanes&) = delete;

  private:
    TileFloats q_buffer_;
    std::array<TileFloats, 3> normal_buffers_;

  public:
    const TilePlane q;  ///< 1 / distance, 0 where nothing is
    const std::array<TilePlane, 3> normals;
};

/// Writes a tile's edge responses: the larger of `step_ratio(x, y, range)`, by how much a step
/// exceeds its threshold where 1/distance has that range, and of the normal's turn over
/// `normal_step`. Against the sky, which is at no distance and has no plane, a line is full.
template <class StepRatio>
void write_cross(const raster::Tile& tile,
                 const CrossPlanes& planes,
                 double normal_step,
                 const StepRatio& step_ratio,
                 edge::EdgeImage& out) {
    const TilePlane& q = planes.q;
    TileFloats turn;
    normal_cross(tile, planes.normals, turn);
    const float per_turn = 1 / static_cast<float>(normal_step);
    for (int y = 0; y < tile.height_px; ++y) {
        std::uint8_t* to = out.row(tile.y0_px + y) + tile.x0_px;
        for (int x = 0; x < tile.width_px; ++x) {
            const CrossRange near = cross_range(q.row(y) + x, q.row(y + 1) + x);
            if (near.least == 0) {
                to[x] = near.most > 0 ? 255 : 0;
                continue;
            }
            const float step = step_ratio(x, y, near);
            const float turned = turn.row(y)[x] * per_turn;
            to[x] = response_of_ratio(step < turned ? turned : step);
        }
    }
}

/// Appends the row `sky`.
template <class P>
core::ParamTable<P>& add_sky_depth_param(core::ParamTable<P>& table) {
    return table.number(&P::sky,
                        "sky",
                        {-1, 1},
                        "depth",
                        "Depth of empty pixels; -1 stands for infinity, a whole range beyond far.");
}

/// Appends the row `normal_step`, of write_cross.
template <class P>
core::ParamTable<P>& add_normal_step_param(core::ParamTable<P>& table) {
    return table.number(
        &P::normal_step,
        "normal_step",
        {1e-3, 2},
        "",
        "Least change of the normal that is a line: 2 sin(a/2) for a crease of angle a.");
}

/// A method that filters depth and view-space normals as floats: all but the filter itself.
class FullBufferMethod : public SurfaceMethod<FullBuffers> {
  public:
    /// `depth` and `normal`, see FullBuffers.
    [[nodiscard]] std::vector<method::Layer> layers(const method::Frame& frame) override {
        return pass().layers(frame);
    }

  protected:
    /// The filter sees `halo_px` pixels beyond its tile, and depth `sky` where nothing is; with
    /// kNothingDrawn it sees depth as it was carried and encodes it itself.
    FullBufferMethod(const InputParams& params, int halo_px, float sky = method::kNothingDrawn)
        : SurfaceMethod(params, halo_px), sky_(sky) {}

    /// Writes the edge responses of a tile that something was drawn to. Called by several threads,
    /// for a tile each.
    virtual void filter(const FullBufferFrame& frame,
                        const raster::Tile& tile,
                        edge::EdgeImage& out) const = 0;

  private:
    raster::SkipCounts draw_lines(const method::Frame& frame, edge::EdgeImage& out) final;

    float sky_;
};

/// What encoded_depth() moves at a pixel.
[[nodiscard]] method::PixelBytes encoded_depth_bytes(const InputParams& params);

/// What view_normals() moves at a pixel.
[[nodiscard]] method::PixelBytes view_normals_bytes(bool renormalise);

}  // namespace ink::buffers
