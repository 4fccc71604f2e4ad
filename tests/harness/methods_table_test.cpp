#include "harness/rows/methods_table.h"

#include <gmock/gmock.h>

#include <sstream>

#include "harness/cells/cell.h"
#include "methods/antialias.h"
#include "methods/method_configs.h"

namespace ink::harness {
namespace {

using testing::ElementsAre;
using testing::EndsWith;
using testing::HasSubstr;
using testing::StartsWith;

std::vector<std::string> lines_of(const std::string& text) {
    std::vector<std::string> lines;
    std::istringstream stream(text);
    for (std::string line; std::getline(stream, line);)
        lines.push_back(line);
    return lines;
}

TEST(MethodsTable, BaselineRowsSayWhatTheyAreForAndNothingElse) {
    EXPECT_THAT(
        lines_of(methods_csv({})),
        ElementsAre(
            "method,role,family,marker,tunables,bytes_per_px,ink,preset_of,source,summary,params",
            "none,floor,,,,,,,,,",
            "sampled,one_sample,,,,,,,,,",
            "exact_corner,one_sample,,,,,,,,,",
            "oracle,exact,,,,,,,,,"));
}

TEST(MethodsTable, ALineSaysWhatTheRegistryKnows) {
    const std::vector<method::MethodConfig> configs =
        methods::make_configs("decaudin", {"threshold=99"});
    const std::string line = lines_of(methods_csv(configs)).at(5);
    EXPECT_THAT(line,
                StartsWith("decaudin,method,full_buffers,circle,"
                           "k_depth:0.001..1;k_normal:0.01..2;join:max|or|length;threshold:1..255,"
                           "20,false,,"));
    // The source has commas: one field in quotes.
    EXPECT_THAT(line, HasSubstr(",\"Decaudin, Cartoon-looking rendering"));
    EXPECT_THAT(line,
                EndsWith("," + join_params(configs[0].info->complete({{"threshold", "99"}}))));
}

TEST(MethodsTable, APresetNamesItsMethod) {
    const std::string line = lines_of(methods_csv(methods::make_configs("mote4_tuned", {}))).at(5);
    EXPECT_THAT(line, StartsWith("mote4_tuned,method,packed,square,range_depth:0..255;"));
    EXPECT_THAT(
        line,
        HasSubstr(",mote4,\"Mononen, MOTE engine, second version (about 1998); settings found"));
}

TEST(MethodsTable, BytesFollowTheSettingsAndAreEmptyWhereTheSceneDecides) {
    const auto bytes = [](const std::string& method, const std::vector<std::string>& settings) {
        const std::vector<method::MethodConfig> configs = methods::make_configs(method, settings);
        return configs[0].info->bytes_per_px(configs[0].settings);
    };
    EXPECT_EQ(bytes("mote4", {"depth_format=q32"}), 5);
    EXPECT_EQ(bytes("mote4", {"depth_format=z16"}), 3);
    EXPECT_THAT(lines_of(methods_csv(methods::make_configs("mote4", {"depth_format=z16"}))).at(5),
                HasSubstr("threshold:1..64,3,false,,"));
    EXPECT_THAT(lines_of(methods_csv(methods::make_configs("auto", {}))).at(5),
                StartsWith("auto,method,other,up,threshold:1..255,,false,,"));
}

TEST(MethodsTable, SaysWhichMethodsDrawInk) {
    const std::vector<method::MethodConfig> configs =
        methods::at_each_antialias(methods::make_configs("strokes,ids", {}),
                                   {methods::Antialias::none, methods::Antialias::resolve4},
                                   1);
    const std::vector<std::string> lines = lines_of(methods_csv(configs));
    EXPECT_THAT(lines.at(5), HasSubstr(",8,true,"));
    EXPECT_THAT(lines.at(6), HasSubstr(",false,")) << "strengths";
    EXPECT_THAT(lines.at(7), HasSubstr(",true,")) << "its samples averaged";
}

}  // namespace
}  // namespace ink::harness
