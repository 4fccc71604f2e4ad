#include "studies/axis.h"

#include <gmock/gmock.h>

#include <algorithm>
#include <set>

#include "core/error.h"
#include "core/simd.h"
#include "methods/registry.h"

namespace ink::studies {
namespace {

using testing::ElementsAre;

constexpr CaseSize kSmall{96, 54};

TEST(StressAxes, HaveNamesOfTheirOwnAndWords) {
    std::set<std::string> names;
    for (const Axis& axis : stress_axes()) {
        EXPECT_TRUE(names.insert(axis.name).second) << axis.name;
        EXPECT_FALSE(axis.title.empty()) << axis.name;
        EXPECT_TRUE(axis.sentence.ends_with(".")) << axis.name;
    }
    EXPECT_EQ(find_stress_axis("grazing").unit, "deg");
    EXPECT_THROW((void)find_stress_axis("grazin"), core::Error);
}

TEST(StressAxes, HaveEightValuesOrMoreThatAscend) {
    for (const Axis& axis : stress_axes()) {
        const std::size_t least =
            axis.name == "simd" ? std::min<std::size_t>(8, 2 * core::simd_targets().size()) : 8;
        EXPECT_GE(axis.values.size(), least) << axis.name;
        for (std::size_t i = 1; i < axis.values.size(); ++i)
            EXPECT_LT(axis.values[i - 1], axis.values[i]) << axis.name;
        const bool is_named = axis.scale == AxisScale::named;
        EXPECT_EQ(axis.value_names.size(), is_named ? axis.values.size() : 0) << axis.name;
        if (axis.scale == AxisScale::log) {
            EXPECT_GT(axis.values.front(), 0) << axis.name;
        }
    }
}

TEST(StressAxes, ReachAsFarAsTheDesignSays) {
    const auto reach = [](const char* name) {
        const Axis& axis = find_stress_axis(name);
        return std::pair(axis.values.front(), axis.values.back());
    };
    EXPECT_EQ(reach("near_far"), std::pair(1e1, 1e9));
    EXPECT_EQ(reach("grazing"), std::pair(0.1, 20.0));
    EXPECT_EQ(reach("origin"), std::pair(1.0, 1e8));
    EXPECT_LE(reach("scale").first, 1e-9);
    EXPECT_GE(reach("scale").second, 1e9);
    EXPECT_EQ(reach("gap"), std::pair(1e-7, 1e-1));
    EXPECT_EQ(reach("sliver"), std::pair(1.0, 1e7));
    EXPECT_EQ(reach("facets").first, 8);
    EXPECT_GE(reach("facets").second, 1e6);
    EXPECT_EQ(reach("threads"), std::pair(1.0, 8.0));
    for (const char* defect : {"duplicates", "t_junctions", "cracks", "orientation", "soup"})
        EXPECT_EQ(reach(defect), std::pair(0.0, 100.0));
}

TEST(StressAxes, HaveTwoCasesOrMoreOfTheSameScenesAtEveryValue) {
    for (const Axis& axis : stress_axes()) {
        std::set<std::string> views;
        std::vector<std::string> scenes;
        for (const double value : {axis.values.front(), axis.values[axis.values.size() / 2]}) {
            const auto cases = axis.cases(value, kSmall);
            EXPECT_GE(cases.size(), 2U) << axis.name;
            std::vector<std::string> names;
            for (const Case& stress : cases) {
                EXPECT_EQ(stress.axis, axis.name);
                EXPECT_EQ(stress.value, value);
                ASSERT_EQ(stress.scene_views.views.size(), 1U);
                EXPECT_EQ(stress.scene_views.views[0].width_px, 96);
                EXPECT_NO_THROW(scene::check_scene(stress.scene_views.scene));
                names.push_back(stress.scene_views.scene.name);
                views.insert(stress.scene_views.views[0].camera.name);
            }
            EXPECT_EQ(std::set<std::string>(names.begin(), names.end()).size(), names.size());
            if (scenes.empty()) scenes = names;
            EXPECT_EQ(names, scenes) << axis.name;
        }
        EXPECT_EQ(views.size(), 2U) << axis.name;
    }
}

TEST(StressValues, KeepsBothEnds) {
    Axis axis;
    axis.values = {1, 2, 3, 4, 5, 6, 7, 8, 9};
    EXPECT_THAT(axis_values(axis, 2), ElementsAre(1, 9));
    EXPECT_THAT(axis_values(axis, 3), ElementsAre(1, 5, 9));
    EXPECT_THAT(axis_values(axis, 9), testing::SizeIs(9));
    EXPECT_THAT(axis_values(axis, 50), testing::SizeIs(9));
}

method::MethodConfig config_of(const char* method) {
    return {&methods::find_method(method), {}};
}

std::string parameter(const method::MethodConfig& config, const char* name) {
    return config.info->complete(config.settings).at(name);
}

TEST(UnderStress, SetsParametersOfThoseThatHaveThem) {
    Case stress;
    stress.settings = {"depth_format=z16", "mote4.sky=7", "price=2"};
    EXPECT_EQ(parameter(under_case(config_of("mote4"), stress), "depth_format"), "z16");
    EXPECT_EQ(parameter(under_case(config_of("mote4"), stress), "sky"), "7");
    EXPECT_EQ(parameter(under_case(config_of("mote2"), stress), "sky"), "0");
    EXPECT_EQ(parameter(under_case(config_of("edge_list"), stress), "depth_format"), "z16");
    // It knows the parameter, but not this value.
    EXPECT_EQ(parameter(under_case(config_of("auto"), stress), "price"), "3");
}

TEST(UnderStress, GainTakesRangesAndThresholdAlong) {
    Case stress;
    stress.code_gain = 2;
    const method::MethodConfig twice = under_case(config_of("mote4"), stress);
    EXPECT_EQ(parameter(twice, "range_depth"), "126");
    EXPECT_EQ(parameter(twice, "range_nz"), "126");
    EXPECT_EQ(parameter(twice, "threshold"), "12");
    stress.code_gain = 100;
    EXPECT_EQ(parameter(under_case(config_of("mote4"), stress), "range_nx"), "255");
    EXPECT_TRUE(under_case(config_of("decaudin"), stress).settings.empty());
}

TEST(UnderStress, FewerBitsShiftTheResponseBack) {
    Case stress;
    stress.code_bits = 6;
    const method::MethodConfig six = under_case(config_of("mote4"), stress);
    EXPECT_EQ(parameter(six, "range_depth"), "15");
    EXPECT_EQ(parameter(six, "scale_bits"), "2");
    EXPECT_EQ(parameter(six, "clip_bits"), "0");
    EXPECT_EQ(parameter(six, "threshold"), "6");
    stress.code_bits = 12;
    EXPECT_EQ(parameter(under_case(config_of("mote4"), stress), "range_depth"), "63");
    const method::MethodConfig twelve = under_case(config_of("mote16"), stress);
    EXPECT_EQ(parameter(twelve, "range_depth"), "1023");
    EXPECT_EQ(parameter(twelve, "scale_bits"), "-2");
}

}  // namespace
}  // namespace ink::studies
