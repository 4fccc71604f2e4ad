// The near plane cuts the walls of a room in which the eye stands. The cut is no line.

#include <gtest/gtest.h>

#include <glm/gtc/matrix_transform.hpp>

#include "catalogue/shapes.h"
#include "tests/methods/small_scenes.h"
#include "tests/methods/two_px.h"
#include "truth/truth.h"

namespace ink::methods {
namespace {

/// Walls, floor and ceiling round a table, a pillar and a shelf; nothing is smooth, or a ring hangs
/// in it.
scene::Scene room(bool has_ring) {
    std::vector<scene::Mesh> meshes(5, cube_mesh());
    if (has_ring) meshes.push_back(catalogue::make_torus({1, 0.25}, {48, 24}));
    scene::Scene scene = scene_of(meshes);
    const auto place = [&](std::size_t i, const glm::dvec3& at, const glm::dvec3& half_size) {
        scene.instances[i].world_from_object =
            glm::scale(glm::translate(glm::dmat4(1), at), half_size);
    };
    place(0, {0, 0, 0}, {6, 3, 5});
    place(1, {1, -1, -1}, {1.5, 0.125, 1});
    place(2, {-3, 0, 2}, {0.25, 2.5, 0.25});
    place(3, {5, 1, 0.5}, {0.5, 0.25, 3});
    place(4, {1, -0.5, -1}, {0.25, 0.25, 0.25});
    if (has_ring) place(5, {-2, 0.5, -2}, {1, 1, 1});
    return scene;
}

TEST(NearCut, IsNoLineWhereLinesAreLookedUp) {
    struct Eye {
        glm::dvec3 at, target;
    };
    for (const bool has_ring : {true, false}) {
        const scene::Scene scene = room(has_ring);
        for (const scene::ProjectionKind projection :
             {scene::ProjectionKind::perspective, scene::ProjectionKind::parallel}) {
            int cuts = 0;
            // At the table, at the pillar, on the shelf, and away from all of them.
            for (const Eye& eye : {Eye{{1, -0.7, 0}, {1.3, -0.75, -4}},
                                   {{-2.6, -0.5, 1.2}, {-3.2, -0.4, 3}},
                                   {{4.9, 1.4, 0}, {5, 1.2, 4}},
                                   {{4, 1, 0}, {-4, 0.5, 1}}}) {
                scene::View view = view_from(scene, eye.at, eye.target, {320, 240}, projection);
                view.camera.near = 1;
                if (view.camera.is_parallel()) view.camera.height_world = 9;
                const auto truth = truth::trace_truth(scene, view, {});
                const auto f = [&](const char* method) {
                    return f_within_two_px(drawn(method, {}, scene, {view, 1}), truth.labels);
                };
                const double exact = f("id_lookup");
                EXPECT_GT(exact, 0.98);
                EXPECT_NEAR(f("surface_lookup"), exact, 0.002);
                EXPECT_NEAR(f("auto"), exact, 0.002);
                cuts += f("surface8_depth") < exact - 0.02 ? 1 : 0;
            }
            EXPECT_GE(cuts, 3) << "codes alone draw it";
        }
    }
}

}  // namespace
}  // namespace ink::methods
