#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "scene/crease.h"
#include "scene/scene.h"
#include "scene/topology.h"
#include "truth/crossings/continuation.h"
#include "truth/crossings/crossings.h"
#include "truth/line_class.h"
#include "truth/truth.h"

namespace ink::truth {

struct TruthOptions;

/// What truth knows of a scene before there is an eye: build it once, trace many views.
struct Model {
    scene::Topology topology;
    double crease_rad = 0;
    scene::CreaseSource creases = scene::CreaseSource::angle;
    std::vector<double> tolerances;  ///< weld tolerance of each object, world units
    bool is_one_object = false;      ///< all faces belong to one
    /// Per entry of `topology.edge_faces`: 1 where the face runs from the edge's a to its b, else
    /// -1.
    std::vector<std::int8_t> runs;
    /// Per edge of two faces its class where the eye sees them on either side (none, crease or
    /// seam); none for other edges.
    std::vector<LineClass> flat_class;
    /// Per face its smooth patch, numbered from 0 in face order: what can be reached over edges of
    /// two faces that are neither crease nor seam.
    std::vector<std::uint32_t> patch;
    std::vector<Continuation> continuations;  ///< sorted by edge
    Crossings crossings;  ///< where triangles meet other than at what they share
    /// Per edge 1 if `crossings` has contacts of it.
    std::vector<std::uint8_t> is_touched;
    std::size_t defect_edges = 0;  ///< boundary edges with a stretch where the same object goes on

    /// The stretches of one boundary edge across which the surface goes on.
    [[nodiscard]] std::span<const Continuation> continuations_of(std::uint32_t edge) const;

    /// Whether a flat join of the two faces is a seam.
    [[nodiscard]] bool is_seam(std::uint32_t face0, std::uint32_t face1) const {
        return topology.faces[face0].object != topology.faces[face1].object;
    }

    /// The class of an edge whose seen faces, one on either side, are these: none, crease or seam.
    [[nodiscard]] LineClass class_across(const scene::Edge& edge,
                                         std::uint32_t face0,
                                         std::uint32_t face1) const;
};

/// Welds the scene and finds what no eye changes. An empty scene gives an empty model.
[[nodiscard]] Model build_model(const scene::Scene& scene, const TruthOptions& options);

/// A scene with its model (model.h), which is built when a view first needs it and kept for the
/// others: welding is most of the work on a large scene, and a truth read from the cache needs none
/// of it.
///
/// Borrows the scene. Not for two threads at once.
class SceneModel {
  public:
    /// Throws core::Error if creases are to be those of a file that marks none.
    SceneModel(const scene::Scene& scene, const TruthOptions& options)
        : scene_(scene), options_(options) {
        scene::check_creases(scene, options.creases);
    }
    SceneModel(const SceneModel&) = delete;
    SceneModel& operator=(const SceneModel&) = delete;

    [[nodiscard]] const scene::Scene& scene() const { return scene_; }
    [[nodiscard]] const TruthOptions& options() const { return options_; }
    /// Builds it on the first call.
    [[nodiscard]] const Model& model() {
        if (!model_) model_ = build_model(scene_, options_);
        return *model_;
    }

  private:
    const scene::Scene& scene_;
    TruthOptions options_;
    std::optional<Model> model_;
};

}  // namespace ink::truth
