// CoRgi's comic renderer (about 2000): edges from a triangle description, thick where one face
// turns to the viewer and one away, thin where they bend,
//
//     contour   facing(f0) facing(f1) < 0
//     crease    no contour, and the angle between the faces' normals is at least crease_deg

#include <glm/trigonometric.hpp>

#include "buffers/hidden_lines.h"
#include "methods/edge_list/listed_models.h"

namespace ink::methods {
namespace {

class EdgeList : public buffers::HiddenLinesMethod {
  public:
    struct Params : buffers::HiddenLineParams {
        EdgeBuilder builder = EdgeBuilder::hash;
        EdgeScope scope = EdgeScope::object;
        FacingRule facing = FacingRule::position;
        EdgeOnRule edge_on = EdgeOnRule::include;
    };
    static core::ParamTable<Params> table() {
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
            .choice(&Params::facing,
                    "facing",
                    {"position", "direction"},
                    "Facing by the eye's position, exactly, or by the view direction alone, as in "
                    "CoRgi.")
            .choice(&Params::edge_on,
                    "edge_on",
                    {"leave_out", "include"},
                    "Whether an edge of a face that is exactly edge-on is a contour.")
            .choice(&Params::boundary_edges,
                    "boundary_edges",
                    {"thick", "thin", "none"},
                    "How an edge of one face is drawn; the source had none.");
        return buffers::add_hidden_line_params(table);
    }
    explicit EdgeList(const Params& params)
        : HiddenLinesMethod(params),
          params_(params),
          models_(params.scope, params.builder, glm::radians(params.crease_deg)) {}

    void prepare(const scene::PreparedScene& scene) override {
        models_.prepare(scene);
        SurfaceMethod::prepare(scene);
    }
    void pose(const scene::PreparedScene& scene) override {
        models_.pose(scene);
        SurfaceMethod::pose(scene);
    }

  private:
    std::vector<buffers::KnownEdge> lines(const method::Frame& frame) override {
        return models_.lines(frame.view.camera, params_.facing, params_.edge_on);
    }

    Params params_;
    ListedModels models_;
};

}  // namespace

method::MethodInfo edge_list_method() {
    return method::method_info<EdgeList>("edge_list");
}

}  // namespace ink::methods
