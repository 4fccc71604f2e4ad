#include <gmock/gmock.h>

#include <glm/trigonometric.hpp>

#include "catalogue/shapes.h"
#include "methods/auto/auto.h"
#include "tests/methods/small_scenes.h"

// What `auto` chooses for each kind of scene, and that it draws what it chose.

namespace ink::methods {
namespace {

using testing::Contains;
using testing::Field;

constexpr double kPrices[] = {1, 1.5, 3};

ScenePlan plan_for(const scene::Scene& scene, double price) {
    return plan_scene(scene::make_scene_statistics(scene, glm::radians(40.0)), price);
}

/// A quarter of its edges is smooth.
scene::Scene cylinder() {
    return scene_of({catalogue::make_cylinder(1, 2, 36)});
}

scene::Scene torus() {
    return scene_of({catalogue::make_torus({2, 0.5}, {48, 24})});
}

/// Bars far thinner than the ball that holds them all.
scene::Scene thin_bars() {
    scene::Scene scene = scene_of({cube_mesh(), cube_mesh()});
    for (int i = 0; i < 2; ++i) {
        scene.instances[static_cast<std::size_t>(i)].world_from_object =
            glm::scale(glm::translate(glm::dmat4(1), {0.01 * i, 0, 0}), {0.0005, 1, 0.0005});
    }
    return scene;
}

TEST(AutoPlan, WhatCannotHideItselfNeedsLabelsAlone) {
    for (const double price : kPrices) {
        EXPECT_EQ(plan_for(scene_of({catalogue::make_icosphere(1, 3)}), price).method, "label8");
        EXPECT_EQ(plan_for(cube_on_floor(), price).method, "label8");
    }
}

TEST(AutoPlan, LooksLinesUpWhereThatIsWithinThePrice) {
    EXPECT_EQ(plan_for(torus(), 3).method, "surface_lookup");
    EXPECT_EQ(plan_for(torus(), 1.5).method, "surface8_depth");
    EXPECT_EQ(plan_for(cylinder(), 1.5).method, "surface_lookup");
    EXPECT_EQ(plan_for(cylinder(), 1).method, "surface8_depth");
}

TEST(AutoPlan, EdgesDrawWhatSamplesPassBy) {
    EXPECT_EQ(plan_for(thin_bars(), 3).method, "edge_hash");
    EXPECT_EQ(plan_for(thin_bars(), 1).method, "label8");
}

TEST(AutoPlan, ManyPatchesOfSoupAreToldApartByCodes) {
    scene::Mesh soup = scene::exploded(catalogue::make_icosphere(1, 2));
    for (std::size_t v = 0; v < soup.positions.size(); ++v)
        soup.positions[v] *= 1 + 3e-3F * static_cast<float>(v / 3);
    EXPECT_NE(plan_for(scene_of({soup}), 3).method, "label8");
}

TEST(AutoPlan, SaysWhatItChoseWhyAndWhatItLeavesOut) {
    for (const double price : kPrices) {
        for (const scene::Scene& scene : {torus(), cylinder(), cube_on_floor(), scene::Scene{}}) {
            const ScenePlan plan = plan_for(scene, price);
            EXPECT_EQ(plan.lines.front().what, plan.method);
            for (const method::PlanLine& line : plan.lines)
                EXPECT_FALSE(line.why.empty());
        }
    }
    const auto what = &method::PlanLine::what;
    EXPECT_THAT(plan_for(torus(), 1).lines, Contains(Field(what, "no look-up")));
    EXPECT_THAT(plan_for(torus(), 1).lines, Contains(Field(what, "nothing for creases")));
    EXPECT_THAT(plan_for(cylinder(), 1).lines,
                testing::Not(Contains(Field(what, "nothing for creases"))));
}

TEST(Auto, DrawsWhatTheChosenMethodDraws) {
    const scene::Scene scene = torus();
    const scene::View view = view_from(scene, {4, 3, 6}, {0, 0, 0}, {150, 101});
    for (const char* price : {"1", "1.5", "3"}) {
        const std::string chosen = plan_for(scene, std::stod(price)).method;
        EXPECT_EQ(drawn("auto", {{"crease_deg", "30"}, {"price", price}}, scene, {view, 1}),
                  drawn(chosen, {{"crease_deg", "30"}}, scene, {view, 1}));
    }
}

TEST(Auto, TellsThePlanOfTheSceneThatWasPrepared) {
    const auto method = find_method("auto").make({});
    for (const scene::Scene& scene : {torus(), cube_on_floor()}) {
        method->prepare(scene);
        const std::string chosen = scene.meshes.size() == 1 ? "surface_lookup" : "label8";
        EXPECT_EQ(method->plan().front().what, chosen);
        EXPECT_EQ(method->bytes_per_px(), find_method(chosen).bytes_per_px({}));
    }
}

}  // namespace
}  // namespace ink::methods
