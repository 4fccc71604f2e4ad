// Roberts' cross (1963) over a depth and a normal buffer, as outline passes of game engines have
// it. With A B over C D the four pixels of a cross
//
//     half(x) = (|A - D| + |B - C|) / 2
//
// of 1/w, over what a guard against grazing angles asks, and of the normal; the larger counts.

#include <algorithm>

#include "buffers/full_buffer_method.h"

namespace ink::methods {
namespace {

/// How the threshold on depth grows where a surface is seen at a grazing angle.
enum class Guard {
    none,
    ramp,    ///< from guard_start on, up to 1 + guard_scale times
    cosine,  ///< by 1 / |n . v|, in step with a plane's own slope, which is taken off
};

class Roberts : public buffers::FullBufferMethod {
  public:
    struct Params : buffers::InputParams {
        Guard guard = Guard::cosine;
        double guard_start = 0.5;
        double guard_scale = 7;
        // found: experiments/thresholds.py, over the training scenes at 1280x720; see the page
        double depth_step = 0.0025;
        double normal_step = 0.2;
        int threshold = 74;
    };
    static core::ParamTable<Params> table() {
        core::ParamTable<Params> table;
        buffers::add_normal_step_param(
            table.number(&Params::depth_step,
                         "depth_step",
                         {1e-4, 1},
                         "",
                         "Least step of 1/distance that is a line, as a share of the nearer's."));
        table
            .choice(
                &Params::guard,
                "guard",
                {"none", "ramp", "cosine"},
                "How the threshold on depth grows at grazing angles: not, by a ramp, by 1/|n.v|.")
            .number(&Params::guard_start,
                    "guard_start",
                    {0, 0.99},
                    "",
                    "1 - |n.v| at which the ramp begins to rise (guard = ramp).")
            .number(&Params::guard_scale,
                    "guard_scale",
                    {0, 100},
                    "",
                    "How much the ramp adds to the threshold's factor at grazing angles (guard = "
                    "ramp).");
        return method::add_threshold(
            buffers::add_samples_param(buffers::add_surface_params(table)));
    }
    explicit Roberts(const Params& params)
        : FullBufferMethod(buffers::with_distances(params), 1), params_(params) {}

  private:
    /// A step of depth as a share of what the guard asks of it. The cosine takes a plane's own step
    /// off: with f the focal length in px, r the ray and v its direction, 1/w changes by |n_x| / (f
    /// n.r) of itself from one pixel to the next, which times n.v is at most 1 / f.
    [[nodiscard]] float guarded(float step, float facing, float per_px) const {
        switch (params_.guard) {
            case Guard::none:
                return step;
            case Guard::ramp: {
                const auto start = static_cast<float>(params_.guard_start);
                const float grazing = std::clamp((1 - facing - start) / (1 - start), 0.0F, 1.0F);
                return step / (1 + static_cast<float>(params_.guard_scale) * grazing);
            }
            case Guard::cosine:
                break;
        }
        return step * facing - per_px;
    }
    void filter(const buffers::FullBufferFrame& frame,
                const raster::Tile& tile,
                edge::EdgeImage& out) const override {
        const buffers::CrossPlanes planes(tile, frame, params_.renormalise);
        buffers::TileFloats facing;
        buffers::TileFloats depth_cross;
        buffers::facing_ratio(
            tile, planes.normals, frame.places, frame.projection.is_parallel(), facing);
        buffers::half_cross(tile, planes.q, depth_cross);
        const float per_depth = 1 / static_cast<float>(params_.depth_step);
        const auto of_q = static_cast<float>(frame.per_distance.of_q);
        const auto constant = static_cast<float>(frame.per_distance.constant);
        const float far = static_cast<float>(frame.projection.parallel_distance());
        const float per_px = frame.places.per_px() / (far > 0 ? far : 1);
        const auto step_ratio = [&](int x, int y, const buffers::CrossRange& near) {
            const float open = buffers::cross_range(facing.row(y) + x, facing.row(y + 1) + x).most;
            const float step = depth_cross.row(y)[x] / (near.most * of_q + constant);
            return guarded(step, open, per_px) * per_depth;
        };
        buffers::write_cross(tile, planes, params_.normal_step, step_ratio, out);
    }
    /// 1/w from depth; |n.v| from the normal, where a guard asks; a cross over each of four planes.
    [[nodiscard]] method::PixelBytes filter_bytes() const override {
        const auto guard =
            params_.guard == Guard::none ? method::PixelBytes{} : method::PixelBytes{12, 4};
        return buffers::view_normals_bytes(params_.renormalise) + guard +
               method::PixelBytes{4 + 4 * 4, 4 + 1};
    }

    Params params_;
};

}  // namespace

method::MethodInfo roberts_method() {
    return method::method_info<Roberts>("roberts");
}

}  // namespace ink::methods
