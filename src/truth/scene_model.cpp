#include "truth/scene_model.h"

#include "truth/model.h"

namespace ink::truth {

SceneModel::SceneModel(const scene::Scene& scene, const TruthOptions& options)
    : scene_(scene), options_(options) {}

SceneModel::~SceneModel() = default;

const Model& SceneModel::model() {
    if (!model_) model_ = std::make_unique<Model>(build_model(scene_, options_));
    return *model_;
}

}  // namespace ink::truth
