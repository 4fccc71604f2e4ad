#pragma once

#include <optional>

#include "buffers/hidden_lines.h"
#include "methods/edge_hash/soup_models.h"

namespace ink::methods {

/// TechnicalQuake's outlines: adjacency rebuilt from loose polygons into a hash of model, frame and
/// edge, kept from frame to frame.
class EdgeHash : public buffers::HiddenLinesMethod {
  public:
    /// Where the eye stands that contours are found for.
    enum class Eye {
        position,  ///< where it is
        stale,     ///< where it was in the last view unlike this one, as the source had it
    };
    struct Params : buffers::HiddenLineParams {
        ModelScope scope = ModelScope::object;
        double epsilon = 1e-5;
        int cached_frames = 1024;
        Eye eye = Eye::position;
    };
    [[nodiscard]] static core::ParamTable<Params> table();

    explicit EdgeHash(const Params& params);

    void prepare(const scene::PreparedScene& scene) override;
    /// Finds the edges of frames that are new, and finds those again that are not.
    void pose(const scene::PreparedScene& scene) override;
    /// What pose() built and what it found since prepare().
    [[nodiscard]] const EdgeCacheCounts& cache_counts() const { return models_.cache_counts(); }

  private:
    std::vector<buffers::KnownEdge> lines(const method::Frame& frame) override {
        return models_.lines(eye_of(frame.view.camera));
    }
    [[nodiscard]] scene::Viewpoint eye_of(const scene::Camera& camera);

    Params params_;
    SoupModels models_;
    std::optional<scene::Viewpoint> eye_;     ///< of the last draw
    std::optional<scene::Viewpoint> before_;  ///< of the last one that stood elsewhere
};

}  // namespace ink::methods
