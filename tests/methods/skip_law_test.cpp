// A skip never changes a bit: over all methods of the registry, on catalogue scenes that stand
// still and on sequences in which something moves.

#include "tests/methods/skip_law.h"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>

#include "catalogue/catalogue.h"
#include "catalogue/shapes.h"
#include "tests/catalogue_names.h"
#include "tests/methods/names.h"

namespace ink::methods {
namespace {

using raster::Skip;

MakeMethod maker(const method::MethodInfo& info, const core::ParamValues& settings = {}) {
    return [&info, settings] { return info.make(settings); };
}

class SkipsOnAScene : public testing::TestWithParam<std::string> {};

TEST_P(SkipsOnAScene, LeaveTheImagesOfAllMethodsAlone) {
    const scene::Scene scene = catalogue::make_catalogue_scene(GetParam());
    std::vector<scene::View> views;
    // Four by three tiles, those at the frame cut.
    for (const scene::Camera& camera : {scene.cameras.front(), scene.cameras.back()})
        views.push_back({camera, 210, 140});
    if (scene.cameras.size() == 1) {
        views.back().camera = scene::orbit_cameras(bounding_sphere(scene), 1, 1.5).front();
    }
    views.push_back(views.front());
    views.back().camera = scene::projected(
        scene::ProjectionKind::parallel, views.front().camera, bounding_sphere(scene));
    for (const method::MethodInfo& info : registry())
        EXPECT_EQ(breach_of_a_view(maker(info), scene, views), "") << info.name;
}

INSTANTIATE_TEST_SUITE_P(Every,
                         SkipsOnAScene,
                         testing::ValuesIn(light_scene_names()),
                         [](const auto& scene) { return scene.param; });

/// A cube on a floor among four balls, each in tiles of its own.
scene::Scene playground() {
    scene::Scene scene = cube_on_floor();
    scene.meshes.push_back(catalogue::make_icosphere(0.5, 2));
    for (const glm::dvec3 at : {glm::dvec3{3, 0, 2}, {-3, 0, 2}, {3, 2, -2}, {-3, 2, -2}}) {
        scene.instances.push_back({2, glm::translate(glm::dmat4(1), at), "ball"});
    }
    return scene;
}

void turn(scene::Instance& instance, double angle_rad) {
    instance.world_from_object =
        glm::rotate(instance.world_from_object, angle_rad, glm::dvec3(0.3, 1, 0));
}

void move(scene::Instance& instance, const glm::dvec3& by) {
    instance.world_from_object = glm::translate(glm::dmat4(1), by) * instance.world_from_object;
}

/// Builds a sequence in which each step changes the one before it.
class Sequence {
  public:
    Sequence() : now_{"start", playground(), {}} {
        now_.view = view_from(now_.scene, {1, 2, 9}, {0, 0, 0}, {300, 200});
        steps_.push_back(now_);
    }
    template <class Change>
    Sequence& then(std::string name, Change change) {
        now_.name = std::move(name);
        now_.is_posed = true;
        change(now_);
        steps_.push_back(now_);
        return *this;
    }
    [[nodiscard]] std::vector<Step> steps() const { return steps_; }

