#include "scene/sharing/shared_work.h"

#include <gtest/gtest.h>

#include "catalogue/catalogue.h"
#include "scene/clusters.h"
#include "scene/surface.h"
#include "scene/topology.h"

namespace {

using namespace ink::scene;

class Shared : public testing::Test {
  protected:
    Scene scene_ = ink::catalogue::make_catalogue_scene("cube");
    SharedWork work_{scene_, 8};
};

bool is_same(const Surface& a, const Surface& b) {
    return a.p_world == b.p_world && a.n_world == b.n_world && a.triangles == b.triangles &&
           a.object == b.object;
}

TEST_F(Shared, GivesEqualResultsInMemoryOfTheirOwn) {
    const Surface alone = flatten(scene_, NormalSource::patch, 0.5);
    const SharedWork::Use use(work_);
    const Surface first = flatten(scene_, NormalSource::patch, 0.5);
    const Surface second = flatten(scene_, NormalSource::patch, 0.5);
    EXPECT_TRUE(is_same(first, alone));
    EXPECT_TRUE(is_same(second, alone));
    EXPECT_NE(first.p_world.data(), second.p_world.data());
    EXPECT_EQ(weld(scene_).edges.size(), weld(scene_).edges.size());
    EXPECT_EQ(scene_hash(scene_), scene_hash(Scene(scene_)));
    EXPECT_EQ(make_clusters(first).triangle_ids, make_clusters(alone).triangle_ids);
}

TEST_F(Shared, TellsSettingsApart) {
    const SharedWork::Use use(work_);
    const Surface smooth = flatten(scene_, NormalSource::patch, 3);
    EXPECT_FALSE(is_same(smooth, flatten(scene_, NormalSource::patch, 0.5)));
    EXPECT_FALSE(is_same(smooth, flatten(scene_, NormalSource::facet, 3)));
    EXPECT_TRUE(flatten(scene_).n_world.empty());
}

TEST_F(Shared, LeavesOtherScenesAlone) {
    const SharedWork::Use use(work_);
    const Surface cube = flatten(scene_);
    const Scene moved = ink::catalogue::make_catalogue_scene("sphere");
    EXPECT_NE(flatten(moved).triangles.size(), cube.triangles.size());
    EXPECT_EQ(work_.name_of(flatten(moved)), "");
    EXPECT_EQ(work_.name_of(cube), kSurfaceName);
}

TEST_F(Shared, MakesOnceAndKeepsTheLastAskedFor) {
    SharedWork few(scene_, 2);
    int made = 0;
    const auto ask = [&](const char* name) { return few.get(name, [&] { return ++made; }); };
    EXPECT_EQ(ask("a"), 1);
    EXPECT_EQ(ask("b"), 2);
    EXPECT_EQ(ask("a"), 1);
    EXPECT_EQ(ask("c"), 3);  // b goes
    EXPECT_EQ(ask("a"), 1);
    EXPECT_EQ(ask("b"), 4);
}

TEST_F(Shared, SharesOnlyWhileUsed) {
    {
        const SharedWork::Use use(work_);
        EXPECT_EQ(SharedWork::current(), &work_);
    }
    EXPECT_EQ(SharedWork::current(), nullptr);
    EXPECT_EQ(SharedWork::saved_ns(), 0);
}

}  // namespace
