#include "raster/mesh/front_depth.h"

#include <gtest/gtest.h>

#include <numeric>
#include <vector>

#include "catalogue/shapes.h"
#include "core/simd.h"
#include "raster/mesh/mesh_pass.h"
#include "tests/raster/gather_sink.h"

namespace ink::raster {
namespace {

constexpr int kSize_px = 128;  // four tiles

/// Two open sheets of triangles of a pixel or two, the farther one wholly behind the nearer one.
struct TwoSheets {
    scene::Surface surface;
    LaneMesh mesh;
    scene::View view;

    TwoSheets() {
        scene::Scene made;
        made.meshes.push_back(
            catalogue::make_sheet({-1, -1, 0}, {2, 0, 0.25}, {0, 2, 0.5}, {70, 70}));
        made.meshes.push_back(
            catalogue::make_sheet({-0.5, -0.5, -1}, {1, 0, 0}, {0, 1, 0}, {60, 60}));
        made.instances.resize(2);
        made.instances[1].mesh = 1;
        surface = scene::flatten(made, scene::NormalSource::patch, 0.7);
        mesh = LaneMesh(surface);
        view.camera = scene::look_at({0.125, 0.25, 4}, {0, 0, 0}, {0, 1, 0}, 0.75);
        scene::fit_clip_range(view.camera, scene::bounding_sphere(made));
        view.width_px = view.height_px = kSize_px;
    }
};

/// One code a vertex, of its depth and normal.
class OneCode : public CornerValues {
  public:
    void compute(const CornerBatch& in, const CornerPlanes& out) const override {
        const LinearValue value{.base = 10, .per_q = 700, .per_normal = {20, 30, 40}};
        compute_linear(&value, 1, false, in, out);
    }
};

PassFormat one_byte() {
    return {.interpolants = 1, .store = Store::u8, .halo_px = 1};
}

struct Drawn {
    GatherSink<std::uint8_t> image;
    MeshResult result;

