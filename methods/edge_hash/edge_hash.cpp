// TechnicalQuake (about 2004): technical illustration in Quake. Its edges are found in polygon soup
// through a hash of model, frame and edge.

#include "methods/edge_hash/edge_hash.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <glm/trigonometric.hpp>
#include <utility>

namespace ink::methods {
namespace {

constexpr glm::u8vec3 kPaper{240, 240, 240};
constexpr glm::u8vec3 kSurface{150, 150, 150};

struct KindColor {
    buffers::EdgeKind kind;
    glm::u8vec3 color;
};

/// In the order in which they are drawn: what is wrong with a model lies on top.
constexpr std::array<KindColor, 3> kKindColors = {{{buffers::EdgeKind::crease, {255, 255, 255}},
                                                   {buffers::EdgeKind::contour, {0, 0, 0}},
                                                   {buffers::EdgeKind::boundary, {255, 0, 0}}}};

std::size_t count_of(const std::vector<buffers::KnownEdge>& edges, buffers::EdgeKind kind) {
    return static_cast<std::size_t>(
        std::count_if(edges.begin(), edges.end(), [&](const buffers::KnownEdge& edge) {
            return edge.kind == kind;
        }));
}

/// From the fastest to the most exact, the method as it comes among them.
std::vector<core::ParamValues> sweep() {
    return {
        // Contours alone.
        {{"crease_deg", "180"}, {"boundary_edges", "none"}, {"width_contour_px", "1"}},
        {{"depth_format", "q32"}, {"width_contour_px", "1"}},
        {},
        // No tolerance: cracks are lines.
        {{"epsilon", "0"}},
        {{"epsilon", "0.001"}},
        {{"boundary_edges", "none"}},
        {{"scope", "scene"}},
        // What hides lines: more or less of it.
        {{"offset_factor", "0"}},
        {{"offset_factor", "1"}},
        {{"depth_format", "z16"}},
        {{"width_crease_px", "2"}},
    };
}

}  // namespace

core::ParamTable<EdgeHash::Params> EdgeHash::table() {
    core::ParamTable<Params> table;
    table
        .choice(&Params::scope,
                "scope",
                {"object", "scene"},
                "A model is one mesh, or the whole scene.")
        .number(&Params::epsilon,
                "epsilon",
                {0, 0.01},
                "diagonals",
                "Vertices this near each other are welded, as a share of the diagonal of the "
                "model's box.")
        .number(&Params::cached_frames,
                "cached_frames",
                {1, 65536},
                "frames",
                "How many frames of each model keep their edges.")
        .choice(&Params::eye,
                "eye",
                {"position", "stale"},
                "Contours for the present eye, or for the last view that was different.")
        .choice(&Params::boundary_edges,
                "boundary_edges",
                {"contour", "crease", "none"},
                "Whether an edge of one face is drawn as a contour, as a crease, or not at all.");
    return buffers::add_hidden_line_params(table).number(
        &Params::threshold, "threshold", {1, 255}, "", "Least edge response of a line pixel.");
}

EdgeHash::EdgeHash(const Params& params)
    : params_(params),
      models_({.scope = params.scope,
               .epsilon = params.epsilon,
               .most_frames = static_cast<std::size_t>(params.cached_frames),
               .crease_rad = glm::radians(params.crease_deg)}),
      hidden_(params) {}

void EdgeHash::prepare(const scene::Scene& scene) {
    models_.prepare(scene);
    hidden_.prepare(scene);
    eye_world_.reset();
    before_world_.reset();
}

void EdgeHash::pose(const scene::Scene& scene) {
    models_.pose(scene);
    hidden_.pose(scene);
}

/// Drawing one view again does not make its eye an old one, so that it gives the same image.
glm::dvec3 EdgeHash::eye_of(const scene::Camera& camera) {
    if (eye_world_ && *eye_world_ != camera.eye_world) before_world_ = eye_world_;
    eye_world_ = camera.eye_world;
    return params_.eye == Eye::stale && before_world_ ? *before_world_ : camera.eye_world;
}

double EdgeHash::boundary_width_px() const {
    switch (params_.boundary_edges) {
        case BoundaryEdges::contour:
            return params_.width_contour_px;
        case BoundaryEdges::crease:
            return params_.width_crease_px;
        case BoundaryEdges::none:
            break;
    }
    return 0;
}

void EdgeHash::draw(const method::Frame& frame, edge::EdgeImage& out) {
    out.fill(0);
    if (hidden_.is_empty()) return;
    hidden_.fill(frame);
    hidden_.draw(frame,
                 models_.lines(eye_of(frame.view.camera)),
                 {.contour_px = params_.width_contour_px,
                  .crease_px = params_.width_crease_px,
                  .boundary_px = boundary_width_px()},
                 out);
}

DebugImage EdgeHash::debug_image(const method::Frame& frame) {
    const int width_px = frame.view.width_px;
    const int height_px = frame.view.height_px;
    DebugImage image{core::Image<glm::u8vec3>(width_px, height_px, kPaper), {}};
    if (hidden_.is_empty()) return image;
    const auto edges = models_.lines(eye_of(frame.view.camera));
    image.counts = {.contours = count_of(edges, buffers::EdgeKind::contour),
                    .creases = count_of(edges, buffers::EdgeKind::crease),
                    .boundary = count_of(edges, buffers::EdgeKind::boundary),
                    .models = models_.totals()};
    hidden_.fill(frame);
    for (std::size_t i = 0; i < image.rgb.size(); ++i) {
        if (hidden_.depth().bits().data()[i] > 0) image.rgb.data()[i] = kSurface;
    }
    for (const auto& [kind, color] : kKindColors) {
        buffers::KindWidths widths;
        if (kind == buffers::EdgeKind::crease) widths.crease_px = params_.width_crease_px;
        if (kind == buffers::EdgeKind::contour) widths.contour_px = params_.width_contour_px;
        if (kind == buffers::EdgeKind::boundary) widths.boundary_px = params_.width_contour_px;
        edge::EdgeImage lines(width_px, height_px);
        hidden_.draw(frame, edges, widths, lines);
        for (std::size_t i = 0; i < lines.size(); ++i) {
            if (lines.data()[i] > 0) image.rgb.data()[i] = color;
        }
    }
    return image;
}

std::vector<method::Layer> EdgeHash::layers(const method::Frame& frame) {
    DebugImage image = debug_image(frame);
    const EdgeCounts& counts = image.counts;
    return {{"edges",
             std::move(image.rgb),
             fmt::format("{} edges: {} contours (black), {} creases (white), {} boundary (red); {} "
                         "of three faces or more; {} triangles without area, {} doubled",
                         counts.models.edges,
                         counts.contours,
                         counts.creases,
                         counts.boundary,
                         counts.models.non_manifold,
                         counts.models.degenerate,
                         counts.models.duplicate)}};
}

method::MethodInfo edge_hash() {
    method::MethodInfo info = method::method_info<EdgeHash>(
        "edge_hash",
        "TechnicalQuake, a project of technical illustration in Quake, about 2004",
        "edges found in polygon soup through a hash of model, frame and edge; cached");
    info.family = method::Family::edges_and_hulls;
    info.marker = method::Marker::square;
    info.sweep = sweep();
    return info;
}

}  // namespace ink::methods
