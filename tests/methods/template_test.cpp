// The method that `inkbench new-method` copies, compiled with these tests: it draws as it stands.

#include <gtest/gtest.h>

#include "core/whole_file.h"
#include "methods/registry.h"
#include "tests/methods/small_scenes.h"
#include "tests/methods/two_px.h"
#include "truth/truth.h"

namespace ink::methods {

method::MethodInfo my_method_method();

namespace {

TEST(Template, DrawsACubeInBothProjections) {
    const auto text = core::read_whole_file(INK_SOURCE_DIR "/methods/_template/my_method.toml");
    const method::MethodInfo info = described(my_method_method(), *text, "my_method.toml");
    const scene::Scene scene = scene_of({cube_mesh()});
    for (const scene::ProjectionKind projection :
         {scene::ProjectionKind::perspective, scene::ProjectionKind::parallel}) {
        const scene::View view = view_from(scene, {3, 2, 5}, {0, 0, 0}, {310, 230}, projection);
        const core::Image<std::uint8_t> truth = truth::trace_truth(scene, view, {}).labels;
        for (const core::ParamValues& settings : info.sweep) {
            const edge::EdgeImage one = drawn(info, settings, scene, {view, 1});
            EXPECT_GT(f_within_two_px(one, truth), 0.99);
            EXPECT_EQ(drawn(info, settings, scene, {view, 3}), one);
        }
    }
}

}  // namespace
}  // namespace ink::methods
