// Rossignac and van Emmerik, "Hidden contours on a frame-buffer", Eurographics Workshop on Computer
// Graphics Hardware, 1992; Raskar and Cohen, "Image precision silhouette edges", I3D 1999.

#include "methods/inverted_hull/inverted_hull.h"

#include <algorithm>
#include <glm/trigonometric.hpp>

#include "core/parallel.h"

namespace ink::methods {
namespace {

constexpr std::uint8_t kInk = 255;

/// Inks the pixels in which the hull lies before the fronts.
class HullSink : public raster::TileSink {
  public:
    HullSink(const raster::DepthImage& fronts, edge::EdgeImage& out) : fronts_(fronts), out_(out) {}

    void finish(const raster::Tile& tile) override {
        for (int y = 0; y < tile.height_px; ++y) {
            std::uint8_t* to = out_.row(tile.y0_px + y) + tile.x0_px;
            if (tile.is_empty) {
                std::fill_n(to, tile.width_px, std::uint8_t{0});
                continue;
            }
            const std::uint32_t* hull = tile.depth_row<std::uint32_t>(y);
            const std::uint32_t* front = fronts_.bits().row(tile.y0_px + y) + tile.x0_px;
            for (int x = 0; x < tile.width_px; ++x)
                to[x] = hull[x] > front[x] ? kInk : std::uint8_t{0};
        }
    }

  private:
    const raster::DepthImage& fronts_;
    edge::EdgeImage& out_;
};

/// From the fastest to the most exact, the method as it comes among them.
std::vector<core::ParamValues> sweep() {
    return {
        // Grown once, whatever the camera does.
        {{"space", "world"}},
        {{"space", "world"}, {"width_milliradii", "8"}},
        {{"space", "world"}, {"width_milliradii", "16"}},
        // Split at creases, as the normals of shading are.
        {{"crease_deg", "40"}},
        {{"crease_deg", "40"}, {"width_px", "3"}},
        {{"width_px", "1"}},
        {{"width_px", "1.5"}},
        {},
        {{"width_px", "3"}},
        {{"width_px", "4"}},
        {{"depth_format", "z24"}},
        {{"depth_format", "z16"}},
    };
}

}  // namespace

core::ParamTable<InvertedHull::Params> InvertedHull::table() {
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
                "The same as a share of the scene's radius, for space = world.")
        .number(
            &Params::crease_deg,
            "crease_deg",
            {0, 180},
            "deg",
            "Least dihedral deviation of an edge at which the hull splits; 180 keeps it together.")
        .choice(&Params::depth_format,
                "depth_format",
                {"q32", "z24", "z16"},
                "Format of the depth buffer: float 1/w, or whole steps of window depth.")
        .number(
            &Params::threshold, "threshold", {1, 255}, "", "Least edge response of a line pixel.");
    return table;
}

InvertedHull::InvertedHull(const Params& params) : params_(params) {
    format_.depth = params.depth_format;
}

void InvertedHull::prepare(const scene::Scene& scene) {
    surface_ = scene::flatten(scene, scene::NormalSource::patch, glm::radians(params_.crease_deg));
    hull_ = surface_;
    mesh_ = raster::LaneMesh(surface_);
    hull_mesh_ = raster::LaneMesh(hull_);
    bounds_ = scene::bounding_sphere(scene);
    posed_hash_ = scene::scene_hash(scene);
}

void InvertedHull::pose(const scene::Scene& scene) {
    // Which corners share a normal may change with the dihedral deviation between faces.
    if (scene::scene_hash(scene) != posed_hash_) prepare(scene);
}

/// Moves the hull's vertices for this view.
void InvertedHull::grow(const method::Frame& frame) {
    constexpr std::size_t kRun = 8192;
    const std::size_t count = surface_.p_world.size();
    const scene::Projection projection(frame.view);
    const scene::Camera& camera = frame.view.camera;
    const bool is_screen = params_.space == Space::screen;
    const double length_world = 1e-3 * params_.width_milliradii * bounds_.radius;
    core::parallel_for((count + kRun - 1) / kRun, frame.threads, [&](std::size_t run) {
        const std::size_t last = std::min(count, (run + 1) * kRun);
        for (std::size_t i = run * kRun; i < last; ++i) {
            const glm::dvec3& p = surface_.p_world[i];
            double length = length_world;
            if (is_screen) {
                const double w = std::max(-projection.to_view(p).z, camera.near);
                length = params_.width_px * w / projection.focal_px();
            }
            hull_.p_world[i] = p + length * glm::dvec3(surface_.n_world[i]);
        }
    });
    hull_mesh_.update(hull_);
}

raster::MeshInput InvertedHull::mesh_input(const method::Frame& frame) const {
    raster::MeshInput input;
    input.view = frame.view;
    input.threads = frame.threads;
    input.skips = frame.skips;
    return input;
}

void InvertedHull::draw(const method::Frame& frame, edge::EdgeImage& out) {
    skip_counts_ = {};
    if (out.is_empty()) return;
    if (surface_.triangles.empty()) return out.fill(0);
    grow(frame);
    const scene::Camera& camera = frame.view.camera;
    depth_.start(
        params_.depth_format, camera.near, camera.far, frame.view.width_px, frame.view.height_px);

    raster::MeshInput fronts = mesh_input(frame);
    fronts.mesh = &mesh_;
    fronts.bounds = bounds_;
    fronts.cull = raster::Cull::back;
    raster::DepthSink front_sink(depth_);
    skip_counts_ = fronts_.draw(format_, fronts, front_sink).skips;

    raster::MeshInput backs = mesh_input(frame);
    backs.mesh = &hull_mesh_;
    backs.cull = raster::Cull::front;
    HullSink hull_sink(depth_, out);
    const raster::SkipCounts more = backs_.draw(format_, backs, hull_sink).skips;
    for (std::size_t i = 0; i < more.size(); ++i) {
        skip_counts_[i].skipped += more[i].skipped;
        skip_counts_[i].of += more[i].of;
    }
}

int InvertedHull::bytes_per_px() const {
    return 2 * format_.bytes_per_px();  // the fronts' depth and the hull's
}

method::Cost InvertedHull::cost() const {
    method::Cost cost;
    cost.passes = 2;
    cost.values_per_vertex = params_.space == Space::screen ? 3 : 0;  // the grown position
    cost.shares_vertices = params_.crease_deg > 0;
    cost.buffer_bytes_per_px = bytes_per_px();
    cost.fill = method::fill_work(format_);
    // The fronts' depth is written to the frame and read again beside the hull's: one comparison.
    const double depth_bytes = format_.bytes_per_px();
    cost.filter = {3 * depth_bytes, depth_bytes + 1, 1};
    return cost;
}

method::MethodInfo inverted_hull() {
    method::MethodInfo info = method::method_info<InvertedHull>(
        "inverted_hull",
        "Rossignac and van Emmerik 1992, Raskar and Cohen 1999; as engines do it today",
        "back faces moved out along their normals, black; front faces over them");
    info.family = method::Family::edges_and_hulls;
    info.marker = method::Marker::down;
    info.sweep = sweep();
    return info;
}

}  // namespace ink::methods
