#include "methods/edge_hash/soup_edges.h"

#include <gtest/gtest.h>

#include <array>
#include <map>
#include <utility>

#include "catalogue/catalogue.h"
#include "catalogue/shapes.h"
#include "import/import.h"
#include "methods/edge_hash/soup_models.h"
#include "tests/models/fetched_model.h"
#include "tests/scene/small_meshes.h"

namespace ink::methods {
namespace {

SoupEdges found(const scene::Mesh& mesh, double epsilon = 0) {
    const std::vector<glm::dvec3> points(mesh.positions.begin(), mesh.positions.end());
    return find_edges({points, mesh.triangles}, epsilon);
}

TEST(SoupEdges, ClosedFormsComeTogetherFromLooseTriangles) {
    const SoupEdges cube = found(scene::exploded(scene::unit_cube()));
    EXPECT_EQ(cube.counts.places, 8U);
    EXPECT_EQ(cube.counts.edges, 18U);
    EXPECT_EQ(cube.counts.boundary, 0U);
    const SoupEdges ball = found(scene::exploded(catalogue::make_icosphere(1, 2)));
    EXPECT_EQ(ball.counts.places, 10U * 16 + 2);
    EXPECT_EQ(ball.counts.edges, 30U * 16);
    EXPECT_EQ(ball.counts.boundary + ball.counts.non_manifold, 0U);
}

TEST(SoupEdges, EachFaceStandsAtItsEdgesWithTheWayItRuns) {
    const SoupEdges soup = found(scene::unit_cube());
    for (const SoupEdge& edge : soup.edges) {
        ASSERT_EQ(edge.count, 2U);
        const auto faces = soup.faces_of(edge);
        EXPECT_EQ(faces[0].direction + faces[1].direction, 0);  // consistently oriented
        for (const EdgeFace& face : faces) {
            const scene::Triangle& corners = soup.faces[face.face];
            for (std::size_t i = 0; i < 3; ++i) {
                if (corners[i] != face.opposite) continue;
                const bool runs_forward = corners[(i + 1) % 3] == edge.a;
                EXPECT_EQ(corners[runs_forward ? (i + 2) % 3 : (i + 1) % 3], edge.b);
                EXPECT_EQ(face.direction, runs_forward ? 1 : -1);
            }
        }
    }
}

TEST(SoupEdges, CopesWithDoubleAndDegenerateFacesAndWithFins) {
    scene::Mesh mesh;
    mesh.positions = {{0, 0, -1}, {0, 0, 1}, {-1, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 3}};
    mesh.triangles = {{0, 1, 2}, {1, 0, 3}, {0, 1, 4}, {1, 0, 4}, {0, 1, 5}, {2, 2, 3}};
    const SoupCounts counts = found(mesh).counts;
    EXPECT_EQ(counts.triangles, 6U);
    EXPECT_EQ(counts.duplicate, 1U);
    EXPECT_EQ(counts.degenerate, 2U);
    EXPECT_EQ(counts.edges, 7U);
    EXPECT_EQ(counts.boundary, 6U);
    EXPECT_EQ(counts.non_manifold, 1U);
    EXPECT_EQ(found({}).counts.edges, 0U);
}

TEST(SoupEdges, TheToleranceClosesCracks) {
    // A torus of 64 x 32 quads, its triangles apart by millionths.
    const scene::Scene scene = catalogue::make_catalogue_scene("soup");
    const scene::Mesh& ring = scene.meshes[scene.instances[0].mesh];
    ASSERT_EQ(ring.triangles.size(), 2U * 64 * 32);
    EXPECT_GT(found(ring, 0).counts.boundary, 12000U);  // of 12288 sides
    const SoupCounts closed = found(ring, 1e-5).counts;
    EXPECT_EQ(closed.places, 64U * 32);
    EXPECT_EQ(closed.edges, 3U * 64 * 32);
    EXPECT_EQ(closed.boundary, 0U);
    EXPECT_EQ(closed.degenerate, 0U);
}

/// Edges of one face by the file's own indices, without any weld.
std::size_t boundary_by_index(const scene::Mesh& mesh) {
    std::map<std::pair<std::uint32_t, std::uint32_t>, int> faces;
    for (const scene::Triangle& t : mesh.triangles) {
        for (std::size_t i = 0; i < 3; ++i)
            ++faces[std::minmax(t[i], t[(i + 1) % 3])];
    }
    std::size_t boundary = 0;
    for (const auto& [edge, count] : faces)
        boundary += count == 1;
    return boundary;
}

/// Boundary edges of all models of a file: as it is indexed, welded exactly, welded within an
/// epsilon, and the last again with all of its parts as one model.
std::array<std::size_t, 4> boundary_edges(const scene::Scene& scene, double epsilon) {
    std::array<std::size_t, 4> boundary{};
    for (const scene::Mesh& mesh : scene.meshes) {
        boundary[0] += boundary_by_index(mesh);
        boundary[1] += found(mesh, 0).counts.boundary;
        boundary[2] += found(mesh, epsilon).counts.boundary;
    }
    SoupModels whole({.scope = ModelScope::scene, .epsilon = epsilon});
    whole.prepare(scene);
    whole.pose(scene);
    boundary[3] = whole.totals().boundary;
    return boundary;
}

// Counted from the files' bytes by a few lines of Python.

TEST(SoupEdges, OfAPlayerAndOfLooseTrianglesComeToThis) {
    // 1764 triangles, split along the seams of the skin, in three parts that touch; and 1368.
    const std::pair<const char*, std::array<std::size_t, 4>> known[] = {
        {"penguin.obj", {418, 32, 32, 32}}, {"spider.stl", {3 * 1368, 72, 72, 72}}};
    for (const auto& [file, boundary] : known) {
        const auto path = fetched_model(file);
        INK_SKIP_WITHOUT(path);
        EXPECT_EQ(boundary_edges(import::import_scene(path), 0), boundary);
    }
}

}  // namespace
}  // namespace ink::methods
