// edge_hash over a whole animation of loose polygons: all frames of knight.mdl.

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/geometric.hpp>
#include <map>
#include <set>

#include "import/import.h"
#include "methods/edge_hash/edge_hash.h"
#include "scene/animation.h"
#include "tests/shared_files.h"

namespace ink::methods {
namespace {

constexpr std::size_t kFrames = 97;

class KnightFrames : public testing::Test {
  protected:
    void SetUp() override {
        const auto path = shared_file("models/knight.mdl");
        INK_SKIP_WITHOUT(path);
        knight_ = import::import_scene(path);
        ASSERT_EQ(knight_.animation->frame_count(), kFrames);
    }
    /// The knight as it is in a frame.
    const scene::Scene& frame(std::size_t number) {
        scene::pose_scene(knight_, knight_.animation->frame_time_s(number));
        return knight_;
    }

  private:
    scene::Scene knight_;
};

TEST_F(KnightFrames, TheSecondRoundIsAllInTheCache) {
    EdgeHash method({});
    method.prepare(frame(0));
    for (const std::uint64_t found : {0U, 97U}) {
        for (std::size_t f = 0; f < kFrames; ++f)
            method.pose(frame(f));
        EXPECT_EQ(method.cache_counts().built, 97U);
        EXPECT_EQ(method.cache_counts().found, found);
        EXPECT_EQ(method.cache_counts().dropped, 0U);
    }
}

TEST_F(KnightFrames, TooSmallACacheBuildsEveryFrameAgain) {
    EdgeHash::Params params;
    params.cached_frames = 96;  // one less than there are: the next is always the one dropped
    EdgeHash method(params);
    method.prepare(frame(0));
    for (int round = 0; round < 2; ++round) {
        for (std::size_t f = 0; f < kFrames; ++f)
            method.pose(frame(f));
    }
    EXPECT_EQ(method.cache_counts().built, 2 * 97U);
    EXPECT_EQ(method.cache_counts().found, 0U);
}

TEST_F(KnightFrames, BoundaryEdgesStayThoseOfTheModel) {
    // Counted from the file's bytes by a program of a few lines in another language. In three
    // frames vertices of the 8-bit grid fall on each other, and with them two triangles. (In frame
    // 39 a third has its corners in a line on that grid; scaled to floats it is a sliver.)
    const std::set<std::size_t> unlike = {1, 2, 7};
    SoupModels models({.epsilon = 1e-5, .most_frames = kFrames});
    models.prepare(frame(0));
    for (std::size_t f = 0; f < kFrames; ++f) {
        models.pose(frame(f));
        EXPECT_EQ(models.totals().boundary, unlike.contains(f) ? 90U : 89U) << f;
        EXPECT_EQ(models.totals().non_manifold, unlike.contains(f) ? 2U : 0U) << f;
        EXPECT_EQ(models.totals().duplicate, unlike.contains(f) ? 1U : 0U) << f;
        EXPECT_EQ(models.totals().degenerate, 0U) << f;
    }
}

using Place = std::array<double, 3>;
using Side = std::pair<Place, Place>;

Place place(const glm::dvec3& p) {
    return {p.x, p.y, p.z};
}

Side side_between(const Place& a, const Place& b) {
    return {std::min(a, b), std::max(a, b)};
}

/// The contours by looking at every triangle as it stands, with a map of places: an edge of two
/// faces or more, all on one side of the plane through the eye.
std::set<Side> contours_of(const scene::Scene& scene, const glm::dvec3& eye) {
    std::map<Side, std::vector<int>> sides;
    std::set<std::array<Place, 3>> seen;
    const scene::Instance& knight = scene.instances.at(0);
    const scene::Mesh& mesh = scene.meshes.at(knight.mesh);
    for (const scene::Triangle& t : mesh.triangles) {
        std::array<glm::dvec3, 3> p;
        for (std::size_t i = 0; i < 3; ++i)
            p[i] = scene::to_world(knight, mesh.positions[t[i]]);
        const glm::dvec3 normal = glm::cross(p[1] - p[0], p[2] - p[0]);
        std::array<Place, 3> places{place(p[0]), place(p[1]), place(p[2])};
        std::sort(places.begin(), places.end());
        if (glm::length(normal) < 1e-9 || !seen.insert(places).second) continue;
        const int facing = glm::dot(normal, eye - p[0]) > 0 ? 1 : -1;
        for (std::size_t i = 0; i < 3; ++i) {
            const Place a = place(p[i]), b = place(p[(i + 1) % 3]);
            sides[side_between(a, b)].push_back(a < b ? facing : -facing);
        }
    }
    std::set<Side> contours;
    for (const auto& [side, faces] : sides) {
        const bool is_one_sided = std::count(faces.begin(), faces.end(), faces.front()) ==
                                  static_cast<std::ptrdiff_t>(faces.size());
        if (faces.size() > 1 && is_one_sided) contours.insert(side);
    }
    return contours;
}

TEST_F(KnightFrames, ContoursFollowTheEyeFromFrameToFrame) {
    SoupModels models({.epsilon = 0, .most_frames = kFrames, .crease_rad = 0.7});
    models.prepare(frame(0));
    const scene::Sphere bounds = scene::bounding_sphere(frame(0));
    std::set<Side> before;
    for (std::size_t f = 0; f < kFrames; ++f) {
        const scene::Scene& knight = frame(f);
        models.pose(knight);
        const double turn_rad = 0.0648 * static_cast<double>(f) + 0.0123;  // once about in all
        const glm::dvec3 eye =
            bounds.center_world +
            2.1 * bounds.radius * glm::dvec3(std::sin(turn_rad), 0.31, std::cos(turn_rad));
        std::set<Side> found;
        for (const buffers::KnownEdge& edge : models.lines(eye)) {
            if (edge.kind != buffers::EdgeKind::contour) continue;
            found.insert(side_between(place(edge.a_world), place(edge.b_world)));
        }
        EXPECT_EQ(found, contours_of(knight, eye)) << f;
        EXPECT_GT(found.size(), 100U) << f;
        EXPECT_NE(found, before) << f;
        before = std::move(found);
    }
}

TEST_F(KnightFrames, ContoursFollowAnEyeThatMovesRoundOneFrame) {
    SoupModels models({.epsilon = 0, .most_frames = 1, .crease_rad = 0.7});
    const scene::Scene& knight = frame(40);
    models.prepare(knight);
    models.pose(knight);
    const scene::Sphere bounds = scene::bounding_sphere(knight);
    for (int step = 0; step < 60; ++step) {
        const double turn_rad = 0.105 * step + 0.0123;
        const glm::dvec3 eye =
            bounds.center_world +
            1.7 * bounds.radius * glm::dvec3(std::sin(turn_rad), 0.47, std::cos(turn_rad));
        std::set<Side> found;
        for (const buffers::KnownEdge& edge : models.lines(eye)) {
            if (edge.kind == buffers::EdgeKind::contour)
                found.insert(side_between(place(edge.a_world), place(edge.b_world)));
        }
        EXPECT_EQ(found, contours_of(knight, eye)) << step;
    }
    EXPECT_EQ(models.cache_counts().built, 1U);
}

}  // namespace
}  // namespace ink::methods
