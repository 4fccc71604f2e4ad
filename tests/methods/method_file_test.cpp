
#include <gmock/gmock.h>

#include <filesystem>

#include "core/whole_file.h"
#include "methods/registry.h"
#include "tests/core/error_text.h"

namespace ink::methods {
namespace {

using testing::AllOf;
using testing::HasSubstr;

const std::string kHead =
    "source = \"me\"\nsummary = \"dots\"\nfamily = \"ids\"\nmarker = \"plus\"\n";

/// What is code of a method with the parameters of mote2.
method::MethodInfo code() {
    method::MethodInfo info = find_method("mote2");
    info.sweep.clear();
    info.tunables.clear();
    info.sum_limits.clear();
    return info;
}

TEST(MethodFile, FillsInWhatIsNoCode) {
    const method::MethodInfo info =
        described(code(),
                  kHead +
                      "# why\nsweep = [\n{},\n{range_depth = 120.50, fatten = true}\n]\n"
                      "sum_limits = [{params = [\"range_depth\", \"range_normal\"], limit = 9}]\n"
                      "[tunables]\nthreshold = \"all\"\nrange_depth = [1, 64.5]\n",
                  "dots.toml");
    EXPECT_EQ(info.source, "me");
    EXPECT_EQ(info.summary, "dots");
    EXPECT_EQ(info.family, method::Family::ids);
    EXPECT_EQ(info.marker, method::Marker::plus);
    const std::vector<core::ParamValues> sweep = {{},
                                                  {{"range_depth", "120.5"}, {"fatten", "true"}}};
    EXPECT_EQ(info.sweep, sweep);
    ASSERT_EQ(info.sum_limits.size(), 1U);
    EXPECT_EQ(info.sum_limits[0].limit, 9);
    EXPECT_EQ(info.sum_limits[0].params, (std::vector<std::string>{"range_depth", "range_normal"}));
    ASSERT_EQ(info.tunables.size(), 2U);
    EXPECT_EQ(info.tunables[0].param, "threshold") << "in the order of the file";
    EXPECT_FALSE(info.tunables[0].range);
    EXPECT_EQ(info.tunables[1].range, std::pair(1.0, 64.5));
}

std::string message_of(const std::string& text) {
    return core::error_text([&] { return described(code(), text, "dots.toml"); });
}

TEST(MethodFile, NamesFileAndLineOfWhatItRefuses) {
    const auto says = [](const char* line, const char* what) {
        return AllOf(HasSubstr(std::string("dots.toml:") + line), HasSubstr(what));
    };
    EXPECT_THAT(message_of(kHead + "sweeps = []\n"), says("5", "sweep"));
    EXPECT_THAT(message_of(kHead + "sweep = 3\n"), says("5", "a list of tables"));
    EXPECT_THAT(message_of(kHead + "sweep = [\n{},\n{range = 3}]\n"), says("7", "range_depth"));
    EXPECT_THAT(message_of(kHead + "sweep = [\n{},\n{threshold = 999}]\n"), says("7", "1..255"));
    EXPECT_THAT(message_of(kHead + "sum_limits = [{params = [\"range\"], limit = 3}]\n"),
                says("5", "range"));
    EXPECT_THAT(message_of(kHead + "sum_limits = [{limit = 3}]\n"), says("5", "this is no limit"));
    EXPECT_THAT(message_of(kHead + "tunables = 3\n"), says("5", "[tunables]"));
    EXPECT_THAT(message_of(kHead + "[tunables]\nrange = \"all\"\n"), says("6", "range_depth"));
    EXPECT_THAT(message_of(kHead + "[tunables]\nthreshold = [0, 64]\n"), says("6", "1..255"));
    EXPECT_THAT(message_of(kHead + "[tunables]\nthreshold = [64, 1]\n"), says("6", "'threshold'"));
    EXPECT_THAT(message_of(kHead + "[tunables\n"), says("5", "no TOML"));
    EXPECT_EQ(message_of(kHead + ""), "") << "settings and tunables may be left out";
}

TEST(MethodFile, MustSayWhoFamilyAndMarker) {
    EXPECT_THAT(message_of("source = \"me\"\n"), HasSubstr("there is no 'summary'"));
    EXPECT_THAT(message_of("source = 3\n"),
                AllOf(HasSubstr("dots.toml:1"), HasSubstr("a text in quotes")));
    EXPECT_THAT(message_of("source = \"a\"\nsummary = \"b\"\nfamily = \"idz\"\n"),
                AllOf(HasSubstr("dots.toml:3"), HasSubstr("idz"), HasSubstr("ids")));
}

TEST(MethodFile, TheBuildTookInWhatStandsOnDisk) {
    for (const ShippedFile& shipped : method_files()) {
        const auto path = std::filesystem::path(INK_SOURCE_DIR) / shipped.where();
        EXPECT_EQ(core::read_whole_file(path), shipped.text) << path;
    }
    EXPECT_EQ(method_files().size() + shipped_presets().size(), registry().size());
}

}  // namespace
}  // namespace ink::methods
