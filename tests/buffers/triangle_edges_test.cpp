#include "buffers/filled_lines.h"

#include <gtest/gtest.h>

#include "tests/methods/small_scenes.h"

namespace ink::buffers {
namespace {

/// Two triangles over the square 0..1 in y = 0; the corner at (1, `height`, 1) is one's alone.
scene::Scene sheet(float height) {
    scene::Mesh mesh;
    mesh.positions = {{0, 0, 0}, {1, 0, 0}, {1, height, 1}, {0, 0, 1}};
    mesh.triangles = {{0, 3, 1}, {1, 3, 2}};
    return methods::scene_of({mesh});
}

std::size_t lines_after(WireEdges edges, const scene::Scene& prepared, const scene::Scene& posed) {
    TriangleEdges wire(edges);
    wire.prepare(prepared);
    wire.pose(posed);
    return wire.lines().size();
}

TEST(TriangleEdges, InnerEdgesArePolygonsOfThePoseThatIsDrawn) {
    const scene::Scene flat = sheet(0), bent = sheet(0.5F);
    EXPECT_EQ(lines_after(WireEdges::polygons, flat, flat), 4U);
    EXPECT_EQ(lines_after(WireEdges::polygons, flat, bent), 5U) << "it folded at its diagonal";
    EXPECT_EQ(lines_after(WireEdges::polygons, bent, flat), 4U) << "it unfolded";
    EXPECT_EQ(lines_after(WireEdges::all, flat, bent), 5U);
    EXPECT_EQ(lines_after(WireEdges::all, bent, flat), 5U);
}

TEST(TriangleEdges, BackAtAPoseTheyAreAsBefore) {
    TriangleEdges wire(WireEdges::polygons);
    wire.prepare(sheet(0));
    wire.pose(sheet(0.5F));
    wire.pose(sheet(0));
    EXPECT_EQ(wire.lines().size(), 4U);
}

}  // namespace
}  // namespace ink::buffers
