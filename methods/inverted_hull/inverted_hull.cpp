// Rossignac and van Emmerik, "Hidden contours on a frame-buffer", Eurographics Workshop on Computer
// Graphics Hardware, 1992; Raskar and Cohen, "Image precision silhouette edges", I3D 1999: the
// surface grown along its normals, p + length n, its back faces black behind the front faces.

#include <algorithm>

#include "buffers/constant_pass.h"
#include "buffers/each_tile.h"
#include "buffers/filled_lines.h"
#include "core/parallel.h"

namespace ink::methods {
namespace {

constexpr std::uint8_t kInk = 255;

enum class Space {
    screen,  ///< as many px everywhere
    world,   ///< as long everywhere
};

/// The pass is that of the front faces.
class InvertedHull : public buffers::SurfaceMethod<buffers::DepthFill> {
  public:
    struct Params {
        Space space = Space::screen;
        double width_px = 2;
        double width_milliradii = 4;
        double crease_deg = 180;
        raster::DepthFormat depth_format = raster::DepthFormat::q32;
        int threshold = 128;  // it draws 0 and 255 only
    };
    static core::ParamTable<Params> table() {
        core::ParamTable<Params> table;
        table
            .choice(&Params::space,
                    "space",
                    {"screen", "world"},
                    "Grow by as many px at every vertex, or by the same length.")
            .number(&Params::width_px,
                    "width_px",
                    {0.25, 16},
                    "px",
                    "How far vertices move along their normals, seen at a right angle.")
            .number(&Params::width_milliradii,
                    "width_milliradii",
                    {0.25, 50},
                    "radius/1000",
                    "The same as a share of the scene's radius, for space = world.");
        buffers::add_crease_param(table,
                                  "Least dihedral deviation of an edge at which the hull splits; "
                                  "180 keeps it together.");
        return buffers::add_depth_buffer_params(table);
    }
    explicit InvertedHull(const Params& params)
        : SurfaceMethod(buffers::constant_inputs(params), buffers::Reads::normals),
          params_(params) {}

    void prepare(const scene::PreparedScene& scene) override {
        SurfaceMethod::prepare(scene);
        hull_ = pass().inputs().surface();
        hull_mesh_ = raster::LaneMesh(hull_, pass().inputs().mesh().clusters());
        bounds_ = scene.bounds();
        posed_hash_ = scene.hash();
    }
    void pose(const scene::PreparedScene& scene) override {
        // Which corners share a normal may change with the dihedral deviation between faces.
        if (scene.hash() != posed_hash_) prepare(scene);
    }
    /// The fronts' depth and the hull's.
    [[nodiscard]] int bytes_per_px() const override { return 2 * pass().format().bytes_per_px(); }
    [[nodiscard]] method::Cost cost() const override {
        method::Cost cost = SurfaceMethod::cost();
        cost.passes = 2;
        cost.values_per_vertex = params_.space == Space::screen ? 3 : 0;  // the grown position
        cost.shares_vertices = params_.crease_deg > 0;
        return cost;
    }

  private:
    /// The fronts' depth is read again beside the hull's.
    [[nodiscard]] method::PixelBytes filter_bytes() const override {
        return {2.0 * pass().format().bytes_per_px(), 0};
    }

    /// Moves the hull's vertices for this view.
    void grow(const method::Frame& frame) {
        constexpr std::size_t kRun = 8192;
        const scene::Surface& surface = pass().inputs().surface();
        const std::size_t count = surface.p_world.size();
        const scene::Projection projection(frame.view);
        const scene::Camera& camera = frame.view.camera;
        const bool is_screen = params_.space == Space::screen;
        const double length_world = 1e-3 * params_.width_milliradii * bounds_.radius;
        core::parallel_for_chunks(count, kRun, frame.threads, [&](std::size_t i) {
            const glm::dvec3& p = surface.p_world[i];
            double length = length_world;
            if (is_screen) {
                const double w = std::max(projection.to_clip(p).z, camera.near);
                length = params_.width_px / projection.px_per_world(w);
            }
            hull_.p_world[i] = p + length * glm::dvec3(surface.n_world[i]);
        });
        hull_mesh_.update(hull_);
    }

    raster::SkipCounts draw_lines(const method::Frame& frame, edge::EdgeImage& out) override {
        grow(frame);
        raster::MeshInput fronts = pass().see(frame);
        fronts.cull = raster::Cull::back;
        raster::SkipCounts skips = pass().fill(fronts);

        raster::MeshInput backs;
        backs.mesh = &hull_mesh_;
        backs.view = frame.view;
        backs.threads = frame.threads;
        backs.skips = frame.skips;
        backs.cull = raster::Cull::front;
        // Ink where the hull lies before the fronts.
        buffers::EachTile sink([&](const raster::Tile& tile) {
            for (int y = 0; y < tile.height_px; ++y) {
                std::uint8_t* to = out.row(tile.y0_px + y) + tile.x0_px;
                if (tile.is_empty) {
                    std::fill_n(to, tile.width_px, std::uint8_t{0});
                    continue;
                }
                const std::uint32_t* hull = tile.depth_row<std::uint32_t>(y);
                const std::uint32_t* front = pass().depth().bits().row(tile.y0_px + y) + tile.x0_px;
                for (int x = 0; x < tile.width_px; ++x)
                    to[x] = hull[x] > front[x] ? kInk : std::uint8_t{0};
            }
        });
        const raster::SkipCounts more = hull_pass_.draw(pass().format(), backs, sink).skips;
        for (std::size_t i = 0; i < more.size(); ++i) {
            skips[i].skipped += more[i].skipped;
            skips[i].of += more[i].of;
        }
        return skips;
    }

    Params params_;
    scene::Surface hull_;
    raster::LaneMesh hull_mesh_;  ///< borrows the hull
    scene::Sphere bounds_;
    std::uint64_t posed_hash_ = 0;
    raster::MeshPass hull_pass_;
};

}  // namespace

method::MethodInfo inverted_hull_method() {
    return method::method_info<InvertedHull>("inverted_hull");
}

}  // namespace ink::methods
