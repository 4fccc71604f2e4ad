#include <cmath>

#include "scene/catalogue_scenes.h"
#include "scene/catalogue_stage.h"
#include "scene/shapes.h"

namespace ink::scene {
namespace {

Mesh limb(std::initializer_list<TubeNode> nodes, int cuts, int segments) {
    return make_tube(smoothed(std::span(nodes.begin(), nodes.size()), cuts), segments);
}

/// A branch along +x that starts 0.5 behind the origin, so that it comes out of the trunk's far
/// side.
Mesh branch(double length, double rise) {
    const auto at = [&](double share, double sway) {
        return glm::dvec3(-0.5 + (length + 0.5) * share, rise * share * share - 0.15, sway);
    };
    Mesh whole = make_tube(smoothed(std::vector<TubeNode>{{at(0, 0), 0.1},
                                                          {at(0.3, 0.05), 0.11},
                                                          {at(0.6, -0.06), 0.075},
                                                          {at(1, 0.02), 0.025}},
                                    6),
                           12);
    for (const double side : {-1.0, 1.0}) {
        const double share = 0.62 + 0.1 * side;
        const glm::dvec3 from = at(share, -0.04);
        append(whole,
               make_tube(
                   smoothed(std::vector<TubeNode>{{from - glm::dvec3(0.08, 0.05, 0.1 * side), 0.04},
                                                  {from + glm::dvec3(0.25, 0.3, 0.25 * side), 0.03},
                                                  {from + glm::dvec3(0.4, 0.7, 0.4 * side), 0.012}},
                            5),
                   8));
    }
    return whole;
}

}  // namespace

Scene make_figure_scene() {
    Stage stage;
    const auto ball = stage.mesh("ball", make_sphere(1, 32, 16));
    const auto place_ball = [&](const char* name, const glm::dvec3& at, const glm::dvec3& radii) {
        stage.place(ball, name, Pose{at, {}, radii});
    };
    place_ball("chest", {0, 1.24, 0}, {0.24, 0.26, 0.15});
    place_ball("hips", {0, 0.92, 0}, {0.2, 0.19, 0.14});
    place_ball("head", {0, 1.72, 0.02}, {0.125, 0.16, 0.14});
    stage.add("neck", limb({{{0, 1.4, 0}, 0.07}, {{0, 1.62, 0}, 0.065}}, 2, 20));
    stage.add("nose", make_cone(0.035, 0.1, 12), {{0, 1.7, 0.145}, {80, 0, 0}});
    const glm::dvec2 hat[] = {
        {0, 0}, {.26, -.02}, {.27, 0}, {.14, .035}, {.12, .2}, {.1, .22}, {0, .23}};
    stage.add("hat", revolve(hat, 40), {{0, 1.8, 0.01}, {-8, 0, 0}});

    const auto arm = stage.mesh("arm",
                                limb({{{0.16, 1.38, 0}, 0.07},
                                      {{0.27, 1.34, -0.01}, 0.075},
                                      {{0.5, 1.1, -0.06}, 0.055},
                                      {{0.3, 0.98, 0.07}, 0.04},
                                      {{0.2, 0.97, 0.09}, 0.035}},
                                     8,
                                     20));
    const auto leg = stage.mesh(
        "leg",
        limb(
            {{{0.09, 0.9, 0}, 0.11}, {{0.12, 0.5, 0.03}, 0.075}, {{0.14, 0.06, 0}, 0.05}}, 10, 24));
    for (const double side : {1.0, -1.0}) {
        const glm::dvec3 mirror{side, 1, 1};
        stage.place(arm, "arm", Pose{{}, {}, mirror});
        stage.place(leg, "leg", Pose{{}, {}, mirror});
        // The hand rests half inside the hip.
        stage.place(ball, "hand", Pose{{0.17 * side, 0.97, 0.1}, {}, {side * 0.07, 0.045, 0.05}});
        stage.place(ball, "foot", Pose{{0.15 * side, 0.045, 0.06}, {}, {side * 0.06, 0.045, 0.14}});
    }
    stage.view(Shot{"front", 0, 0});
    stage.view(Shot{"three_quarter", 32, 14});
    stage.view(EyeShot{"close", {0.9375, 1.625, 1.4375}, {0, 1.25, 0}, 36});
    return stage.finish();
}

Scene make_tree_scene() {
    Stage stage;
    stage.add("trunk",
              limb({{{0, 0, 0}, 0.5},
                    {{0.02, 0.5, 0}, 0.3},
                    {{0.1, 1.5, 0.05}, 0.25},
                    {{-0.05, 2.8, -0.05}, 0.19},
                    {{0.1, 4, 0}, 0.11},
                    {{0.05, 5, 0.08}, 0.03}},
                   8,
                   24));
    const std::uint32_t meshes[] = {stage.mesh("long", branch(2.2, 0.9)),
                                    stage.mesh("middle", branch(1.7, 1)),
                                    stage.mesh("short", branch(1.1, 0.8))};
    for (int i = 0; i < 15; ++i) {
        const Pose pose{{0.02, 1.5 + 0.2 * i, 0}, {0, 137.508 * i, 10.0 - 1.5 * (i % 4)}};
        stage.place(meshes[i / 5], "branch", pose);
    }
    for (int i = 0; i < 6; ++i) {
        stage.add(
            "root",
            limb({{{0, 0.35, 0}, 0.16}, {{0.45, 0.12, 0.03}, 0.11}, {{0.95, -0.02, -0.04}, 0.03}},
                 5,
                 10),
            {{}, {0, 60.0 * i + 11, 0}});
    }
    stage.view(Shot{"front", 0, 2});
    stage.view(Shot{"three_quarter", 40, 20});
    stage.view(EyeShot{"trunk", {1.75, 1.125, 3.25}, {0, 2, 0}, 50});
    return stage.finish();
}

}  // namespace ink::scene
