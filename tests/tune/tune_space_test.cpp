#include "tune/tune_space.h"

#include <gmock/gmock.h>

#include <random>

#include "core/error.h"
#include "methods/registry.h"
#include "tests/core/error_text.h"

namespace ink::tune {
namespace {

using testing::HasSubstr;

TuneSpace space_of(const std::string& method, const std::string& parameters) {
    return {methods::find_method(method), parameters};
}

std::string message_of(const std::string& method, const std::string& parameters) {
    return core::error_text([&] { return space_of(method, parameters); });
}

TEST(TuneSpace, EndsOfTheCubeAreEndsOfTheRanges) {
    const TuneSpace space = space_of("decaudin", "k_depth=0.01..1,threshold=10..20,join");
    EXPECT_EQ(space.settings_at({0, 0, 0}),
              (core::ParamValues{{"k_depth", "0.01"}, {"threshold", "10"}, {"join", "max"}}));
    EXPECT_EQ(space.settings_at({1, 1, 1}),
              (core::ParamValues{{"k_depth", "1"}, {"threshold", "20"}, {"join", "length"}}));
    EXPECT_EQ(space.settings_at({-3, 9, 0.5}),
              (core::ParamValues{{"k_depth", "0.01"}, {"threshold", "20"}, {"join", "or"}}));
}

TEST(TuneSpace, AWideRangeIsLogarithmicAndANarrowOneLinear) {
    EXPECT_EQ(space_of("decaudin", "k_depth=0.01..1").settings_at({0.5}).at("k_depth"), "0.1");
    EXPECT_EQ(space_of("decaudin", "k_depth=0.1..0.3").settings_at({0.5}).at("k_depth"), "0.2");
    // asinh(1000) / 2 is 3.80045, whose sinh is 22.35.
    EXPECT_EQ(space_of("polygon_offset", "units=-1000..0").settings_at({0.5}).at("units"),
              "-22.35");
}

TEST(TuneSpace, RangesAreScaledDownToTheLargestCode) {
    const TuneSpace space = space_of("mote4", "range_depth,range_nx,range_ny,range_nz");
    // 4 x 255 is four times too much: 63.75 each, which has four digits.
    for (const auto& [name, value] : space.settings_at({1, 1, 1, 1}))
        EXPECT_EQ(value, "63.75") << name;
    EXPECT_EQ(space.settings_at({0.2, 0.2, 0.2, 0.2}).at("range_ny"), "51");
    std::mt19937_64 random(1);
    for (int i = 0; i < 500; ++i) {
        std::vector<double> point(4);
        for (double& x : point)
            x = static_cast<double>(random() >> 11) * 0x1p-53;
        double sum = 0;
        for (const auto& [name, value] : space.settings_at(point))
            sum += std::stod(value);
        EXPECT_LE(sum, 255);
    }
}

TEST(TuneSpace, ASettingHasAPointThatGivesItBack) {
    const auto gives_back = [](const std::string& method, const core::ParamValues& settings) {
        std::string parameters;
        for (const auto& [name, value] : settings)
            parameters += name + ",";
        const TuneSpace space = space_of(method, parameters);
        EXPECT_EQ(space.settings_at(space.point_of(settings)), settings) << method;
    };
    gives_back("mote4", {{"range_depth", "63"}, {"range_nx", "31.5"}, {"threshold", "6"}});
    gives_back("decaudin", {{"k_depth", "0.0123"}, {"join", "or"}, {"renormalise", "true"}});
    gives_back("polygon_offset", {{"factor", "-0.5"}, {"units", "-1"}, {"edges", "polygons"}});
}

TEST(TuneSpace, EveryMethodHasParametersToTune) {
    for (const method::MethodInfo& info : methods::registry()) {
        const TuneSpace space(info, "");
        EXPECT_GE(space.size(), 1U) << info.name;
        const core::ParamValues middle = space.settings_at(std::vector<double>(space.size(), 0.5));
        EXPECT_NO_THROW((void)info.complete(middle)) << info.name;
    }
}

TEST(TuneSpace, UnlessToldOtherwiseItIsTheTunablesOfTheRegistry) {
    EXPECT_EQ(default_parameters(methods::find_method("decaudin")),
              "k_depth=0.001..1,k_normal=0.01..2,join,threshold");
    EXPECT_EQ(default_parameters(methods::find_method("polygon_offset")),
              "factor=-4..0,units=-65536..0");
    EXPECT_EQ(default_parameters(methods::find_method("ids")), "threshold") << "it names none";
    method::MethodInfo info = methods::find_method("ids");
    info.tunables = {{"crease_deg", {{10, 60}}}};
    const TuneSpace space(info, "");
    ASSERT_EQ(space.size(), 1U);
    EXPECT_EQ(space.parameters()[0].low, 10);
    EXPECT_EQ(space.parameters()[0].high, 60);
}

TEST(TuneSpace, APresetIsTunedAsItsMethodIs) {
    EXPECT_EQ(default_parameters(methods::find_method("mote4_tuned")),
              default_parameters(methods::find_method("mote4")));
    const TuneSpace space = space_of("mote4_tuned", "range_depth,range_nx");
    EXPECT_EQ(space.settings_at({1, 1}).at("range_nx"), "127.5") << "within its largest code";
}

TEST(TuneSpace, BadParametersAreNamed) {
    EXPECT_THAT(message_of("mote4", "range_nq"), HasSubstr("did you mean range_n"));
    EXPECT_THAT(message_of("mote4", "range_nx,range_nx"), HasSubstr("named twice"));
    EXPECT_THAT(message_of("mote4", "range_nx=9"), HasSubstr("'9' is no range of range_nx"));
    EXPECT_THAT(message_of("mote4", "range_nx=9..5"), HasSubstr("0..255"));
    EXPECT_THAT(message_of("mote4", "range_nx=9..500"), HasSubstr("0..255"));
    EXPECT_THAT(message_of("mote4", "response=0..1"), HasSubstr("every choice is tried"));
    EXPECT_THAT(message_of("mote4", ","), HasSubstr("names no parameter"));
}

}  // namespace
}  // namespace ink::tune
