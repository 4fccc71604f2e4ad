
#include <gmock/gmock.h>

#include <algorithm>
#include <fstream>

#include "core/error.h"
#include "methods/method_configs.h"
#include "tests/core/error_text.h"
#include "tests/core/temp_folder.h"

namespace ink::harness {
namespace {

std::string message_of(const std::string& methods, const std::vector<std::string>& settings) {
    return core::error_text([&] { return methods::make_configs(methods, settings); });
}

TEST(MethodConfigs, NoListIsEveryMethodInTheRegistrysOrder) {
    const auto configs = methods::make_configs("", {});
    ASSERT_EQ(configs.size(), methods::registry().size());
    EXPECT_EQ(configs[0].info->name, methods::registry()[0].name);
}

TEST(MethodConfigs, ASettingWithoutMethodGoesToAllThatKnowIt) {
    const auto configs = methods::make_configs("mote4,decaudin", {"clip_bits=3", "threshold=7"});
    EXPECT_EQ(configs[0].settings.at("clip_bits"), "3");
    EXPECT_EQ(configs[0].settings.at("threshold"), "7");
    EXPECT_EQ(configs[1].settings.count("clip_bits"), 0U);
    EXPECT_EQ(configs[1].settings.at("threshold"), "7");
}

TEST(MethodConfigs, ASettingWithMethodGoesToThatOneOnly) {
    const auto configs = methods::make_configs("mote4,mote2", {"mote2.threshold=9"});
    EXPECT_TRUE(configs[0].settings.empty());
    EXPECT_EQ(configs[1].settings.at("threshold"), "9");
}

TEST(MethodConfigs, FollowTheTruthsCreaseAngleWhereItIsTheirOwn) {
    std::vector<method::MethodConfig> configs = methods::make_configs(
        "ids,edge_list,sobel,inverted_hull,mote4", {"edge_list.crease_deg=20"});
    methods::follow_crease(40, configs);
    EXPECT_TRUE(configs[0].settings.empty()) << "nothing moves at the usual angle";
    methods::follow_crease(60, configs);
    EXPECT_EQ(configs[0].settings.at("crease_deg"), "60");
    EXPECT_EQ(configs[1].settings.at("crease_deg"), "20") << "it was set";
    EXPECT_EQ(configs[2].settings.at("crease_deg"), "60") << "the patches of its normals";
    EXPECT_TRUE(configs[3].settings.empty()) << "its default is another angle";
}

TEST(MethodConfigs, BadNamesAndValuesAreNamed) {
    using testing::HasSubstr;
    EXPECT_THAT(message_of("mote5", {}), HasSubstr("mote4"));
    EXPECT_THAT(message_of("mote4,mote4", {}), HasSubstr("named twice"));
    EXPECT_THAT(message_of("mote4", {"clip_bit=2"}), HasSubstr("did you mean clip_bits?"));
    EXPECT_THAT(message_of("mote4", {"decaudin.k_depth=2"}), HasSubstr("does not take part"));
    EXPECT_THAT(message_of("mote4", {"clip_bits"}), HasSubstr("key=value"));
    EXPECT_THAT(message_of("mote4", {"clip_bits=99"}), HasSubstr("clip_bits cannot be '99'"));
}

TEST(MethodConfigs, APresetCalledAsAShippedOneTakesItsPlace) {
    const core::TempFolder folder;
    const auto file = folder / "preset.toml";
    std::ofstream(file)
        << "name = \"mote4_tuned\"\nmethod = \"mote4\"\n[settings]\nthreshold = 77\n";
    const std::vector<method::MethodConfig> configs =
        methods::make_configs("", {}, {file.string()});
    const auto is_namesake = [](const method::MethodConfig& e) {
        return e.info->name == "mote4_tuned";
    };
    EXPECT_EQ(std::count_if(configs.begin(), configs.end(), is_namesake), 1);
    EXPECT_EQ(configs.back().info->name, "mote4_tuned");
    EXPECT_EQ(configs.back().info->complete({}).at("threshold"), "77");
}

}  // namespace
}  // namespace ink::harness
