#include "scene/prepared_scene.h"

#include <gtest/gtest.h>

#include <chrono>
#include <thread>

#include "catalogue/catalogue.h"
#include "scene/surface.h"
#include "scene/topology.h"

namespace {

using namespace ink::scene;

class Prepared : public testing::Test {
  protected:
    Scene scene_ = ink::catalogue::make_catalogue_scene("cube");
    PreparedScene prepared_{scene_};
};

TEST_F(Prepared, GivesWhatTheSceneGives) {
    const Surface alone = flatten(scene_, NormalSource::patch, 0.5);
    const auto surface = prepared_.surface(NormalSource::patch, 0.5);
    EXPECT_EQ(surface->p_world, alone.p_world);
    EXPECT_EQ(surface->n_world, alone.n_world);
    EXPECT_EQ(surface->triangles, alone.triangles);
    EXPECT_TRUE(prepared_.surface()->n_world.empty());
    EXPECT_EQ(prepared_.topology()->p_world, weld(scene_).p_world);
    EXPECT_EQ(prepared_.hash(), scene_hash(scene_));
    EXPECT_EQ(prepared_.bounds().radius, bounding_sphere(scene_).radius);
}

TEST_F(Prepared, MakesEachOnceAndTellsSettingsApart) {
    const auto smooth = prepared_.surface(NormalSource::patch, 3);
    EXPECT_EQ(prepared_.surface(NormalSource::patch, 3), smooth);
    EXPECT_NE(prepared_.surface(NormalSource::patch, 0.5), smooth);
    EXPECT_NE(prepared_.surface(NormalSource::facet, 3), smooth);
    EXPECT_NE(prepared_.topology(0.01), prepared_.topology());
}

TEST_F(Prepared, KeepsTheLastAskedFor) {
    const PreparedScene few(scene_, 2);
    int made = 0;
    const auto ask = [&](const char* name) { return *few.get(name, [&] { return ++made; }); };
    EXPECT_EQ(ask("a"), 1);
    EXPECT_EQ(ask("b"), 2);
    EXPECT_EQ(ask("a"), 1);
    EXPECT_EQ(ask("c"), 3);  // b goes
    EXPECT_EQ(ask("a"), 1);
    EXPECT_EQ(ask("b"), 4);
}

TEST_F(Prepared, CountsWhatIsThereAsLongAsItTookWithAllThatIsInIt) {
    using std::chrono::nanoseconds;
    constexpr std::chrono::milliseconds kStep(2);
    const auto inner = [&] {
        return prepared_.get("inner", [&] {
            std::this_thread::sleep_for(kStep);
            return 1;
        });
    };
    const auto outer = [&] {
        return prepared_.get("outer", [&] {
            std::this_thread::sleep_for(kStep);
            return *inner();
        });
    };
    (void)inner();
    EXPECT_EQ(prepared_.saved_ns(), 0);
    (void)outer();
    const nanoseconds of_inner(prepared_.saved_ns());
    EXPECT_GE(of_inner, kStep);
    (void)outer();
    EXPECT_GE(nanoseconds(prepared_.saved_ns()) - of_inner, of_inner + kStep);
}

}  // namespace
