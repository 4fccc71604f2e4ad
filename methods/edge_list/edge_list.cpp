// CoRgi's comic renderer (about 2000): edges from a triangle description, thick where one face
// turns to the viewer and one away, thin where they bend.

#include "methods/edge_list/edge_list.h"

#include <glm/trigonometric.hpp>

namespace ink::methods {
namespace {

double boundary_width_px(const EdgeList::Params& params) {
    switch (params.boundary_edges) {
        case EdgeList::BoundaryEdges::thick:
            return params.width_contour_px;
        case EdgeList::BoundaryEdges::thin:
            return params.width_crease_px;
        case EdgeList::BoundaryEdges::none:
            break;
    }
    return 0;
}

/// From the fastest to the most exact, the method as it comes among them.
std::vector<core::ParamValues> sweep() {
    return {
        // Contours alone.
        {{"crease_deg", "180"}, {"boundary_edges", "none"}, {"width_contour_px", "1"}},
        {{"depth_format", "q32"}, {"width_contour_px", "1"}},
        {},
        // As the source had it: the view direction decides, and only edges of two faces count.
        {{"facing", "direction"}, {"boundary_edges", "none"}},
        {{"facing", "direction"}},
        {{"edge_on", "leave_out"}},
        {{"scope", "scene"}},
        // What hides lines: more or less of it.
        {{"offset_factor", "0"}},
        {{"offset_factor", "1"}},
        {{"depth_format", "z16"}},
        {{"width_crease_px", "2"}},
    };
}

}  // namespace

core::ParamTable<EdgeList::Params> EdgeList::table() {
    core::ParamTable<Params> table;
    table
        .choice(&Params::builder,
                "builder",
                {"all_pairs", "temp_list", "hash"},
                "How edges are found: the edges are the same, the time of prepare is not.")
        .choice(&Params::scope,
                "scope",
                {"object", "scene"},
                "Edges among each object's own triangles, or over all that touch.")
        .choice(
            &Params::facing,
            "facing",
            {"position", "direction"},
            "Facing by the eye's position, exactly, or by the view direction alone, as in CoRgi.")
        .choice(&Params::edge_on,
                "edge_on",
                {"leave_out", "include"},
                "Whether an edge of a face that is exactly edge-on is a contour.")
        .choice(&Params::boundary_edges,
                "boundary_edges",
                {"thick", "thin", "none"},
                "How an edge of one face is drawn; the source had none.");
    return buffers::add_hidden_line_params(table).number(
        &Params::threshold, "threshold", {1, 255}, "", "Least edge response of a line pixel.");
}

EdgeList::EdgeList(const Params& params)
    : params_(params),
      models_(params.scope, params.builder, glm::radians(params.crease_deg)),
      hidden_(params) {}

void EdgeList::prepare(const scene::Scene& scene) {
    models_.prepare(scene);
    hidden_.prepare(scene);
}

void EdgeList::pose(const scene::Scene& scene) {
    models_.pose(scene);
    hidden_.pose(scene);
}

void EdgeList::draw(const method::Frame& frame, edge::EdgeImage& out) {
    out.fill(0);
    if (hidden_.is_empty()) return;
    hidden_.fill(frame);
    hidden_.draw(frame,
                 models_.lines(frame.view.camera, params_.facing, params_.edge_on),
                 {.contour_px = params_.width_contour_px,
                  .crease_px = params_.width_crease_px,
                  .boundary_px = boundary_width_px(params_)},
                 out);
}

method::MethodInfo edge_list() {
    method::MethodInfo info = method::method_info<EdgeList>(
        "edge_list",
        "CoRgi's comic renderer, a master's project, about 2000",
        "a list of edges; contours thick, creases thin, hidden by the depth buffer");
    info.family = method::Family::edges_and_hulls;
    info.marker = method::Marker::circle;
    info.sweep = sweep();
    return info;
}

}  // namespace ink::methods
