#include <gtest/gtest.h>

#include "catalogue/catalogue.h"
#include "tests/inspect/id_agreement.h"

namespace ink::raster {
namespace {

TEST(IdsAgainstEmbree, EveryCatalogueSceneInEveryView) {
    for (const catalogue::CatalogueEntry& entry : catalogue::catalogue()) {
        const scene::Scene scene = entry.make();
        std::vector<scene::Camera> cameras = scene.cameras;
        for (const scene::Camera& camera : scene.cameras) {
            cameras.push_back(scene::projected(
                scene::ProjectionKind::parallel, camera, scene::bounding_sphere(scene)));
            cameras.back().name += ".parallel";
        }
        expect_same_ids(scene, cameras);
    }
}

}  // namespace
}  // namespace ink::raster
