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
    return static_cast<std::size_t>(std::ranges::count(edges, kind, &buffers::KnownEdge::kind));
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
    return buffers::add_hidden_line_params(table);
}

EdgeHash::EdgeHash(const Params& params)
    : HiddenLinesMethod(params),
      params_(params),
      models_({.scope = params.scope,
               .epsilon = params.epsilon,
               .most_frames = static_cast<std::size_t>(params.cached_frames),
               .crease_rad = glm::radians(params.crease_deg)}) {}

void EdgeHash::prepare(const scene::PreparedScene& scene) {
    models_.prepare(scene);
    SurfaceMethod::prepare(scene);
    eye_.reset();
    before_.reset();
}

void EdgeHash::pose(const scene::PreparedScene& scene) {
    models_.pose(scene);
    SurfaceMethod::pose(scene);
}

/// Drawing one view again does not make its eye an old one, so that it gives the same image.
scene::Viewpoint EdgeHash::eye_of(const scene::Camera& camera) {
    if (eye_ && *eye_ != camera.viewpoint()) before_ = eye_;
    eye_ = camera.viewpoint();
    return params_.eye == Eye::stale && before_ ? *before_ : camera.viewpoint();
}

DebugImage EdgeHash::debug_image(const method::Frame& frame) {
    const int width_px = frame.view.width_px;
    const int height_px = frame.view.height_px;
    DebugImage image{core::Image<glm::u8vec3>(width_px, height_px, kPaper), {}};
    if (pass().is_empty()) return image;
    const auto edges = models_.lines(eye_of(frame.view.camera));
    image.counts = {.contours = count_of(edges, buffers::EdgeKind::contour),
                    .creases = count_of(edges, buffers::EdgeKind::crease),
                    .boundary = count_of(edges, buffers::EdgeKind::boundary),
                    .models = models_.totals()};
    (void)pass().fill(frame);
    for (std::size_t i = 0; i < image.rgb.size(); ++i) {
        if (pass().depth().bits().data()[i] > 0) image.rgb.data()[i] = kSurface;
    }
    for (const auto& [kind, color] : kKindColors) {
        buffers::KindWidths widths;
        if (kind == buffers::EdgeKind::crease) widths.crease_px = params_.width_crease_px;
        if (kind == buffers::EdgeKind::contour) widths.contour_px = params_.width_contour_px;
        if (kind == buffers::EdgeKind::boundary) widths.boundary_px = params_.width_contour_px;
        edge::EdgeImage lines(width_px, height_px);
        pass().draw(frame, edges, widths, lines);
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

method::MethodInfo edge_hash_method() {
    return method::method_info<EdgeHash>("edge_hash");
}

}  // namespace ink::methods