  private:
    Step now_;
    std::vector<Step> steps_;
};

std::function<void(Step&)> moved(std::size_t instance, const glm::dvec3& by) {
    return [=](Step& s) { move(s.scene.instances[instance], by); };
}
std::function<void(Step&)> sized(int width_px, int height_px) {
    return [=](Step& s) {
        s.view.width_px = width_px;
        s.view.height_px = height_px;
    };
}

/// All that may come between two frames, with a fixed camera and without.
std::vector<Step> eventful_sequence() {
    const scene::Scene first = playground();
    const scene::View fixed = view_from(first, {1, 2, 9}, {0, 0, 0}, {300, 200});
    return Sequence()
        .then("the same again", [](Step& s) { s.is_posed = false; })
        .then("posed, but nothing moved", [](Step&) {})
        .then("the cube turned", [](Step& s) { turn(s.scene.instances[0], 0.05); })
        .then("the cube turned on", [](Step& s) { turn(s.scene.instances[0], 0.05); })
        .then("a ball moved within a pixel", moved(2, {0.001, 0, 0}))
        .then("a ball jumped across", moved(2, {-3, 2, -1}))
        .then("on two threads", [](Step& s) { s.threads = 2; })
        .then("the cube turned, two threads", [](Step& s) { turn(s.scene.instances[0], 0.1); })
        .then("the cube far away", moved(0, {40, 0, -60}))
        .then("the cube back", moved(0, {-40, 0, 60}))
        .then("a ball behind the floor", moved(3, {3, -3, 0}))
        .then("a ball across the eye", moved(4, {-2, 0, 11}))
        .then("the ball back", moved(4, {2, 0, -11}))
        .then("a corner of the floor moved",
              [](Step& s) { s.scene.meshes[1].positions[0] += glm::vec3(0, 0.3F, 0); })
        .then("one thread", [](Step& s) { s.threads = 1; })
        .then("the camera moved",
              [&](Step& s) {
                  s.view = view_from(first, {2, 2, 9}, {0, 0, 0}, {300, 200});
              })
        .then("the camera back", [&](Step& s) { s.view = fixed; })
        .then("the camera moved by less than a pixel",
              [](Step& s) { s.view.camera.eye_world.x += 1e-4; })
        .then("the near plane moved", [](Step& s) { s.view.camera.near *= 0.5; })
        .then("the far plane moved", [](Step& s) { s.view.camera.far *= 1.5; })
        .then("a wider lens", [](Step& s) { s.view.camera.fov_y_rad = 0.8; })
        .then("a smaller image", sized(190, 131))
        .then("a larger image", sized(330, 200))
        .then("an image of as many tiles that lie otherwise", sized(200, 330))
        .then("all as it was",
              [&](Step& s) {
                  s.view = fixed;
                  s.scene = first;
              })
        .then("nothing in view",
              [](Step& s) {
                  for (scene::Instance& instance : s.scene.instances)
                      move(instance, {0, 0, 30});
              })
        .then("everything again", [&](Step& s) { s.scene = first; })
        .steps();
}

class SkipsInASequence : public testing::TestWithParam<std::string> {
  protected:
    const method::MethodInfo& info() const { return find_method(GetParam()); }
    const std::vector<Step> steps_ = eventful_sequence();
};

TEST_P(SkipsInASequence, LeaveEveryFrameAlone) {
    const MakeMethod make = maker(info());
    const auto expected = expected_of(make, steps_);
    for (const NamedSkips& set : skip_sets()) {
        EXPECT_EQ(
            breach_of_a_sequence(make, steps_, expected, [&](std::size_t) { return set.skips; }),
            "")
            << set.name;
    }
    for (unsigned seed = 0; seed < 6; ++seed)
        EXPECT_EQ(breach_of_a_sequence(make, steps_, expected, changing_skips(seed)), "") << seed;
}

TEST_P(SkipsInASequence, LeaveEveryFrameOfEverySettingAlone) {
    for (const core::ParamValues& setting : info().sweep) {
        SCOPED_TRACE(testing::PrintToString(setting));
        const MakeMethod make = maker(info(), setting);
        const auto expected = expected_of(make, steps_);
        EXPECT_EQ(breach_of_a_sequence(
                      make, steps_, expected, [](std::size_t) { return raster::SkipSet(); }),
                  "");
        EXPECT_EQ(breach_of_a_sequence(make, steps_, expected, changing_skips(7)), "");
    }
}

TEST_P(SkipsInASequence, EveryFrameDiffersFromTheOneBeforeWhereItShould) {
    // Else the laws above would hold for a method that draws one image and keeps it.
    const auto expected = expected_of(maker(info()), steps_);
    int differing = 0;
    for (std::size_t i = 1; i < expected.size(); ++i)
        differing += expected[i] != expected[i - 1];
    EXPECT_GT(differing, 14);
}

INSTANTIATE_TEST_SUITE_P(Every,
                         SkipsInASequence,
                         testing::ValuesIn(method_names()),
                         [](const auto& method) { return method.param; });

/// What mote4 leaves out of the third of three drawings of a scene in which one thing moves, from
/// far away and so near that some of it is outside, summed over scenes.
raster::SkipCounts counted(const raster::SkipSet& allowed, int threads) {
    raster::SkipCounts sums{};
    const auto method =
        find_method("mote4").make({{"range_nx", "0"}, {"range_ny", "0"}, {"range_nz", "0"}});
    for (const char* name : {"blocks", "horizon", "teapot"}) {
        scene::Scene scene = catalogue::make_catalogue_scene(name);
        method->prepare(scene);
        for (const double zoom : {0.25, 1.0, 20.0}) {
            scene::View view{scene.cameras.front(), 420, 280};
            view.camera.fov_y_rad = 2 * std::atan(std::tan(view.camera.fov_y_rad / 2) / zoom);
            edge::EdgeImage out(420, 280);
            for (int drawing = 0; drawing < 3; ++drawing) {
                move(scene.instances.front(), {0.001, 0, 0});
                method->pose(scene);
                method->draw({view, threads, allowed}, out);
            }
            const raster::SkipCounts counts = method->skip_counts();
            for (std::size_t i = 0; i < sums.size(); ++i)
                sums[i].skipped += counts[i].skipped;
        }
    }
    return sums;
}

std::uint64_t skipped(const raster::SkipCounts& counts, Skip skip) {
    return counts[static_cast<std::size_t>(skip)].skipped;
}

TEST(SkipCounts, AreAboveZeroWhereASkipIsAllowedOnAnyNumberOfThreads) {
    const raster::SkipSet still = raster::SkipSet().set(Skip::temporal_reuse, false);
    const raster::SkipCounts one = counted(still, 1), two = counted(still, 2);
    const raster::SkipCounts again = counted({}, 1);
    for (const raster::SkipInfo& info : raster::skip_infos()) {
        const auto& of = info.skip == Skip::temporal_reuse ? again : one;
        EXPECT_GT(skipped(of, info.skip), 0U) << info.name;
        EXPECT_EQ(skipped(one, info.skip), skipped(two, info.skip)) << info.name;
    }
}

TEST(SkipCounts, AreZeroWhereItIsNot) {
    const raster::SkipCounts none = counted(raster::SkipSet::none(), 1);
    for (const raster::SkipInfo& info : raster::skip_infos()) {
        EXPECT_EQ(skipped(counted(raster::SkipSet().set(info.skip, false), 1), info.skip), 0U);
        EXPECT_EQ(skipped(none, info.skip), 0U) << info.name << " with everything off";
    }
}

}  // namespace
}  // namespace ink::methods