    friend bool same_image(const Drawn& a, const Drawn& b) {
        return a.image.depth == b.image.depth && a.image.planes[0] == b.image.planes[0];
    }
};

Drawn draw(const TwoSheets& sheets, int threads, const SkipSet& skips) {
    const PassFormat format = one_byte();
    const OneCode values;
    MeshInput input;
    input.mesh = &sheets.mesh;
    input.values = &values;
    input.view = sheets.view;
    input.threads = threads;
    input.skips = skips;
    Drawn drawn{{format, kSize_px, kSize_px}, {}};
    MeshPass pass;
    for (int frame = 0; frame < 2; ++frame)  // the second in what the first left
        drawn.result = pass.draw(format, input, drawn.image);
    return drawn;
}

TEST(FrontDepth, FineOpenSurfacesAreDrawnInTwoGoes) {
    const TwoSheets sheets;
    MeshInput input;
    input.mesh = &sheets.mesh;
    input.view = sheets.view;
    const std::vector<SolidView> open(sheets.mesh.clusters().solids.size());
    const std::size_t clusters = sheets.mesh.clusters().clusters.size();
    const TileGrid few{kSize_px, kSize_px, 1};
    EXPECT_EQ(front_clusters(one_byte(), input, few, open), clusters / 2);
    const TileGrid many{3840, 2160, 1};
    EXPECT_EQ(front_clusters(one_byte(), input, many, open), 0U) << "too few a tile";
    const std::vector<SolidView> watertight(open.size(), SolidView{true});
    EXPECT_EQ(front_clusters(one_byte(), input, few, watertight), 0U)
        << "what is hidden is turned away";
    input.skips.set(Skip::occlusion_culling, false);
    EXPECT_EQ(front_clusters(one_byte(), input, few, open), 0U) << "not allowed";
    input.skips = {};
    input.may_keep_still = true;
    EXPECT_EQ(front_clusters(one_byte(), input, few, open), 0U)
        << "tiles must know who touches them";
}

TEST(FrontDepth, TheSheetBehindIsPassedOverAndTheImageIsTheSame) {
    const TwoSheets sheets;
    const Drawn all = draw(sheets, 1, SkipSet::none());
    const Drawn drawn = draw(sheets, 1, {});
    EXPECT_TRUE(same_image(drawn, all));
    EXPECT_GT(drawn.image.depth.at(kSize_px / 2, kSize_px / 2), 0);
    SkipCounts counts = drawn.result.skips;
    constexpr std::size_t kBehind = 60 * 60 * 2;
    constexpr std::size_t kInFront = 70 * 70 * 2;
    EXPECT_GT(count_of(counts, Skip::occlusion_culling).skipped, kBehind * 3 / 4);
    EXPECT_LT(count_of(counts, Skip::no_sample).of, kInFront + kBehind / 4)
        << "passed over before its triangles are looked at";
}

TEST(FrontDepth, ThreadsAndTargetsNeitherChangeTheImageNorTheCounts) {
    const TwoSheets sheets;
    const Drawn one = draw(sheets, 1, {});
    for (const core::SimdTarget& target : core::simd_targets()) {
        const core::ForcedSimdTarget forced(target);
        for (const int threads : {1, 3}) {
            const Drawn other = draw(sheets, threads, {});
            EXPECT_TRUE(same_image(other, one)) << target.name << ", threads " << threads;
            for (std::size_t i = 0; i < kSkipCount; ++i)
                EXPECT_EQ(other.result.skips[i].skipped, one.result.skips[i].skipped)
                    << skip_infos()[i].name << ", " << target.name << ", threads " << threads;
        }
    }
}

TEST(FrontToBack, WhatIsTurnedAwayOfAnOpenSurfaceComesLast) {
    const TwoSheets sheets;
    MeshInput input;
    input.mesh = &sheets.mesh;
    input.view = sheets.view;
    const auto& clusters = sheets.mesh.clusters();
    // From behind both sheets show their backs; from here neither does.
    const std::vector<SolidView> open(clusters.solids.size());
    const auto late = [&](const std::vector<SolidView>& solids) {
        const ClusterOrder order = front_to_back(input, solids);
        EXPECT_EQ(order.clusters.size(), clusters.clusters.size());
        bool is_late = false;
        std::size_t count = 0;
        for (const std::uint32_t cluster : order.clusters) {
            EXPECT_GE(order.is_late[cluster] != 0, is_late) << "one that faces the eye after it";
            is_late = order.is_late[cluster] != 0;
            count += order.is_late[cluster];
        }
        return count;
    };
    EXPECT_EQ(late(open), 0U);
    input.view.camera.eye_world = {0.125, 0.25, -40};
    EXPECT_EQ(late(open), clusters.clusters.size());
    const std::vector<SolidView> hides_backs(open.size(), SolidView{true});
    EXPECT_EQ(late(hides_backs), 0U) << "passed over anyway";
}

/// Enough clusters for several threads: one fine sheet faces the eye, another turns away from it.
TEST(FrontToBack, IsTheSameOrderOnAnyNumberOfThreads) {
    scene::Scene made;
    made.meshes.push_back(
        catalogue::make_sheet({-1, -1, 0}, {2, 0, 0.25}, {0, 2, 0.5}, {400, 400}));
    made.meshes.push_back(catalogue::make_sheet({-1, -1, -1}, {0, 2, 0}, {2, 0, 0.5}, {300, 300}));
    made.instances.resize(2);
    made.instances[1].mesh = 1;
    const scene::Surface surface = scene::flatten(made, scene::NormalSource::patch, 0.7);
    const LaneMesh mesh(surface);
    MeshInput input;
    input.mesh = &mesh;
    input.view.camera.eye_world = {0.125, 0.25, 4};
    const std::vector<SolidView> open(mesh.clusters().solids.size());
    const ClusterOrder one = front_to_back(input, open);
    const auto late = std::accumulate(one.is_late.begin(), one.is_late.end(), std::size_t{0});
    ASSERT_GT(one.clusters.size(), 4096U);
    EXPECT_GT(late, 1000U);
    EXPECT_LT(late, one.clusters.size());
    for (const int threads : {2, 3, 16}) {
        input.threads = threads;
        const ClusterOrder other = front_to_back(input, open);
        EXPECT_EQ(other.clusters, one.clusters) << threads << " threads";
        EXPECT_EQ(other.is_late, one.is_late) << threads << " threads";
    }
}

/// A ball that lies wholly behind what is drawn, and ones that do not.
TEST(FrontDepth, HidesABallOnlyWhereItKnowsWhatStandsBeforeIt) {
    const TwoSheets sheets;
    MeshInput input;
    input.view = sheets.view;
    const TileGrid grid{kSize_px, kSize_px, 1};
    FrontDepth front;
    front.start(grid, input);
    const scene::Sphere behind{{0, 0, -2}, 0.125};
    EXPECT_FALSE(front.hides(behind)) << "nothing is drawn";
    for (int tile = 0; tile < grid.count(); ++tile) {
        front.tile(tile).is_drawn = true;
        for (auto& row : front.tile(tile).least)
            row.fill(0.25F);  // 1/w of the plane 4 units away
    }
    EXPECT_TRUE(front.hides(behind));
    EXPECT_FALSE(front.hides({{0, 0, 1}, 0.125})) << "before it";
    EXPECT_FALSE(front.hides({{0, 0, 0}, 0.25})) << "across it";
    EXPECT_FALSE(front.hides({{0, 0, 4}, 0.25})) << "round the eye";
    front.tile(0).least[3][3] = 0;  // the square left of and above the middle
    EXPECT_FALSE(front.hides(behind)) << "seen through the hole";
}

}  // namespace
}  // namespace ink::raster
