
#include <gtest/gtest.h>

#include <cmath>
#include <glm/geometric.hpp>
#include <numeric>
#include <random>

#include "catalogue/shapes.h"
#include "core/simd.h"
#include "raster/mesh/mesh_view.h"
#include "scene/predicates.h"
#include "scene/views/framing.h"
#include "tests/raster/gather_sink.h"
#include "tests/raster/stage.h"
#include "tests/scene/small_meshes.h"

namespace ink::raster {
namespace {

using scene::scene_of;

constexpr int kWidth_px = 240;
constexpr int kHeight_px = 180;

/// What both passes make of one view.
struct Compared {
    std::size_t covered_px = 0;
    std::size_t back_px = 0;    ///< the plain pass shows the back of a face
    std::size_t differ_px = 0;  ///< the two show different triangles
    std::size_t lost_px = 0;    ///< of these, not within 1/64 px of an edge of either
    std::size_t windows = 0;    ///< of all solids
    bool hides_backs = false;   ///< of some solid with holes
    std::uint64_t skipped = 0;  ///< clusters turned away
};

class Holed {
  public:
    explicit Holed(const scene::Scene& scene)
        : surface_(scene::flatten(scene)), mesh_(surface_), bounds_(scene::bounding_sphere(scene)) {
        ids_.resize(surface_.triangles.size());
        std::iota(ids_.begin(), ids_.end(), 0U);
    }

    [[nodiscard]] const scene::Clusters& clusters() const { return mesh_.clusters(); }
    [[nodiscard]] const scene::Sphere& bounds() const { return bounds_; }

    [[nodiscard]] scene::View view_from(const glm::dvec3& eye, const glm::dvec3& target) const {
        scene::View view;
        view.camera = scene::look_at(eye, target, {0, 1, 0}, 0.9);
        scene::fit_clip_range(view.camera, bounds_);
        view.width_px = kWidth_px;
        view.height_px = kHeight_px;
        return view;
    }

    [[nodiscard]] core::Image<std::uint32_t> draw(const scene::View& view,
                                                  const SkipSet& skips = {},
                                                  int threads = 1,
                                                  MeshResult* result = nullptr) const {
        MeshInput input = input_of(view);
        input.constants = ids_;
        input.skips = skips;
        input.threads = threads;
        GatherSink<std::uint32_t> sink(id_format(), kWidth_px, kHeight_px);
        MeshPass pass;
        MeshResult drawn = pass.draw(id_format(), input, sink);
        if (result != nullptr) *result = std::move(drawn);
        return sink.planes[0];
    }

    [[nodiscard]] Compared compare(const scene::View& view) const {
        const std::vector<glm::dvec3> p_clip = clip_places(surface_, view);
        PassInput plain = plain_input(p_clip, view);
        plain.triangles = surface_.triangles;
        const auto expected = draw_ids(plain, kWidth_px, kHeight_px).planes[0];
        MeshResult result;
        const auto drawn = draw(view, {}, 1, &result);
        Compared compared;
        compared.skipped = count_of(result.skips, Skip::back_face_culling).skipped;
        for (const SolidView& solid : view_solids(input_of(view))) {
            compared.windows += solid.windows.size();
            compared.hides_backs = compared.hides_backs || solid.hides_backs;
        }
        for (int y = 0; y < kHeight_px; ++y) {
            for (int x = 0; x < kWidth_px; ++x) {
                const std::uint32_t a = drawn.at(x, y), b = expected.at(x, y);
                compared.covered_px += b != kNobody ? 1 : 0;
                compared.back_px += is_back(b, view) ? 1 : 0;
                if (a == b) continue;
                ++compared.differ_px;
                const glm::dvec2 centre(x + 0.5, y + 0.5);
                compared.lost_px +=
                    !is_near_edge(a, centre, p_clip) && !is_near_edge(b, centre, p_clip) ? 1 : 0;
            }
        }
        return compared;
    }

    [[nodiscard]] MeshInput input_of(const scene::View& view) const {
        MeshInput input;
        input.mesh = &mesh_;
        input.view = view;
        input.bounds = bounds_;
        input.sky_code = {kNobody};
        return input;
    }

