#pragma once

#include <optional>

#include "buffers/hidden_lines.h"
#include "core/image.h"
#include "method/method.h"
#include "methods/edge_hash/soup_models.h"

namespace ink::methods {

/// How many edges of each kind one frame has, hidden or not.
struct EdgeCounts {
    std::size_t contours = 0;
    std::size_t creases = 0;
    std::size_t boundary = 0;
    SoupTotals models;  ///< what they were chosen from
};

/// TechnicalQuake's debug view: contours black, creases white, boundary edges red, surfaces grey.
struct DebugImage {
    core::Image<glm::u8vec3> rgb;
    EdgeCounts counts;
};

/// TechnicalQuake's outlines: adjacency rebuilt from loose polygons into a hash of model, frame and
/// edge, kept from frame to frame.
class EdgeHash : public method::Method {
  public:
    /// Where the eye stands that contours are found for.
    enum class Eye {
        position,  ///< where it is
        stale,     ///< where it was in the last view unlike this one, as the source had it
    };
    /// How an edge of one face is drawn.
    enum class BoundaryEdges { contour, crease, none };
    struct Params : buffers::HiddenLineParams {
        ModelScope scope = ModelScope::object;
        double epsilon = 1e-5;
        int cached_frames = 1024;
        Eye eye = Eye::position;
        BoundaryEdges boundary_edges = BoundaryEdges::contour;
        int threshold = 128;  ///< it draws 0 and 255 only
    };
    [[nodiscard]] static core::ParamTable<Params> table();

    explicit EdgeHash(const Params& params);

    void prepare(const scene::Scene& scene) override;
    /// Finds the edges of frames that are new, and finds those again that are not.
    void pose(const scene::Scene& scene) override;
    void draw(const method::Frame& frame, edge::EdgeImage& out) override;
    /// `edges`: the debug_image, its counts in the note.
    [[nodiscard]] std::vector<method::Layer> layers(const method::Frame& frame) override;
    [[nodiscard]] int bytes_per_px() const override { return hidden_.bytes_per_px(); }
    [[nodiscard]] method::Cost cost() const override { return hidden_.cost(); }
    [[nodiscard]] raster::SkipCounts skip_counts() const override { return hidden_.skip_counts(); }

    /// The frame in colours, its lines as wide as draw() has them, boundary edges always drawn;
    /// with the counts of the edges behind it. Surfaces are grey, paper is lighter.
    [[nodiscard]] DebugImage debug_image(const method::Frame& frame);

    /// What pose() built and what it found since prepare().
    [[nodiscard]] const EdgeCacheCounts& cache_counts() const { return models_.cache_counts(); }

  private:
    [[nodiscard]] glm::dvec3 eye_of(const scene::Camera& camera);
    [[nodiscard]] double boundary_width_px() const;

    Params params_;
    SoupModels models_;
    buffers::HiddenLines hidden_;
    std::optional<glm::dvec3> eye_world_;     ///< of the last draw
    std::optional<glm::dvec3> before_world_;  ///< of the last one that stood elsewhere
};

[[nodiscard]] method::MethodInfo edge_hash();

}  // namespace ink::methods
