#include <gtest/gtest.h>

#include "catalogue/catalogue.h"
#include "core/simd.h"
#include "gather_sink.h"
#include "raster/depth/depth_image.h"
#include "raster/mesh/mesh_pass.h"
#include "raster/pass/view_transform.h"

namespace ink::raster {
namespace {

constexpr int kWidth_px = 200;
constexpr int kHeight_px = 150;

struct Asked {
    DepthFormat depth = DepthFormat::q32;
    Cull cull = Cull::none;
    PolygonOffset offset;
};

struct Stage {
    scene::Surface surface;
    LaneMesh mesh;
    scene::View view;

    explicit Stage(const std::string& name, double nearer = 1) {
        const scene::Scene made = catalogue::make_catalogue_scene(name);
        surface = scene::flatten(made);
        mesh = LaneMesh(surface);
        const scene::Sphere bounds = scene::bounding_sphere(made);
        view.camera = made.cameras.front();
        view.camera.eye_world =
            bounds.center_world + (view.camera.eye_world - bounds.center_world) * nearer;
        scene::fit_clip_range(view.camera, bounds);
        view.width_px = kWidth_px;
        view.height_px = kHeight_px;
    }

    [[nodiscard]] core::Image<std::uint32_t> draw(const Asked& asked,
                                                  int threads = 1,
                                                  const SkipSet& skips = {}) const {
        PassFormat format;
        format.depth = asked.depth;
        MeshInput input;
        input.mesh = &mesh;
        input.view = view;
        input.threads = threads;
        input.skips = skips;
        input.cull = asked.cull;
        input.offset = asked.offset;
        DepthImage image;
        image.start(asked.depth, view.camera.near, view.camera.far, kWidth_px, kHeight_px);
        DepthSink sink(image);
        MeshPass pass;
        (void)pass.draw(format, input, sink);
        return image.bits();
    }

    /// Of the plain pass, which knows neither sides nor solids: those triangles alone that are
    /// left.
    [[nodiscard]] core::Image<std::uint32_t> draw_plainly(const Asked& asked) const {
        const ViewTransform transform(view);
        std::vector<glm::dvec3> p_clip;
        for (const glm::dvec3& p : surface.p_world)
            p_clip.push_back(transform.to_clip(p));
        const auto sides = scene::facings(surface, view.camera.viewpoint());
        std::vector<scene::Triangle> left;
        for (std::size_t i = 0; i < sides.size(); ++i) {
            const Cull drops = sides[i] < 0 ? Cull::back : Cull::front;
            if (drops != asked.cull) left.push_back(surface.triangles[i]);
        }
        PassFormat format;
        format.depth = asked.depth;
        PassInput input;
        input.p_clip = p_clip;
        input.triangles = left;
        input.near = view.camera.near;
        input.far = view.camera.far;
        GatherSink<std::uint32_t, std::uint32_t> sink(format, kWidth_px, kHeight_px);
        draw_pass(format, input, kWidth_px, kHeight_px, 1, sink);
        return sink.depth;
    }
};

const std::vector<std::string> kScenes = {"sphere", "tree", "soup", "room"};

TEST(MeshCull, LeavesOutExactlyTheSideItNames) {
    for (const std::string& name : kScenes) {
        const Stage stage(name);
        for (const Cull cull : {Cull::back, Cull::front}) {
            // Lanes round otherwise than the plain pass, by few of 2^24 steps.
            const Asked asked{DepthFormat::z24, cull, {}};
            const auto lanes = stage.draw(asked);
            const auto plain = stage.draw_plainly(asked);
            int unlike_px = 0;
            for (std::size_t i = 0; i < lanes.size(); ++i) {
                EXPECT_EQ(lanes.data()[i] > 0, plain.data()[i] > 0) << name << " at " << i;
                const auto apart = static_cast<std::int64_t>(lanes.data()[i]) - plain.data()[i];
                unlike_px += std::abs(apart) > 64 ? 1 : 0;  // the two sides are further apart
            }
            EXPECT_LE(unlike_px, kWidth_px * kHeight_px / 500) << name;
        }
    }
}

/// Lanes round otherwise than the plain pass, so only what is covered is compared.
TEST(MeshCull, LeavesOutTheSameInLanes) {
    for (const std::string& name : kScenes) {
        const Stage stage(name);
        for (const Cull cull : {Cull::back, Cull::front}) {
            const auto lanes = stage.draw({DepthFormat::q32, cull, {}});
            const auto plain = stage.draw_plainly({DepthFormat::q32, cull, {}});
            for (std::size_t i = 0; i < lanes.size(); ++i)
                EXPECT_EQ(lanes.data()[i] > 0, plain.data()[i] > 0) << name << " at " << i;
        }
    }
}

TEST(MeshCull, SkipsThreadsAndTargetsNeverChangeABit) {
    std::vector<Asked> all;
    for (const DepthFormat depth : {DepthFormat::q32, DepthFormat::z24}) {
        for (const Cull cull : {Cull::none, Cull::back, Cull::front}) {
            all.push_back({depth, cull, {}});
            all.push_back({depth, cull, {-1.5, -1}});
        }
    }
    for (const std::string& name : kScenes) {
        for (const double nearer : {1.0, 0.05}) {
            const Stage stage(name, nearer);
            for (const Asked& asked : all) {
                const auto best = stage.draw(asked);
                EXPECT_TRUE(stage.draw(asked, 3) == best) << name;
                EXPECT_TRUE(stage.draw(asked, 1, SkipSet::none()) == best) << name;
                for (const core::SimdTarget& target : core::simd_targets()) {
                    const core::ForcedSimdTarget forced(target);
                    EXPECT_TRUE(stage.draw(asked) == best) << name << " on " << target.name;
                }
            }
        }
    }
}

/// A watertight solid's far side is in front of its near side once it is moved far enough: it must
/// be drawn, though it is never seen otherwise.
TEST(MeshCull, DrawsBacksThatAnOffsetMayBringForward) {
    const Stage stage("cube");
    const auto both = stage.draw({DepthFormat::z24, Cull::none, {-20, 0}});
    const auto fronts = stage.draw({DepthFormat::z24, Cull::back, {-20, 0}});
    int nearer_px = 0;
    for (std::size_t i = 0; i < both.size(); ++i) {
        EXPECT_GE(both.data()[i], fronts.data()[i]);
        nearer_px += both.data()[i] > fronts.data()[i] ? 1 : 0;
    }
    EXPECT_GT(nearer_px, 0);
}

}  // namespace
}  // namespace ink::raster
