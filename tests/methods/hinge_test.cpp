// While a model moves, its edges pass the crease angle: corners part and meet, patches, labels and
// clusters change. Over all methods, nothing that was kept from the frame before may show.

#include <gtest/gtest.h>

#include <glm/trigonometric.hpp>

#include "scene/animation.h"
#include "tests/methods/names.h"
#include "tests/methods/skip_law.h"

namespace ink::methods {
namespace {

constexpr double kCrease_deg = 40;  // of every method, unless it is told otherwise

/// Two upright squares that share an edge, the right one turned back by an angle: at 0 they lie in
/// one plane.
scene::Mesh hinge(double angle_deg) {
    const double angle_rad = glm::radians(angle_deg);
    const auto x = static_cast<float>(std::cos(angle_rad));
    const auto z = static_cast<float>(-std::sin(angle_rad));
    scene::Mesh mesh;
    mesh.positions = {{-1, 0, 0}, {0, 0, 0}, {x, 0, z}, {-1, 1, 0}, {0, 1, 0}, {x, 1, z}};
    mesh.triangles = {{0, 1, 4}, {0, 4, 3}, {1, 2, 5}, {1, 5, 4}};
    return mesh;
}

/// A hinge that has these angles, a second apart, and a cube that stands still far to its right.
scene::Scene moving_hinge(const std::vector<double>& angles_deg) {
    scene::Scene scene = scene_of({hinge(angles_deg.front()), cube_mesh()});
    scene.instances[1].world_from_object = glm::translate(glm::dmat4(1), {5, 0, 0});
    scene::Animation motion;
    motion.frames_per_s = 1;
    motion.duration_s = static_cast<double>(angles_deg.size() - 1);
    motion.node_of_instance = {scene::kNoNode, scene::kNoNode};
    motion.vertex_frames.resize(2);
    scene::VertexFrames& frames = motion.vertex_frames[0];
    frames.frame_count = angles_deg.size();
    for (const double angle_deg : angles_deg) {
        const auto positions = hinge(angle_deg).positions;
        frames.positions.insert(frames.positions.end(), positions.begin(), positions.end());
    }
    scene.animation = std::make_shared<const scene::Animation>(motion);
    scene::check_animation(scene, motion);
    return scene;
}

/// From flat to a right angle, past the crease angle once.
const std::vector<double> kOpening{0, 9, 18, 27, 36, 45, 54, 63, 72, 81, 90};

/// Past the crease angle in every frame, never to the same angle.
const std::vector<double> kFlapping{0, 90, 15, 75, 30, 60, 0, 50, 39, 41};

/// The frames of the sequence: six by three tiles, most of which the hinge never touches.
std::vector<Step> frames_of(const std::vector<double>& angles_deg) {
    scene::Scene scene = moving_hinge(angles_deg);
    const scene::View view = view_from(scene, {2, 1, 9}, {2, 0.5, 0}, {360, 190});
    std::vector<Step> steps;
    for (std::size_t frame = 0; frame < angles_deg.size(); ++frame) {
        scene::pose_scene(scene, scene.animation->frame_time_s(frame));
        steps.push_back({std::to_string(angles_deg[frame]) + " degrees", scene, view});
    }
    return steps;
}

/// The same without an animation: scenes that follow each other, as a program may pose them.
std::vector<Step> without_animation(std::vector<Step> steps) {
    for (Step& step : steps)
        step.scene.animation = nullptr;
    return steps;
}

class Hinge : public testing::TestWithParam<std::string> {
  protected:
    const method::MethodInfo& info() const { return find_method(GetParam()); }

    /// The first frame that is another one when tiles are kept, with any setting of the sweep.
    [[nodiscard]] std::string breach(const std::vector<Step>& steps) const {
        for (const core::ParamValues& setting : info().sweep) {
            const MakeMethod make = [&] { return info().make(setting); };
            const auto expected = expected_of(make, steps);
            const auto all = [](std::size_t) { return raster::SkipSet(); };
            for (const auto& skips : {std::function(all), changing_skips(3)}) {
                const std::string frame = breach_of_a_sequence(make, steps, expected, skips);
                if (!frame.empty()) return frame + " " + testing::PrintToString(setting);
            }
        }
        return "";
    }
};

TEST_P(Hinge, ThatPassesTheCreaseAngleIsDrawnAsWithoutReuse) {
    for (const std::vector<double>& angles_deg : {kOpening, kFlapping}) {
        EXPECT_EQ(breach(frames_of(angles_deg)), "");
        EXPECT_EQ(breach(without_animation(frames_of(angles_deg))), "");
    }
}

TEST_P(Hinge, KeepsTilesInFramesThatLeaveTheTopologyAlone) {
    // Else the laws above would hold for a method that keeps nothing.
    const std::vector<Step> steps = frames_of(kOpening);
    const auto method = info().make({});
    method->prepare(steps.front().scene);
    std::uint64_t tiles = 0;
    std::uint64_t kept = 0;
    for (const Step& step : steps) {
        method->pose(step.scene);
        (void)image_by(*method, {step.view, 1, {}});
        raster::SkipCounts counts = method->skip_counts();
        tiles += raster::count_of(counts, raster::Skip::temporal_reuse).of;
        kept += raster::count_of(counts, raster::Skip::temporal_reuse).skipped;
    }
    if (tiles == 0) GTEST_SKIP() << "it never keeps a tile";
    EXPECT_GT(kept, tiles / 2);
}

TEST_P(Hinge, IsSeenToFold) {
    // The crease stands between 36 and 45 degrees: a method that draws creases shows it.
    static_assert(36 < kCrease_deg && kCrease_deg < 45);
    if (!draws_creases(GetParam())) GTEST_SKIP() << "it draws no crease";
    const MakeMethod make = [&] { return info().make({}); };
    const auto images = expected_of(make, without_animation(frames_of({36, 45})));
    EXPECT_NE(images[0], images[1]);
}

INSTANTIATE_TEST_SUITE_P(Every, Hinge, testing::ValuesIn(method_names()), [](const auto& method) {
    return method.param;
});

}  // namespace
}  // namespace ink::methods
