#include "report/live_page.h"

#include <gtest/gtest.h>

#include "bake/coded_mesh.h"
#include "catalogue/shapes.h"
#include "tests/scene/small_meshes.h"

namespace ink::report {
namespace {

bake::CodedMesh coded(scene::Mesh mesh) {
    return bake::coded_mesh(scene::PreparedScene(scene::scene_of({std::move(mesh)})));
}

TEST(PackedMesh, OfALargeModelTakesFewBytesATriangle) {
    const bake::CodedMesh mesh = coded(catalogue::make_icosphere(1, 7));
    ASSERT_GT(mesh.triangle_count(), 200'000U);
    // As plain numbers 72: a page with a million triangles is to stay below 20 MB, of base64.
    EXPECT_LT(packed_mesh(mesh, {}).bytes.size(), 12 * mesh.triangle_count());
}

TEST(PackedMesh, OfAPoseLikeTheOneBeforeTakesNothing) {
    const bake::CodedMesh mesh = coded(catalogue::make_icosphere(1, 5));
    const std::size_t at_rest = packed_mesh(mesh, {}).bytes.size();
    const std::vector<bake::MovingVertices> still(20, mesh);
    EXPECT_LT(packed_mesh(mesh, still).bytes.size(), at_rest + at_rest / 20);
}

TEST(PackedMesh, VerticesAtNoPointHavePlacesOfTheirOwn) {
    scene::Mesh mesh = scene::unit_cube();
    const bake::CodedMesh whole = coded(mesh);
    EXPECT_EQ(packed_mesh(whole, {}).place_count, whole.lookup.p_world.size());
    const auto first = static_cast<std::uint32_t>(mesh.positions.size());
    mesh.positions.insert(mesh.positions.end(), {{5, 0, 0}, {6, 0, 0}, {7, 0, 0}});
    mesh.triangles.push_back({first, first + 1, first + 2});  // no surface
    const bake::CodedMesh more = coded(mesh);
    EXPECT_GE(packed_mesh(more, {}).place_count, more.lookup.p_world.size());
    EXPECT_GE(packed_mesh(more, {}).place_count, whole.lookup.p_world.size() + 3);
}

}  // namespace
}  // namespace ink::report
