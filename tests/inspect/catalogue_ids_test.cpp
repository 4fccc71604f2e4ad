#include <gtest/gtest.h>

#include "catalogue/catalogue.h"
#include "core/named.h"
#include "tests/inspect/id_agreement.h"

namespace ink::raster {
namespace {

class IdsOfAScene : public testing::TestWithParam<std::string> {};

TEST_P(IdsOfAScene, AreThoseOfEmbreeInEveryView) {
    const scene::Scene scene = catalogue::make_catalogue_scene(GetParam());
    std::vector<scene::Camera> cameras = scene.cameras;
    for (const scene::Camera& camera : scene.cameras) {
        cameras.push_back(scene::projected(
            scene::ProjectionKind::parallel, camera, scene::bounding_sphere(scene)));
        cameras.back().name += ".parallel";
    }
    expect_same_ids(scene, cameras);
}

INSTANTIATE_TEST_SUITE_P(Every,
                         IdsOfAScene,
                         testing::ValuesIn(core::names_of(catalogue::catalogue())),
                         [](const auto& scene) { return scene.param; });

}  // namespace
}  // namespace ink::raster
