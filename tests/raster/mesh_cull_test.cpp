#include <gtest/gtest.h>

#include "raster/depth/depth_image.h"
#include "scene/predicates.h"
#include "tests/raster/gather_sink.h"
#include "tests/raster/stage.h"

namespace ink::raster {
namespace {

constexpr int kWidth_px = 200;
constexpr int kHeight_px = 150;

struct Asked {
    DepthFormat depth = DepthFormat::q32;
    Cull cull = Cull::none;
    PolygonOffset offset;
};

struct CullStage : Stage {
    explicit CullStage(const std::string& name) : Stage(name, {kWidth_px, kHeight_px}, 1) {}

    [[nodiscard]] core::Image<std::uint32_t> draw(const Asked& asked) const {
        PassFormat format;
        format.depth = asked.depth;
        MeshInput input = mesh_input(1, {});
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
        const std::vector<glm::dvec3> p_clip = clip_places(surface, view);
        const auto& p = surface.p_world;
        std::vector<scene::Triangle> left;
        for (const scene::Triangle& t : surface.triangles) {
            const int side = scene::facing(p[t[0]], p[t[1]], p[t[2]], view.camera.viewpoint());
            const Cull drops = side < 0 ? Cull::back : Cull::front;
            if (drops != asked.cull) left.push_back(t);
        }
        PassFormat format;
        format.depth = asked.depth;
        PassInput input = plain_input(p_clip, view);
        input.triangles = left;
        return gathered<std::uint32_t, std::uint32_t>(format, input, kWidth_px, kHeight_px).depth;
    }
};

const std::vector<std::string> kScenes = {"sphere", "tree", "soup", "room"};

TEST(MeshCull, LeavesOutExactlyTheSideItNames) {
    for (const std::string& name : kScenes) {
        const CullStage stage(name);
        for (const Cull cull : {Cull::back, Cull::front}) {
            for (const DepthFormat depth : {DepthFormat::z24, DepthFormat::q32}) {
                const auto lanes = stage.draw({depth, cull, {}});
                const auto plain = stage.draw_plainly({depth, cull, {}});
                int unlike_px = 0;
                for (std::size_t i = 0; i < lanes.size(); ++i) {
                    EXPECT_EQ(lanes.data()[i] > 0, plain.data()[i] > 0) << name << " at " << i;
                    const auto apart = static_cast<std::int64_t>(lanes.data()[i]) - plain.data()[i];
                    unlike_px += std::abs(apart) > 64 ? 1 : 0;  // the two sides are further apart
                }
                // Lanes round otherwise than the plain pass, by few of 2^24 steps.
                if (depth == DepthFormat::z24) {
                    EXPECT_LE(unlike_px, kWidth_px * kHeight_px / 500) << name;
                }
            }
        }
    }
}

/// A watertight solid's far side is in front of its near side once it is moved far enough: it must
/// be drawn, though it is never seen otherwise.
TEST(MeshCull, DrawsBacksThatAnOffsetMayBringForward) {
    const CullStage stage("cube");
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
