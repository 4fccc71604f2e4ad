#include "buffers/hidden_lines.h"

#include <algorithm>

#include "buffers/line_cost.h"

namespace ink::buffers {

double KindWidths::of(EdgeKind kind) const {
    switch (kind) {
        case EdgeKind::none:
            return 0;
        case EdgeKind::contour:
            return contour_px;
        case EdgeKind::crease:
            return crease_px;
        case EdgeKind::boundary:
            return boundary_px;
    }
    return 0;
}

HiddenLines::HiddenLines(const HiddenLineParams& params) : params_(params) {
    format_.depth = params.depth_format;
}

void HiddenLines::prepare(const scene::Scene& scene) {
    surface_ = std::make_unique<scene::Surface>(scene::flatten(scene));
    mesh_ = raster::LaneMesh(*surface_);
    bounds_ = scene::bounding_sphere(scene);
    posed_hash_ = scene::scene_hash(scene);
    skip_counts_ = {};
}

void HiddenLines::pose(const scene::Scene& scene) {
    const std::uint64_t hash = scene::scene_hash(scene);
    if (hash == posed_hash_) return;
    auto moved = std::make_unique<scene::Surface>(scene::flatten(scene));
    // An object that is mirrored now and was not turns its triangles round.
    if (moved->triangles != surface_->triangles) return prepare(scene);
    mesh_.update(*moved);
    surface_ = std::move(moved);
    bounds_ = scene::bounding_sphere(scene);
    posed_hash_ = hash;
}

void HiddenLines::fill(const method::Frame& frame) {
    const scene::Camera& camera = frame.view.camera;
    depth_.start(format_.depth, camera.near, camera.far, frame.view.width_px, frame.view.height_px);
    raster::MeshInput input;
    input.mesh = &mesh_;
    input.view = frame.view;
    input.bounds = bounds_;
    input.threads = frame.threads;
    input.skips = frame.skips;
    input.offset = {params_.offset_factor, params_.offset_units};
    raster::DepthSink sink(depth_);
    skip_counts_ = mesh_pass_.draw(format_, input, sink).skips;
}

void HiddenLines::draw(const method::Frame& frame,
                       const std::vector<KnownEdge>& edges,
                       const KindWidths& widths,
                       edge::EdgeImage& out) {
    std::vector<double> each{widths.contour_px, widths.crease_px, widths.boundary_px};
    std::sort(each.begin(), each.end());
    each.erase(std::unique(each.begin(), each.end()), each.end());
    for (const double width_px : each) {
        if (width_px <= 0) continue;
        p_world_.clear();
        lines_.clear();
        for (const KnownEdge& edge : edges) {
            if (widths.of(edge.kind) != width_px) continue;
            const auto from = static_cast<std::uint32_t>(p_world_.size());
            p_world_.push_back(edge.a_world);
            p_world_.push_back(edge.b_world);
            lines_.push_back({from, from + 1});
        }
        raster::LineInput input;
        input.p_world = p_world_;
        input.lines = lines_;
        input.view = frame.view;
        input.width_px = width_px;
        input.threads = frame.threads;
        line_pass_.draw(input, depth_, out);
    }
}

method::Cost HiddenLines::cost() const {
    return filled_lines_cost(format_);
}

}  // namespace ink::buffers
