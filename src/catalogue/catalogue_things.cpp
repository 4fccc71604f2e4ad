#include <cmath>
#include <glm/geometric.hpp>
#include <glm/matrix.hpp>
#include <numbers>

#include "catalogue/catalogue_stage.h"
#include "catalogue/shapes.h"
#include "scene/animation.h"

namespace ink::catalogue {
namespace {

/// A spur gear about the y axis, from y = 0 to `width`, with a hole; module 0.2, so that gears of n
/// and m teeth run at a distance of 0.1 (n + m).
scene::Mesh spur_gear(int teeth, double hole, double width) {
    const double pitch = 0.1 * teeth;
    const double root = pitch - 0.22;
    const double tip = pitch + 0.18;
    // Where a tooth's outline bends, as shares of the way to the next tooth.
    constexpr double kPlaces[] = {-0.3, -0.12, 0.12, 0.3};
    Ring outer;
    Ring inner;
    for (int i = 0; i < 4 * teeth; ++i) {
        const double angle_rad = 2 * std::numbers::pi * (i / 4 + kPlaces[i % 4]) / teeth;
        const glm::dvec3 direction{std::cos(angle_rad), 0, -std::sin(angle_rad)};
        outer.push_back(direction * (i % 4 == 1 || i % 4 == 2 ? tip : root));
        inner.push_back(direction * hole);
    }
    const auto raised = [&](Ring ring) {
        for (auto& p : ring)
            p.y = width;
        return ring;
    };
    const Ring rings[] = {outer, raised(outer), raised(inner), inner};
    return loft(rings, {.along = true});
}

void place_bolts(Stage& stage, const glm::dmat4& world_from_gear, double circle, double height) {
    const auto bolt = stage.mesh("bolt", make_cylinder(0.13, 0.25, 6));
    for (int i = 0; i < 6; ++i) {
        const double angle_rad = std::numbers::pi * (i / 3.0 + 0.1);
        const Pose pose{{circle * std::cos(angle_rad), height - 0.1, -circle * std::sin(angle_rad)},
                        {0, 25.0 * i, 0}};
        stage.place(bolt, "bolt", world_from_gear * placed(pose));
    }
}

scene::Mesh lathe(std::initializer_list<glm::dvec2> profile) {
    return revolve(std::span(profile.begin(), profile.size()), 40);
}

scene::Mesh pawn() {
    return lathe({{0, 0},
                  {.38, 0},
                  {.4, .06},
                  {.38, .14},
                  {.3, .2},
                  {.2, .3},
                  {.14, .5},
                  {.13, .66},
                  {.24, .7},
                  {.24, .75},
                  {.14, .79},
                  {.2, .87},
                  {.22, .96},
                  {.2, 1.05},
                  {.14, 1.13},
                  {.06, 1.17},
                  {0, 1.18}});
}

scene::Mesh bishop() {
    return lathe({{0, 0},
                  {.42, 0},
                  {.44, .07},
                  {.42, .17},
                  {.32, .25},
                  {.2, .4},
                  {.15, .7},
                  {.14, 1.05},
                  {.28, 1.1},
                  {.28, 1.15},
                  {.16, 1.2},
                  {.22, 1.32},
                  {.25, 1.45},
                  {.22, 1.6},
                  {.13, 1.76},
                  {.05, 1.84},
                  {.08, 1.9},
                  {.05, 1.96},
                  {0, 1.98}});
}

scene::Mesh rook() {
    return lathe({{0, 0},
                  {.44, 0},
                  {.46, .07},
                  {.44, .18},
                  {.34, .26},
                  {.25, .4},
                  {.22, .95},
                  {.24, 1.0},
                  {.36, 1.06},
                  {.36, 1.42},
                  {.26, 1.42},
                  {.26, 1.25},
                  {0, 1.25}});
}

/// A node that turns about the y axis of `at` by `turn_rad` in `duration_s`, under a node that
/// stands at `at`.
void add_turning(const glm::dmat4& at,
                 double turn_rad,
                 double duration_s,
                 scene::Animation& animation) {
    constexpr int kSteps = 8;  // of less than half a turn each
    animation.nodes.push_back({scene::kNoNode, at, {}, {}, {}});
    scene::AnimatedNode axle;
    axle.parent = static_cast<std::uint32_t>(animation.nodes.size() - 1);
    axle.translations.push_back({0, glm::dvec3(0)});
    axle.scales.push_back({0, glm::dvec3(1)});
    for (int i = 0; i <= kSteps; ++i) {
        const double half_rad = turn_rad / 2 * i / kSteps;
        const glm::dvec3 turn = snapped({std::cos(half_rad), std::sin(half_rad), 0});
        const glm::dquat q(turn.x, 0, turn.y, 0);
        axle.rotations.push_back({duration_s * i / kSteps, q * (1 / glm::length(turn))});
    }
    animation.nodes.push_back(axle);
}

/// The wheel turns half round, the pinion by the same way along its rim the other way. At time 0
/// all is as placed, to the last bit.
void turn_gears(const glm::dmat4& wheel, const glm::dmat4& pinion, scene::Scene& scene) {
    scene::Animation animation;
    animation.duration_s = 4;
    const double turn_rad = std::numbers::pi;
    add_turning(wheel, turn_rad, animation.duration_s, animation);
    add_turning(pinion, -turn_rad * 16 / 10, animation.duration_s, animation);
    for (const scene::Instance& instance : scene.instances) {
        const bool is_on_pinion = instance.name == "pinion" || instance.name == "axle";
        const std::uint32_t node = is_on_pinion ? 3 : 1;
        const glm::dmat4& at = is_on_pinion ? pinion : wheel;
        animation.node_of_instance.push_back(static_cast<std::uint32_t>(animation.nodes.size()));
        animation.nodes.push_back(
            {node, glm::inverse(at) * instance.world_from_object, {}, {}, {}});
    }
    scene.animation = std::make_shared<const scene::Animation>(std::move(animation));
}

}  // namespace

scene::Scene make_gear_scene() {
    Stage stage;
    const glm::dmat4 wheel = placed({{-1.3, 0, 0}, {90, 0, 0}});
    const glm::dmat4 pinion_axle = placed({{1.3, 0, 0}, {90, 0, 0}});
    const glm::dmat4 pinion = pinion_axle * placed({{}, {0, 18, 0}});
    stage.add_at(wheel, "wheel", spur_gear(16, 0.4375, 0.5));
    stage.add_at(pinion, "pinion", spur_gear(10, 0.3125, 0.5));
    const glm::dvec2 hub[] = {
        {0.4375, -0.25}, {0.75, -0.25}, {0.75, 0.75}, {0.4375, 0.75}, {0.4375, -0.25}};
    stage.add_at(wheel * placed({{0, 0, 0}, {}, {0.98, 1, 0.98}}), "hub", revolve(hub, 48));
    stage.add_at(wheel * placed({{0, -1, 0}}), "shaft", make_cylinder(0.375, 2.25, 40));
    stage.add_at(pinion * placed({{0, -0.75, 0}}), "axle", make_cylinder(0.25, 2, 32));
    place_bolts(stage, wheel, 1.04, 0.5);
    scene::Scene scene = stage.finish({{"front", 0, 0}, {"three_quarter", 34, 24}},
                                      {{"mesh", {1.5, 1, 3}, {0.25, -0.05, 0.25}, 36}});
    turn_gears(wheel, pinion_axle, scene);
    return scene;
}

scene::Scene make_teapot_scene() {
    Stage stage;
    Teapot teapot = make_teapot(10);
    stage.add("body", std::move(teapot.body));
    stage.add("lid", std::move(teapot.lid));
    stage.add("handle", std::move(teapot.handle));
    stage.add("spout", std::move(teapot.spout));
    return stage.finish({{"front", 0, 6}, {"three_quarter", 28, 26}, {"above", -140, 52}});
}

scene::Scene make_rocket_scene() {
    Stage stage;
    // Eight sides and three fins: 150 edges, about as many as CoRgi's rocket had.
    const glm::dvec2 hull[] = {{0, -1.5}, {.3, -1.5}, {.5, -.9}, {.5, 1}, {.35, 1.75}, {0, 2.5}};
    const glm::dvec2 fin[] = {{.25, -.9}, {1.1, -1.8}, {1.1, -1.15}, {.25, .3}};
    const glm::dmat4 flight = placed({{0, 0, 0}, {0, 0, -62}});
    stage.add_at(flight, "hull", revolve(hull, 8));
    const auto fin_mesh = stage.mesh("fin", extrude(fin, {-0.0625, 0.0625}));
    for (int i = 0; i < 3; ++i) {
        stage.place(fin_mesh, "fin", flight * placed({{}, {0, 50.0 + 120 * i, 0}}));
    }
    return stage.finish({{"front", 0, 0}, {"three_quarter", -38, 18}, {"behind", -105, -24}});
}

scene::Scene make_letters_scene() {
    const glm::dvec2 i[] = {{0, 0},
                            {1.2, 0},
                            {1.2, .35},
                            {.8, .35},
                            {.8, 1.65},
                            {1.2, 1.65},
                            {1.2, 2},
                            {0, 2},
                            {0, 1.65},
                            {.4, 1.65},
                            {.4, .35},
                            {0, .35}};
    const glm::dvec2 n[] = {{0, 0},
                            {.4, 0},
                            {.4, 1.3},
                            {1.1, 0},
                            {1.5, 0},
                            {1.5, 2},
                            {1.1, 2},
                            {1.1, .7},
                            {.4, 2},
                            {0, 2}};
    const glm::dvec2 k[] = {{0, 0},
                            {.4, 0},
                            {.4, .7},
                            {.62, .95},
                            {1.1, 0},
                            {1.58, 0},
                            {.92, 1.3},
                            {1.55, 2},
                            {1, 2},
                            {.4, 1.3},
                            {.4, 2},
                            {0, 2}};
    Stage stage;
    stage.add("i", extrude(i, {-0.3, 0.3}), {{-2.4, 0, 0}, {0, 6, 0}});
    stage.add("n", extrude(n, {-0.3, 0.3}), {{-0.8, 0, 0.1}, {0, -5, 2}});
    stage.add("k", extrude(k, {-0.3, 0.3}), {{1.1, 0, 0}, {0, 8, -3}});
    return stage.finish({{"front", 0, 0}, {"three_quarter", -32, 20}, {"grazing", 62, 12}});
}

scene::Scene make_knot_scene() {
    std::vector<TubeNode> path;
    for (int i = 0; i < 192; ++i) {
        const double t = 2 * std::numbers::pi * i / 192;
        const glm::dvec3 center{std::sin(t) + 2 * std::sin(2 * t),
                                std::cos(t) - 2 * std::cos(2 * t),
                                -1.25 * std::sin(3 * t)};
        path.push_back({center, 0.5});
    }
    Stage stage;
    stage.add("knot", make_closed_tube(path, 24));
    return stage.finish({{"front", 0, 0}, {"three_quarter", 40, 24}, {"edge_on", 84, 8}});
}

scene::Scene make_chess_scene() {
    Stage stage;
    // Six by six blocks with grooves between them, let into a plinth; pieces stand 1/64 above.
    stage.add("plinth", make_box({-3.375, -0.5, -3.375}, {3.375, -0.0625, 3.375}));
    const auto block =
        stage.mesh("block", make_box({-0.484375, -0.25, -0.484375}, {0.484375, 0, 0.484375}));
    for (int i = 0; i < 36; ++i) {
        stage.place(block, "block", Pose{{i % 6 - 2.5, 0, i / 6 - 2.5}});
    }
    using Squares = std::initializer_list<glm::ivec2>;
    const auto stand = [&](const char* name, const scene::Mesh& mesh, Squares squares) {
        const auto number = stage.mesh(name, mesh);
        for (const glm::ivec2& at : squares)
            stage.place(number, name, Pose{{at.x - 2.5, 0.015625, at.y - 2.5}});
    };
    stand("pawn", pawn(), {{0, 4}, {1, 4}, {2, 2}, {3, 4}, {4, 3}, {5, 4}, {1, 1}, {3, 1}});
    stand("rook", rook(), {{0, 5}, {5, 5}, {4, 0}});
    stand("bishop", bishop(), {{2, 5}, {3, 3}, {1, 0}});
    return stage.finish({{"front", 0, 20}, {"three_quarter", 32, 30}},
                        {{"close", {-2.25, 1.375, 4.5}, {0.25, 0.4375, 0}, 45}});
}

}  // namespace ink::catalogue
