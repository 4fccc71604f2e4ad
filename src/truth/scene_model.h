#pragma once

#include <memory>

#include "scene/scene.h"
#include "truth/truth.h"

namespace ink::truth {

/// A scene with its model (model.h), which is built when a view first needs it and kept for the
/// others: welding is most of the work on a large scene, and a truth read from the cache needs none
/// of it.
///
/// Borrows the scene. Not for two threads at once.
class SceneModel {
  public:
    SceneModel(const scene::Scene& scene, const TruthOptions& options);
    ~SceneModel();
    SceneModel(const SceneModel&) = delete;
    SceneModel& operator=(const SceneModel&) = delete;

    [[nodiscard]] const scene::Scene& scene() const { return scene_; }
    [[nodiscard]] const TruthOptions& options() const { return options_; }
    /// Builds it on the first call.
    [[nodiscard]] const Model& model();

  private:
    const scene::Scene& scene_;
    TruthOptions options_;
    std::unique_ptr<Model> model_;
};

}  // namespace ink::truth
