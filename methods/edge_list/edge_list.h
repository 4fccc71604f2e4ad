#pragma once

#include "buffers/hidden_lines.h"
#include "method/method.h"
#include "methods/edge_list/listed_models.h"

namespace ink::methods {

/// CoRgi's outlines: a list of edges, each drawn thick or thin by what its two faces do.
class EdgeList : public method::Method {
  public:
    /// How an edge of one face is drawn; the source's lists had none.
    enum class BoundaryEdges { thick, thin, none };
    struct Params : buffers::HiddenLineParams {
        EdgeBuilder builder = EdgeBuilder::hash;
        EdgeScope scope = EdgeScope::object;
        FacingRule facing = FacingRule::position;
        EdgeOnRule edge_on = EdgeOnRule::include;
        BoundaryEdges boundary_edges = BoundaryEdges::thick;
        int threshold = 128;  ///< it draws 0 and 255 only
    };
    [[nodiscard]] static core::ParamTable<Params> table();

    explicit EdgeList(const Params& params);

    void prepare(const scene::Scene& scene) override;
    void pose(const scene::Scene& scene) override;
    void draw(const method::Frame& frame, edge::EdgeImage& out) override;
    [[nodiscard]] int bytes_per_px() const override { return hidden_.bytes_per_px(); }
    [[nodiscard]] method::Cost cost() const override { return hidden_.cost(); }
    [[nodiscard]] raster::SkipCounts skip_counts() const override { return hidden_.skip_counts(); }

  private:
    Params params_;
    ListedModels models_;
    buffers::HiddenLines hidden_;
};

[[nodiscard]] method::MethodInfo edge_list();

}  // namespace ink::methods
