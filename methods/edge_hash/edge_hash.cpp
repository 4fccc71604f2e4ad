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
                                                   {buffers::EdgeKind::lone, {255, 0, 0}}}};

std::size_t count_of(const std::vector<buffers::KnownEdge>& edges, buffers::EdgeKind kind) {
    return static_cast<std::size_t>(
        std::count_if(edges.begin(), edges.end(), [&](const buffers::KnownEdge& edge) {
            return edge.kind == kind;
        }));
}

/// From the fastest to the most exact, the method as it comes among them.
std::vector<core::ParamValues> sweep() {
    return {
        // Silhouettes alone.
        {{"crease_deg", "180"}, {"lone_edges", "none"}, {"width_contour_px", "1"}},
        {{"depth_format", "q32"}, {"width_contour_px", "1"}},
        {},
        // No tolerance: cracks are lines.
        {{"epsilon", "0"}},
        {{"epsilon", "0.001"}},
        {{"lone_edges", "none"}},
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
                "A model is a mesh, or the whole scene as it stands.")
        .number(&Params::epsilon,
                "epsilon",
                {0, 0.01},
                "diagonals",
                "Vertices this near each other are one, as a share of the model's box's diagonal.")
        .number(&Params::cached_frames,
                "cached_frames",
                {1, 65536},
                "frames",
                "How many frames of each model keep their edges.")
        .choice(&Params::eye,
                "eye",
                {"position", "stale"},
                "Silhouettes for where the eye is, or for the last view unlike this one.")
        .choice(
            &Params::lone_edges,
            "lone_edges",
            {"silhouette", "crease", "none"},
            "Whether an edge of one face is drawn as a silhouette, as a crease, or not at all.");
    return buffers::add_hidden_line_params(table).number(
        &Params::threshold, "threshold", {1, 255}, "", "Strength from which on a pixel is a line.");
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

/// Drawing one view again does not make its eye an old one, so that it gives the same picture.
glm::dvec3 EdgeHash::eye_of(const scene::Camera& camera) {
    if (eye_world_ && *eye_world_ != camera.eye_world) before_world_ = eye_world_;
    eye_world_ = camera.eye_world;
    return params_.eye == Eye::stale && before_world_ ? *before_world_ : camera.eye_world;
}

double EdgeHash::lone_width_px() const {
    switch (params_.lone_edges) {
        case LoneEdges::silhouette:
            return params_.width_contour_px;
        case LoneEdges::crease:
            return params_.width_crease_px;
        case LoneEdges::none:
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
                  .lone_px = lone_width_px()},
                 out);
}

DebugPicture EdgeHash::debug_picture(const method::Frame& frame) {
    const int width_px = frame.view.width_px;
    const int height_px = frame.view.height_px;
    DebugPicture picture{core::Image<glm::u8vec3>(width_px, height_px, kPaper), {}};
    if (hidden_.is_empty()) return picture;
    const auto edges = models_.lines(eye_of(frame.view.camera));
    picture.counts = {.silhouettes = count_of(edges, buffers::EdgeKind::contour),
                      .creases = count_of(edges, buffers::EdgeKind::crease),
                      .lone = count_of(edges, buffers::EdgeKind::lone),
                      .models = models_.totals()};
    hidden_.fill(frame);
    for (std::size_t i = 0; i < picture.rgb.size(); ++i) {
        if (hidden_.depth().bits().data()[i] > 0) picture.rgb.data()[i] = kSurface;
    }
    for (const auto& [kind, color] : kKindColors) {
        buffers::KindWidths widths;
        if (kind == buffers::EdgeKind::crease) widths.crease_px = params_.width_crease_px;
        if (kind == buffers::EdgeKind::contour) widths.contour_px = params_.width_contour_px;
        if (kind == buffers::EdgeKind::lone) widths.lone_px = params_.width_contour_px;
        edge::EdgeImage lines(width_px, height_px);
        hidden_.draw(frame, edges, widths, lines);
        for (std::size_t i = 0; i < lines.size(); ++i) {
            if (lines.data()[i] > 0) picture.rgb.data()[i] = color;
        }
    }
    return picture;
}

std::vector<method::Layer> EdgeHash::layers(const method::Frame& frame) {
    DebugPicture picture = debug_picture(frame);
    const EdgeCounts& counts = picture.counts;
    return {{"edges",
             std::move(picture.rgb),
             fmt::format("{} edges: {} silhouettes (black), {} creases (white), {} lone (red); {} "
                         "of three faces or more; {} triangles without area, {} doubled",
                         counts.models.edges,
                         counts.silhouettes,
                         counts.creases,
                         counts.lone,
                         counts.models.crowded,
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
