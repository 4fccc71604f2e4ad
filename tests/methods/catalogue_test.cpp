#include <gtest/gtest.h>

#include "catalogue/catalogue.h"
#include "methods/registry.h"
#include "tests/catalogue_names.h"
#include "tests/methods/names.h"
#include "tests/methods/small_scenes.h"

namespace ink::methods {
namespace {

class CatalogueScene : public testing::TestWithParam<std::string> {};

TEST_P(CatalogueScene, IsDrawnAlikeOnEveryThreadCountByEveryMethod) {
    const scene::Scene scene = catalogue::make_catalogue_scene(GetParam());
    ASSERT_FALSE(scene.cameras.empty());
    for (const scene::Camera& camera : scene.cameras) {
        const scene::View view{camera, 160, 90};
        for (const method::MethodInfo& info : registry()) {
            const auto one = drawn(info.name, {}, scene, {view, 1});
            EXPECT_EQ(one, drawn(info.name, {}, scene, {view, 2})) << info.name;
        }
    }
}

INSTANTIATE_TEST_SUITE_P(Every,
                         CatalogueScene,
                         testing::ValuesIn(light_scene_names()),
                         [](const auto& scene) { return scene.param; });

}  // namespace
}  // namespace ink::methods
