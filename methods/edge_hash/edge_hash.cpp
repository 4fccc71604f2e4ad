// TechnicalQuake (about 2004): technical illustration in Quake. Its edges are found in polygon soup
// through a hash of model, frame and edge.

#include "methods/edge_hash/edge_hash.h"

#include <glm/trigonometric.hpp>

namespace ink::methods {
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

method::MethodInfo edge_hash_method() {
    return method::method_info<EdgeHash>("edge_hash");
}

}  // namespace ink::methods
