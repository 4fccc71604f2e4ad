#include <gtest/gtest.h>

#include "catalogue/catalogue.h"
#include "tests/raster/id_agreement.h"

namespace ink::raster {
namespace {

TEST(IdsAgainstEmbree, EveryCatalogueSceneInEveryView) {
    for (const catalogue::CatalogueEntry& entry : catalogue::catalogue()) {
        const scene::Scene scene = entry.make();
        expect_same_ids(scene, scene.cameras);
    }
}

}  // namespace
}  // namespace ink::raster
