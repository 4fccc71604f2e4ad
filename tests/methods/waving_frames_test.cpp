// edge_hash over a whole animation of loose polygons: a sheet that waves, as models of stored
// frames do.

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/geometric.hpp>
#include <map>
#include <memory>
#include <numbers>
#include <set>

#include "methods/edge_hash/edge_hash.h"
#include "scene/animation.h"

namespace ink::methods {
namespace {

constexpr std::size_t kFrames = 97;
constexpr std::uint32_t kSide = 16;  ///< squares

/// Frames in which the sheet's corner is folded onto the two triangles beside it.
const std::set<std::size_t> kFolded = {1, 2, 7};

/// A sheet of squares of two triangles each, every triangle with corners of its own.
scene::Scene waving_sheet() {
    const auto place = [](std::uint32_t x, std::uint32_t y, std::size_t frame) {
        if (kFolded.contains(frame) && x == kSide && y == 0) ++y, --x;
        const auto turn = static_cast<double>(frame) * 2 * std::numbers::pi / kFrames;
        return glm::vec3(x, 3 * std::sin(0.9 * x + turn) * std::cos(0.7 * y - turn), y);
    };
    scene::Scene scene;
    scene.name = "sheet";
    scene::Mesh& mesh = scene.meshes.emplace_back();
    scene::VertexFrames frames;
    frames.frame_count = kFrames;
    for (std::size_t f = 0; f < kFrames; ++f) {
        for (std::uint32_t square = 0; square < kSide * kSide; ++square) {
            const std::uint32_t x = square % kSide, y = square / kSide;
            const glm::vec3 a = place(x, y, f), b = place(x + 1, y, f), c = place(x + 1, y + 1, f),
                            d = place(x, y + 1, f);
            frames.positions.insert(frames.positions.end(), {a, c, b, a, d, c});
        }
    }
    mesh.positions.assign(frames.positions.begin(), frames.positions.begin() + 6 * kSide * kSide);
    for (std::uint32_t t = 0; t < 2 * kSide * kSide; ++t)
        mesh.triangles.push_back({3 * t, 3 * t + 1, 3 * t + 2});
    scene.instances.push_back({0, glm::dmat4(1), "sheet"});
    auto animation = std::make_shared<scene::Animation>();
    animation->frames_per_s = 10;
    animation->duration_s = (kFrames - 1) / 10.0;
    animation->node_of_instance = {scene::kNoNode};
    animation->vertex_frames = {std::move(frames)};
    scene.animation = animation;
    scene::check_animation(scene, *animation);
    return scene;
}

class WavingFrames : public testing::Test {
  protected:
    /// The sheet as it is in a frame.
    const scene::Scene& frame(std::size_t number) {
        scene::pose_scene(sheet_, sheet_.animation->frame_time_s(number));
        return sheet_;
    }

  private:
    scene::Scene sheet_ = waving_sheet();
};

TEST_F(WavingFrames, TheSecondRoundIsAllInTheCache) {
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

TEST_F(WavingFrames, TooSmallACacheBuildsEveryFrameAgain) {
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

TEST_F(WavingFrames, BoundaryEdgesStayThoseOfTheModel) {
    // Folded, the corner's triangle lies on its neighbour and is left out: of its two open sides
    // one goes, and the side between the two stays open.
    SoupModels models({.epsilon = 1e-5, .most_frames = kFrames});
    models.prepare(frame(0));
    for (std::size_t f = 0; f < kFrames; ++f) {
        models.pose(frame(f));
        const bool is_folded = kFolded.contains(f);
        const auto lines = models.lines({{0, 0, 0}});
        EXPECT_EQ(std::ranges::count(lines, buffers::EdgeKind::boundary, &buffers::KnownEdge::kind),
                  4 * kSide - (is_folded ? 1 : 0))
            << f;
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
    const scene::Instance& sheet = scene.instances.at(0);
    const scene::Mesh& mesh = scene.meshes.at(sheet.mesh);
    for (const scene::Triangle& t : mesh.triangles) {
        std::array<glm::dvec3, 3> p;
        for (std::size_t i = 0; i < 3; ++i)
            p[i] = scene::to_world(sheet, mesh.positions[t[i]]);
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

std::set<Side> listed_contours(const SoupModels& models, const glm::dvec3& eye) {
    std::set<Side> found;
    for (const buffers::KnownEdge& edge : models.lines({eye})) {
        if (edge.kind == buffers::EdgeKind::contour)
            found.insert(side_between(place(edge.a_world), place(edge.b_world)));
    }
    return found;
}

TEST_F(WavingFrames, ContoursFollowTheEyeFromFrameToFrame) {
    SoupModels models({.epsilon = 0, .most_frames = kFrames, .crease_rad = 0.7});
    models.prepare(frame(0));
    const scene::Sphere bounds = scene::bounding_sphere(frame(0));
    std::set<Side> before;
    for (std::size_t f = 0; f < kFrames; ++f) {
        const scene::Scene& sheet = frame(f);
        models.pose(sheet);
        const double turn_rad = 0.0648 * static_cast<double>(f) + 0.0123;  // once about in all
        const glm::dvec3 eye =
            bounds.center_world +
            2.1 * bounds.radius * glm::dvec3(std::sin(turn_rad), 0.31, std::cos(turn_rad));
        std::set<Side> found = listed_contours(models, eye);
        EXPECT_EQ(found, contours_of(sheet, eye)) << f;
        EXPECT_GT(found.size(), 100U) << f;
        EXPECT_NE(found, before) << f;
        before = std::move(found);
    }
}

}  // namespace
}  // namespace ink::methods
