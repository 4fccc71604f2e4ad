#include "methods/auto/auto_plan.h"

#include <gmock/gmock.h>

#include <glm/trigonometric.hpp>

#include "catalogue/shapes.h"
#include "tests/methods/small_scenes.h"

// What `auto` plans for each kind of scene, and that it draws what it plans.

namespace ink::methods {
namespace {

using testing::Contains;
using testing::Field;
using testing::HasSubstr;

CodePlan plan_for(const scene::Scene& scene, const PlanWishes& wishes = {}) {
    return make_plan(scene::make_scene_statistics(scene, glm::radians(40.0)), wishes);
}

bool reads_normals(const CodePlan& plan) {
    return plan.ranges.normal != glm::dvec3(0);
}

/// Every triangle a component of its own: no two share a corner's place.
scene::Mesh in_components(const scene::Mesh& mesh) {
    scene::Mesh components;
    for (const scene::Triangle& t : mesh.triangles) {
        const auto first = static_cast<std::uint32_t>(components.positions.size());
        glm::vec3 middle{0};
        for (const std::uint32_t v : t)
            middle += mesh.positions[v] / 3.0F;
        for (const std::uint32_t v : t)
            components.positions.push_back(glm::mix(mesh.positions[v], middle, 1e-4F));
        components.triangles.push_back({first, first + 1, first + 2});
    }
    return components;
}

TEST(AutoPlan, ACurvedClosedSurfaceNeedsOneByteOfDepth) {
    for (const scene::Mesh& mesh :
         {catalogue::make_icosphere(1, 3), catalogue::make_torus({2, 0.5}, {48, 24})}) {
        const CodePlan plan = plan_for(scene_of({mesh}));
        EXPECT_FALSE(reads_normals(plan));
        EXPECT_EQ(plan.store, raster::Store::u8);
    }
}

TEST(AutoPlan, FlatSheetsNeedDepthAloneInSmallSteps) {
    const CodePlan plan = plan_for(scene_of({floor_mesh(1)}));
    EXPECT_FALSE(reads_normals(plan));
    EXPECT_EQ(plan.store, raster::Store::u16);
}

TEST(AutoPlan, SmallStepsNeedAnEncodingThatIsFlatOnPlanes) {
    for (const scene::Mesh& mesh : {cube_mesh(), floor_mesh(1)})
        EXPECT_EQ(plan_for(scene_of({mesh})).encoding, raster::DepthEncoding::inverse);
    for (const scene::Mesh& mesh :
         {catalogue::make_icosphere(1, 3), catalogue::make_cylinder(1, 2, 36)})
        EXPECT_EQ(plan_for(scene_of({mesh})).encoding, raster::DepthEncoding::log);
    // 0.72 degrees from facet to facet.
    EXPECT_EQ(plan_for(scene_of({catalogue::make_cylinder(1, 2, 500)})).encoding,
              raster::DepthEncoding::inverse);
}

TEST(AutoPlan, CreasesNeedNormalsWithUnlikeWeights) {
    const CodePlan plan = plan_for(scene_of({cube_mesh()}));
    EXPECT_EQ(plan.store, raster::Store::u16);
    EXPECT_GT(plan.ranges.depth, plan.ranges.normal.x);
    EXPECT_GT(plan.ranges.normal.x, plan.ranges.normal.y);
    EXPECT_GT(plan.ranges.normal.y, plan.ranges.normal.z);
    EXPECT_GT(plan.ranges.normal.z, 0);
}

TEST(AutoPlan, SmoothBallsThatMayCrossNeedNormalsWithoutAnyCrease) {
    scene::Scene balls =
        scene_of({catalogue::make_icosphere(1, 3), catalogue::make_icosphere(1, 3)});
    balls.instances[1].world_from_object = glm::translate(glm::dmat4(1), {0.5, 0, 0});
    EXPECT_TRUE(reads_normals(plan_for(balls)));
    balls.instances[1].world_from_object = glm::translate(glm::dmat4(1), {2.5, 0, 0});
    EXPECT_FALSE(reads_normals(plan_for(balls)));
}

TEST(AutoPlan, ASoupsNormalsAreLeftOutWhateverItsCreases) {
    const CodePlan plan =
        plan_for(scene_of({in_components(catalogue::make_icosphere(1, 2)), cube_mesh()}));
    EXPECT_FALSE(reads_normals(plan));
    EXPECT_THAT(plan.lines,
                Contains(testing::Field(&method::PlanLine::why, HasSubstr("no neighbour"))));
}

TEST(AutoPlan, CoarserFacetsNeedALargerStep) {
    // The same range for a larger step is the same as more bits shifted away.
    const auto codes_a_step = [](int sides) {
        const CodePlan plan = plan_for(scene_of({catalogue::make_cylinder(1, 2, sides)}));
        const glm::dvec3 n = plan.ranges.normal;
        const double sum = plan.ranges.depth + n.x + n.y + n.z;
        return std::ldexp(kPlannedResponse, -plan.scale_bits) / sum;
    };
    // 10 degrees from facet to facet, and 20; a 1540th of the range for each.
    EXPECT_NEAR(codes_a_step(36), 10.0 / 1540, 1e-5);
    EXPECT_NEAR(codes_a_step(18), 20.0 / 1540, 1e-5);
}

TEST(AutoPlan, LeavesTheSkyALinesStepBeyondTheFarthestCode) {
    for (const scene::Mesh& mesh : {cube_mesh(), floor_mesh(1), catalogue::make_icosphere(1, 3)}) {
        const CodePlan plan = plan_for(scene_of({mesh}));
        const glm::dvec3 n = plan.ranges.normal;
        const double most = plan.ranges.depth + n.x + n.y + n.z;
        const double step = std::ldexp(kPlannedResponse, -plan.scale_bits);
        EXPECT_GE(plan.applied_to({}).sky - most, step);
    }
}

TEST(AutoPlan, SaysThatSeamsAreSeenByNone) {
    const scene::Mesh left = catalogue::make_sheet({0, 0, 0}, {1, 0, 0}, {0, 1, 0});
    const scene::Mesh right = catalogue::make_sheet({1, 0, 0}, {1, 0, 0}, {0, 1, 0});
    EXPECT_THAT(plan_for(scene_of({left, right})).lines,
                Contains(testing::Field(&method::PlanLine::what, HasSubstr("seams"))));
    EXPECT_THAT(
        plan_for(scene_of({left})).lines,
        testing::Not(Contains(testing::Field(&method::PlanLine::what, HasSubstr("seams")))));
}

TEST(AutoPlan, EveryLineHasAReason) {
    for (const scene::Scene& scene : {scene_of({cube_mesh()}), cube_on_floor(), scene::Scene{}}) {
        const CodePlan plan = plan_for(scene);
        EXPECT_GE(plan.lines.size(), 4U);
        for (const method::PlanLine& line : plan.lines) {
            EXPECT_FALSE(line.what.empty());
            EXPECT_FALSE(line.why.empty());
        }
    }
}

TEST(AutoPlan, WishesGoBeforeThePlan) {
    const scene::Scene cube = scene_of({cube_mesh()});
    EXPECT_FALSE(reads_normals(plan_for(cube, {.channels = PlanWishes::Channels::depth})));
    EXPECT_EQ(plan_for(cube, {.bytes = PlanWishes::Bytes::one}).store, raster::Store::u8);
    EXPECT_EQ(plan_for(cube, {.encoding = PlanWishes::Encoding::log}).encoding,
              raster::DepthEncoding::log);
}

TEST(Auto, TellsThePlanOfTheSceneThatWasPrepared) {
    const auto method = find_method("auto").make({});
    const scene::Scene ball = scene_of({catalogue::make_icosphere(1, 3)});
    method->prepare(ball);
    EXPECT_EQ(method->plan().front().what, "depth alone, no normals");
    EXPECT_EQ(method->bytes_per_px(), 4 + 1);
    ASSERT_TRUE(method->code());
    EXPECT_EQ(method->code()->normal_weight[0], 0);
    method->prepare(scene_of({cube_mesh()}));
    EXPECT_EQ(method->bytes_per_px(), 4 + 2);
    EXPECT_GT(method->code()->normal_weight[0], 0);
}

TEST(Auto, DeclaresACodeWhosePlanesAreSureToBeSilent) {
    const auto method = find_method("auto").make({});
    method->prepare(cube_on_floor());
    ASSERT_TRUE(method->code());
    EXPECT_GE(method->code()->response.clip_bits, 2);
    EXPECT_TRUE(method->code()->inputs.at_vertices);
}

TEST(Auto, OtherMethodsPlanNothing) {
    for (const method::MethodInfo& info : registry()) {
        if (info.name == "auto") continue;
        EXPECT_TRUE(info.make({})->plan().empty()) << info.name;
    }
}

}  // namespace
}  // namespace ink::methods