  private:
    [[nodiscard]] bool is_back(std::uint32_t id, const scene::View& view) const {
        if (id == kNobody) return false;
        const auto& [a, b, c] = surface_.triangles[id];
        const auto& p = surface_.p_world;
        return scene::facing(p[a], p[b], p[c], view.camera.eye_world) < 0;
    }
    [[nodiscard]] bool is_near_edge(std::uint32_t id,
                                    const glm::dvec2& p_px,
                                    const std::vector<glm::dvec3>& p_clip) const {
        if (id == kNobody) return false;
        for (std::size_t i = 0; i < 3; ++i) {
            const glm::dvec3& from = p_clip[surface_.triangles[id][i]];
            const glm::dvec3& to = p_clip[surface_.triangles[id][(i + 1) % 3]];
            const glm::dvec2 a = glm::dvec2(from) / from.z, b = glm::dvec2(to) / to.z;
            const glm::dvec2 ab = b - a;
            const double t = std::clamp(glm::dot(p_px - a, ab) / glm::dot(ab, ab), 0.0, 1.0);
            if (glm::distance(p_px, a + t * ab) <= 1.0 / 64) return true;
        }
        return false;
    }

    scene::Surface surface_;
    LaneMesh mesh_;
    scene::Sphere bounds_;
    std::vector<std::uint32_t> ids_;
};

/// A ball, flattened above and in front, with a hole in either flat; a ring with one in its tube,
/// whose rim is bent, and one that is jagged.
scene::Scene ball() {
    scene::Mesh mesh = catalogue::make_icosphere(1, 5);
    for (glm::vec3& p : mesh.positions) {
        p.y = std::min(p.y, 0.9F);
        p.z = std::min(p.z, 0.9F);
    }
    return scene_of(scene::without(mesh, {{0, 0.9, 0}, {0, 0, 0.9}}, 0.3));
}
scene::Scene ring() {
    return scene_of(scene::without(
        catalogue::make_torus({1.5, 0.5}, {96, 32}), {{1.5, 0.5, 0}, {0, 0, 1}}, 0.4));
}

std::vector<glm::dvec3> random_ways(int count) {
    std::mt19937_64 random(29);
    std::normal_distribution<double> normal;
    std::vector<glm::dvec3> ways;
    for (int i = 0; i < count; ++i)
        ways.push_back(glm::normalize(glm::dvec3(normal(random), normal(random), normal(random))));
    return ways;
}

TEST(Windows, ShowTheSameTrianglesAsThePlainPassFromAllRound) {
    std::size_t without_windows_of_all = 0;
    for (const scene::Scene& scene : {ball(), ring()}) {
        const Holed holed(scene);
        const scene::Solid& solid = holed.clusters().solids[0];
        ASSERT_TRUE(solid.is_watertight_covered);
        std::uint64_t skipped = 0;
        std::size_t differ_px = 0, covered_px = 0, back_px = 0, views = 0, without_windows = 0;
        for (const glm::dvec3& way : random_ways(60)) {
            for (const double distance : {1.05, 1.5, 4.0}) {
                const glm::dvec3 center = solid.bounds.center_world;
                const glm::dvec3 eye = center + way * (distance * solid.bounds.radius);
                const Compared compared = holed.compare(holed.view_from(eye, center));
                EXPECT_EQ(compared.lost_px, 0U) << distance;
                covered_px += compared.covered_px;
                back_px += compared.back_px;
                differ_px += compared.differ_px;
                if (!compared.hides_backs) continue;  // so near that a hole's ball holds the eye
                ++views;
                skipped += compared.skipped;
                if (compared.windows > 0) continue;
                ++without_windows;
                EXPECT_LE(compared.back_px, compared.differ_px) << "but for contours";
            }
        }
        EXPECT_LE(differ_px, covered_px / 1000);
        EXPECT_GT(back_px, covered_px / 200) << "insides are seen";
        EXPECT_GT(views, 150U);
        EXPECT_GT(skipped, 5 * views);
        EXPECT_LT(without_windows, views);
        without_windows_of_all += without_windows;
    }
    EXPECT_GT(without_windows_of_all, 20U);
}

TEST(Windows, AHoleThatFacesTheEyeShowsTheInside) {
    const Holed holed(ball());
    const Compared above = holed.compare(holed.view_from({0.1, 3, 0.2}, {0, 0, 0}));
    EXPECT_GT(above.windows, 0U);
    EXPECT_GT(above.back_px, 300U);
    EXPECT_EQ(above.lost_px, 0U);
    const Compared below = holed.compare(holed.view_from({-1, -3, -2}, {0, 0, 0}));
    EXPECT_EQ(below.windows, 0U);
    EXPECT_LE(below.back_px, 2U);
    EXPECT_GT(below.skipped, above.skipped);
}

TEST(Windows, OfAnEyeInsideOrCutByTheNearPlaneHideNothing) {
    const Holed holed(ball());
    const Compared inside = holed.compare(holed.view_from({0.1, 0.9, 0}, {0, 0, 0}));
    EXPECT_FALSE(inside.hides_backs);
    EXPECT_EQ(inside.lost_px, 0U);
    EXPECT_GT(inside.back_px, 1000U);
    scene::View cut = holed.view_from({0, 0.3, -3}, {0, 0, 0});
    cut.camera.near = 2.5;
    MeshInput input = holed.input_of(cut);
    input.bounds = {{0, 0, 0}, 2};
    EXPECT_FALSE(view_solids(input)[0].hides_backs);
    EXPECT_EQ(holed.compare(cut).lost_px, 0U);
}

TEST(Windows, SkipsThreadsAndTargetsNeverChangeABit) {
    for (const scene::Scene& scene : {ball(), ring()}) {
        const Holed holed(scene);
        for (const glm::dvec3& way : random_ways(6)) {
            const glm::dvec3 eye =
                holed.bounds().center_world + way * (1.3 * holed.bounds().radius);
            const scene::View view = holed.view_from(eye, {0, 0, 0});
            const auto best = holed.draw(view);
            EXPECT_TRUE(holed.draw(view, SkipSet::none()) == best);
            EXPECT_TRUE(holed.draw(view, {}, 3) == best);
            SkipSet skips;
            skips.set(Skip::back_face_culling, false);
            EXPECT_TRUE(holed.draw(view, skips) == best);
            for (const core::SimdTarget& target : core::simd_targets()) {
                const core::ForcedSimdTarget forced(target);
                EXPECT_TRUE(holed.draw(view) == best) << target.name;
            }
        }
    }
}

TEST(Windows, OfAScanFromAllRound) {
    // As scans are: triangles of a pixel, nothing flat, five small holes.
    scene::Mesh mesh = catalogue::make_icosphere(1, 5);
    for (glm::vec3& p : mesh.positions)
        p *= 1 + 0.06F * std::sin(7 * p.x + 2 * p.z) * std::cos(5 * p.y);
    const std::vector<glm::dvec3> holes = {
        {0.1, -1, 0.2}, {-0.4, -0.9, 0}, {0.5, -0.8, -0.4}, {-0.9, 0.3, 0.3}, {0.2, 0.4, 0.9}};
    const Holed scan(scene_of(scene::without(std::move(mesh), holes, 0.12)));
    ASSERT_EQ(scan.clusters().solids.size(), 1U);
    EXPECT_EQ(scan.clusters().solids[0].hole_count, 5U);
    ASSERT_TRUE(scan.clusters().solids[0].is_watertight_covered);
    for (const glm::dvec3& way : random_ways(30)) {
        const glm::dvec3 center = scan.bounds().center_world;
        const glm::dvec3 eye = center + way * (2.0 * scan.bounds().radius);
        const Compared compared = scan.compare(scan.view_from(eye, center));
        EXPECT_EQ(compared.lost_px, 0U);
        EXPECT_GT(compared.skipped, 0U);
    }
}

TEST(Window, ABallIsBehindItWhereTheirConesMeet) {
    const scene::Viewpoint eye;
    const auto window = Window::of({{0, 0, -10}, 1}, eye, 0.001);
    ASSERT_TRUE(window);
    EXPECT_TRUE(window->may_show({{0, 0, -20}, 1}, eye));
    EXPECT_TRUE(window->may_show({{3.9, 0, -20}, 2}, eye));
    EXPECT_FALSE(window->may_show({{4.5, 0, -20}, 2}, eye));
    EXPECT_FALSE(window->may_show({{0, 0, -5}, 1}, eye)) << "before it";
    EXPECT_FALSE(window->may_show({{0, 0, 20}, 1}, eye)) << "behind the eye";
    EXPECT_TRUE(window->may_show({{0, 0, 20}, 21}, eye)) << "it holds the eye";
    EXPECT_FALSE(Window::of({{0, 0, -10}, 11}, eye, 0.001));
}

}  // namespace
}  // namespace ink::raster
