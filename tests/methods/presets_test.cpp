#include "methods/presets.h"

#include <gmock/gmock.h>

#include "core/error.h"
#include "core/toml_document.h"
#include "core/whole_file.h"
#include "methods/registry.h"
#include "tests/core/error_text.h"
#include "tests/methods/names.h"
#include "tests/methods/small_scenes.h"

namespace ink::methods {
namespace {

using testing::HasSubstr;
using testing::StartsWith;

constexpr const char* kText = R"(name = "mine"
method = "mote4"

[settings]
range_depth = 80.5
threshold = 7
normals = "facet"
fatten = true

[provenance]
command = "inkbench tune mote4"
seed = 7
)";

std::string message_of(const std::string& text) {
    return core::error_text([&] { return parse_preset(text, "mine.toml", registry()); });
}

std::string with(std::string text, const std::string& from, const std::string& to) {
    const auto at = text.find(from);
    EXPECT_NE(at, std::string::npos) << from;
    return text.replace(at, from.size(), to);
}

TEST(Presets, AFileIsNameMethodAndSettings) {
    const Preset preset = parse_preset(kText, "mine.toml", registry());
    EXPECT_EQ(preset.name, "mine");
    EXPECT_EQ(preset.method, "mote4");
    EXPECT_EQ(preset.command, "inkbench tune mote4");
    const core::ParamValues expected = {
        {"range_depth", "80.5"}, {"threshold", "7"}, {"normals", "facet"}, {"fatten", "true"}};
    EXPECT_EQ(preset.settings, expected);
}

TEST(Presets, AnErrorNamesFileLineKeyAndWhatIsAccepted) {
    EXPECT_THAT(
        message_of(with(kText, "threshold = 7", "threshold = 0")),
        AllOf(StartsWith("mine.toml:6: parameter threshold cannot be '0'"), HasSubstr("1..255")));
    EXPECT_THAT(message_of(with(kText, "range_depth", "range_dpth")),
                AllOf(StartsWith("mine.toml:5: "), HasSubstr("did you mean range_depth?")));
    EXPECT_THAT(message_of(with(kText, "\"facet\"", "\"faces\"")),
                AllOf(StartsWith("mine.toml:7: "), HasSubstr("file | patch | facet")));
    EXPECT_THAT(message_of(with(kText, "\"facet\"", "[1]")), StartsWith("mine.toml:7: "));
    EXPECT_THAT(message_of(with(kText, "\"mote4\"", "\"mote5\"")),
                AllOf(StartsWith("mine.toml:2: "), HasSubstr("did you mean mote")));
    EXPECT_THAT(message_of(with(kText, "\"mine\"", "\"My own\"")),
                AllOf(StartsWith("mine.toml:1: "), HasSubstr("small letters")));
    EXPECT_THAT(message_of(with(kText, "\"mine\"", "7")),
                AllOf(StartsWith("mine.toml:1: "), HasSubstr("in quotes")));
    EXPECT_THAT(message_of(with(kText, "[settings]", "[setings]")),
                AllOf(StartsWith("mine.toml:4: "), HasSubstr("did you mean settings?")));
    EXPECT_THAT(message_of(with(kText, "name = \"mine\"", "")), HasSubstr("no 'name'"));
    EXPECT_THAT(message_of(with(kText, "threshold = 7", "threshold = ")),
                StartsWith("mine.toml:6: "));
    EXPECT_THAT(message_of("name = \"a\"\nmethod = \"mote4\"\nsettings = 3\n"),
                StartsWith("mine.toml:3: "));
    EXPECT_THAT(message_of(""), HasSubstr("name, method, [settings]"));
}

TEST(Presets, AMethodOfAPresetDrawsAsItsMethodWithThoseSettings) {
    const method::MethodInfo info =
        preset_method(parse_preset(kText, "mine.toml", registry()), registry());
    EXPECT_EQ(info.name, "mine");
    EXPECT_EQ(info.preset_of, "mote4");
    const method::MethodInfo& base = find_method("mote4");
    EXPECT_EQ(info.family, base.family);
    EXPECT_EQ(info.marker, base.marker);
    EXPECT_EQ(info.tunables.size(), base.tunables.size());
    EXPECT_EQ(info.sum_limits.size(), base.sum_limits.size());
    const core::ParamValues all = info.complete({{"fatten", "false"}});
    EXPECT_EQ(all.at("range_depth"), "80.5");
    EXPECT_EQ(all.at("threshold"), "7");
    EXPECT_EQ(all.at("normals"), "facet");
    EXPECT_EQ(all.at("fatten"), "false") << "the user's setting stands above the preset's";
    EXPECT_EQ(all.at("range_nx"), "63") << "and the method's own default below it";

    const scene::Scene scene = cube_on_floor();
    const scene::View view = view_from(scene, {4, 3, 6}, {0, 0, 0}, {150, 101});
    EXPECT_EQ(drawn(info, {{"fatten", "false"}}, scene, {view, 1}),
              drawn("mote4", {{"range_depth", "80.5"}, {"normals", "facet"}}, scene, {view, 1}));
}

TEST(Presets, DefaultsShownAreThoseOfTheFile) {
    const method::MethodInfo info =
        preset_method(parse_preset(kText, "mine.toml", registry()), registry());
    const auto default_of = [&](const std::string& name) {
        for (const core::Param& param : info.params) {
            if (param.name == name) return param.default_value;
        }
        return -1.0;
    };
    EXPECT_EQ(default_of("range_depth"), 80.5);
    EXPECT_EQ(default_of("normals"), 2);
    EXPECT_EQ(default_of("fatten"), 1);
    EXPECT_EQ(default_of("range_nx"), 63);
}

TEST(ShippedPresets, TheRegistrysDefaultsAreThoseOfTheFilesOnDisk) {
    for (const ShippedFile& shipped : shipped_presets()) {
        const std::string name(shipped.name);
        const std::string path =
            std::string(INK_SOURCE_DIR) + "/methods/" + name + "/" + name + ".toml";
        const std::string text = core::read_whole_file(path).value_or("");
        EXPECT_EQ(text, shipped.text) << path;
        const toml::table file = toml::parse(text);
        EXPECT_EQ(file["name"].value_or(std::string()), name);
        const std::string base = file["method"].value_or(std::string());
        core::ParamValues expected = find_method(base).complete({});
        ASSERT_TRUE(file["settings"].is_table()) << path;
        for (const auto& [key, node] : *file["settings"].as_table()) {
            const std::string key_text(key.str());
            ASSERT_EQ(expected.count(key_text), 1U) << key_text;
            if (node.is_number()) {
                EXPECT_EQ(std::stod(find_method(name).complete({}).at(key_text)),
                          *node.value<double>());
            }
            expected[key_text] = find_method(name).complete({}).at(key_text);
        }
        EXPECT_EQ(find_method(name).complete({}), expected) << "all else is the method's own";
    }
    EXPECT_EQ(shipped_presets().size(), 5U);
}

}  // namespace
}  // namespace ink::methods
