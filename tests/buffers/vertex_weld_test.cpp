#include "buffers/vertex_weld.h"

#include <gtest/gtest.h>

namespace ink::buffers {
namespace {

using Places = std::vector<std::uint32_t>;

TEST(VertexWeld, WithoutToleranceOnlyEqualPositionsAreOnePlace) {
    const std::vector<glm::dvec3> points{{0, 0, 0}, {1, 0, 0}, {-0.0, 0, 0}, {1, 1e-15, 0}};
    const VertexWeld weld = weld_vertices(points, 0);
    EXPECT_EQ(weld.place_of, (Places{0, 1, 0, 2}));
    EXPECT_EQ(weld.first_of, (Places{0, 1, 3}));
}

TEST(VertexWeld, ADistanceJoinsAcrossTheBordersOfItsGridAndNoFarther) {
    // 0.5 apart on every side of a corner of cubes of side 1; the last is 1.25 away from all.
    const std::vector<glm::dvec3> points{
        {3, -2, 5}, {2.5, -2, 5}, {3, -2.5, 5}, {3, -2, 4.5}, {3.5, -2, 5}, {4.25, -2, 5}};
    EXPECT_EQ(weld_vertices(points, 1).place_of, (Places{0, 0, 0, 0, 0, 1}));
    EXPECT_EQ(weld_vertices(points, 0.25).first_of.size(), 6U);
}

TEST(VertexWeld, JoinsTheFirstPlaceInReachAndNotChains) {
    const std::vector<glm::dvec3> points{{0, 0, 0}, {0.75, 0, 0}, {1.5, 0, 0}};
    EXPECT_EQ(weld_vertices(points, 1).place_of, (Places{0, 0, 1}));
}

TEST(VertexWeld, HugeCoordinatesAndNoneAtAllAreWeldedToo) {
    const std::vector<glm::dvec3> points{{1e30, 0, 0}, {1e30, 0, 0}, {-1e30, 0, 0}};
    EXPECT_EQ(weld_vertices(points, 1e-30).place_of, (Places{0, 0, 1}));
    EXPECT_TRUE(weld_vertices({}, 1).first_of.empty());
}

TEST(WeldFaces, DropsWhatHasNoAreaAndOnRequestWhatIsThereTwice) {
    const std::vector<glm::dvec3> points{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {2, 0, 0}, {1, 0, 0}};
    const std::vector<scene::Triangle> triangles{{0, 1, 2},   // stays
                                                 {2, 0, 4},   // the same, welded
                                                 {0, 2, 1},   // the same, turned over
                                                 {0, 1, 3},   // collinear
                                                 {0, 1, 4}};  // two corners in one place
    const VertexWeld weld = weld_vertices(points, 0);
    const WeldedFaces kept = weld_faces(weld, points, triangles, DoubleFaces::keep);
    EXPECT_EQ(kept.triangle_of, (Places{0, 1, 2}));
    EXPECT_EQ(kept.degenerate, 2U);
    EXPECT_EQ(kept.duplicate, 0U);
    const WeldedFaces dropped = weld_faces(weld, points, triangles, DoubleFaces::drop);
    EXPECT_EQ(dropped.triangle_of, (Places{0}));
    EXPECT_EQ(dropped.degenerate, 2U);
    EXPECT_EQ(dropped.duplicate, 2U);
}

}  // namespace
}  // namespace ink::buffers
