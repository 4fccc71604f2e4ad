#include "catalogue/catalogue_stage.h"
#include "catalogue/shapes.h"

namespace ink::catalogue {
namespace {

/// A ring of eight points `halves` half steps back from +x.
Ring octagon(double radius, double height, int halves = 0) {
    const Ring circle = unit_circle(16);
    Ring ring;
    for (int i = 0; i < 8; ++i) {
        ring.push_back(circle[(2 * i - halves + 16) % 16] * radius + glm::dvec3(0, height, 0));
    }
    return ring;
}

/// A round cut: its facets bend by less than a crease on the crown, by more below.
scene::Mesh brilliant() {
    const Ring rings[] = {{{0, -1.125, 0}},
                          octagon(1, -0.0625),
                          octagon(1, 0.0625),
                          octagon(0.8, 0.3125, 1),
                          octagon(0.5, 0.4375, 2),
                          {{0, 0.4375, 0}}};
    return loft(rings);
}

/// A step cut: rectangles with their corners cut off, every edge of it a crease.
scene::Mesh emerald() {
    const auto step = [](double size, double height) {
        Ring ring;
        for (const auto& [x, z] : {std::pair{1.0, 0.4},
                                   {1.0, -0.4},
                                   {0.75, -0.65},
                                   {-0.75, -0.65},
                                   {-1.0, -0.4},
                                   {-1.0, 0.4},
                                   {-0.75, 0.65},
                                   {0.75, 0.65}}) {
            ring.emplace_back(x * size, height, z * size);
        }
        return ring;
    };
    const Ring rings[] = {{{0, -0.875, 0}},
                          step(0.7, -0.5),
                          step(1, -0.0625),
                          step(1, 0.0625),
                          step(0.65, 0.375),
                          {{0, 0.375, 0}}};
    return loft(rings);
}

/// A six-sided crystal, foot in the origin, `height` to where its tip begins.
scene::Mesh crystal(double radius, double height) {
    const glm::dvec2 profile[] = {
        {0, 0}, {radius * 0.75, 0}, {radius, height}, {0, height + 1.5 * radius}};
    return revolve(profile, 6);
}

}  // namespace

scene::Scene make_sphere_scene() {
    Stage stage;
    stage.add("sphere", make_sphere(1, 64, 32));
    // Far from the axis of a wide lens the outline is an ellipse.
    return stage.finish({{"front", 8, 0}, {"three_quarter", 35, 25}},
                        {{"corner", {0, 0, 2.5}, {-1.375, -0.375, 0}, 80}});
}

scene::Scene make_globe_scene() {
    Stage stage;
    stage.add("globe", make_sphere(1, 1024, 490), {{0, 0, 0}, {23.5, 0, 0}});
    return stage.finish({{"front", 0, 0}, {"three_quarter", 35, 40}});
}

scene::Scene make_balls_scene() {
    Stage stage;
    const auto ball = stage.mesh("ball", make_icosphere(1, 3));
    // Three layers of a pile whose balls keep 1/16 of air between them.
    constexpr double kStep = 2.0625;
    for (int layer = 0; layer < 3; ++layer) {
        const int side = 3 - layer;
        const double first = -0.5 * kStep * (side - 1);
        for (int i = 0; i < side * side; ++i) {
            const glm::dvec3 at{
                first + kStep * (i % side), 1.46 * layer, first + kStep * (i / side)};
            stage.place(ball, "ball", Pose{at, {10.0 * i, 25.0 * i, 0}});
        }
    }
    return stage.finish({{"front", 12, 8}, {"three_quarter", 38, 28}},
                        {{"close", {3.25, 3, 4.25}, {0, 1.125, 0}, 38}});
}

scene::Scene make_torus_scene() {
    Stage stage;
    stage.add("torus", make_torus({1, 0.4}, {96, 40}));
    // As low as this, the contours of the hole end inside the surface.
    return stage.finish({{"front", 20, 16}, {"three_quarter", 35, 34}, {"above", 50, 66}});
}

scene::Scene make_cube_scene() {
    Stage stage;
    const auto cube = stage.mesh("cube", make_box({-0.75, -0.75, -0.75}, {0.75, 0.75, 0.75}));
    stage.place(cube, "on_its_edge", Pose{{-2.5, 0, 0}, {0, 30, 45}});
    stage.place(cube, "on_its_face", Pose{{0, 0, 0}});
    stage.place(cube, "on_its_corner", Pose{{2.5, 0, 0}, {35.264, 0, 45}});
    return stage.finish({{"front", 0, 0}, {"three_quarter", 32, 24}, {"grazing", 0.5, 28, 20}});
}

scene::Scene make_cylinder_scene() {
    Stage stage;
    stage.add("upright", make_cylinder(0.7, 2, 64), {{0, -1, 0}});
    stage.add("lying", make_cylinder(0.55, 2.5, 48), {{1, -0.45, 1.6}, {0, 35, 90}});
    stage.add("hexagonal", make_cylinder(0.7, 1.6, 6), {{-2, -1, 0.2}, {0, 14, 0}});
    const glm::dvec2 washer[] = {{0.5, 0}, {0.9, 0}, {0.9, 0.5}, {0.5, 0.5}, {0.5, 0}};
    stage.add("washer", revolve(washer, 56), {{2.1, -0.6, -0.3}, {62, -20, 0}});
    return stage.finish({{"front", 0, 6}, {"three_quarter", 24, 26}, {"grazing", -38, 54}});
}

scene::Scene make_cone_scene() {
    Stage stage;
    stage.add("round", make_cone(0.8, 2, 64), {{0, -1, 0}});
    stage.add("pyramid", make_cone(0.95, 1.5, 4), {{-2, -1, 0.4}, {0, 20, 0}});
    stage.add("lying", make_cone(0.6, 2.2, 32), {{1.9, -0.5, 1.1}, {0, 60, 100}});
    const glm::dvec2 frustum[] = {{0, 0}, {0.8, 0}, {0.4, 1.2}, {0, 1.2}};
    stage.add("frustum", revolve(frustum, 24), {{2, -1, -0.6}});
    // From above the tips: the whole mantle is seen, and its contour is the base alone.
    return stage.finish({{"front", 0, 4}, {"three_quarter", 28, 24}, {"above", -20, 68}});
}

scene::Scene make_blocks_scene() {
    Stage stage;
    stage.add("block", make_box({-1, -1, -1}, {1, 1, 1}), {{0, 0, 0}, {8, 21, 3}});
    stage.add("bar",
              make_box({-2.25, -0.25, -0.25}, {2.25, 0.25, 0.25}),
              {{0.1, -0.35, 0.2}, {12, -17, 9}});
    stage.add(
        "post", make_box({-0.3, -1.75, -0.3}, {0.3, 1.75, 0.3}), {{-0.5, 0.2, 0.6}, {-9, 33, -14}});
    stage.add(
        "corner", make_box({-0.6, -0.6, -0.6}, {0.6, 0.6, 0.6}), {{0.85, 0.8, 0.75}, {33, 41, 12}});
    stage.add("wedge", make_cylinder(0.55, 3.5, 3), {{1.6, 1.1, -1.4}, {52, 27, 61}});
    return stage.finish({{"front", 0, 8}, {"three_quarter", 36, 26}, {"behind", 205, -14}});
}

scene::Scene make_gem_scene() {
    Stage stage;
    stage.add("brilliant", brilliant(), {{0, 0, 0}, {14, 9, 0}, {1.2, 1.2, 1.2}});
    stage.add("emerald", emerald(), {{-2.4, 0, 0.3}, {22, 24, 0}, {1.1, 1.1, 1.1}});
    stage.add("icosahedron", make_icosphere(0.9, 0), {{2.3, -0.1, 0.2}, {10, 18, 4}});
    return stage.finish({{"front", 0, 6}, {"three_quarter", 30, 38}, {"below", -18, -32}});
}

scene::Scene make_crystals_scene() {
    Stage stage;
    stage.add("rock", make_icosphere(1, 1), {{0, -0.15, 0}, {5, 12, 3}, {1.25, 0.45, 1}});
    const std::uint32_t meshes[] = {stage.mesh("thick", crystal(0.34, 1.5)),
                                    stage.mesh("slim", crystal(0.2, 1.75)),
                                    stage.mesh("short", crystal(0.26, 0.9))};
    for (int i = 0; i < 14; ++i) {
        // Neighbours on the golden angle lean ever further out and cross on the way.
        const double lean_deg = 4 + 4.5 * i;
        const Pose pose{{0.05, -0.2, 0.03}, {lean_deg, 137.508 * i + 20, 7.0 * i}};
        stage.place(meshes[i % 3], "crystal", pose);
    }
    return stage.finish({{"front", 0, 12}, {"three_quarter", 48, 30}, {"above", 20, 64}});
}

}  // namespace ink::catalogue
