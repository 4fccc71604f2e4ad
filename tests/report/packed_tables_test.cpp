#include "report/packed_run.h"

#include <gmock/gmock.h>

#include <nlohmann/json.hpp>

#include "report/page_template.h"

namespace ink::report {
namespace {

TEST(JsonText, IsSafeInsideAScript) {
    EXPECT_EQ(page_json("a\"b\n"), R"("a\"b\n")");
    EXPECT_EQ(page_json("</script><b>"), R"("\u003c/script>\u003cb>")");
    EXPECT_EQ(nlohmann::json::parse(page_json("</script>")), "</script>");
    EXPECT_TRUE(nlohmann::json::accept(page_json("\xff\xfe broken")));
}

TEST(PackedColumn, KeepsTheDigitsOfNumbers) {
    EXPECT_EQ(packed_column({"0.1", "", "1e-7", "-3"}), "[0.1,null,1e-7,-3]");
    EXPECT_EQ(packed_column({"true", "false"}), "[true,false]");
    EXPECT_EQ(packed_column({"inf", "-inf", "nan", "1"}), R"(["inf","-inf",null,1])");
}

TEST(PackedColumn, NamesRepeatedTextsOnce) {
    EXPECT_EQ(packed_column({"ids", "", "mote4", "ids"}),
              R"({"words":["ids","mote4"],"at":[0,-1,1,0]})");
}

TEST(PackedColumn, OneValueOnEveryLineStandsOnce) {
    EXPECT_EQ(packed_column({"640", "640", "640"}), R"({"constant":640})");
    EXPECT_EQ(packed_column({"a", "a"}), R"({"constant":"a"})");
    EXPECT_EQ(packed_column({"", ""}), R"({"constant":null})");
    EXPECT_EQ(packed_column({"7"}), "[7]");
    EXPECT_EQ(packed_column({}), "[]");
}

TEST(PackedColumn, CodesThatJavaScriptWouldRoundOrRefuseAreTexts) {
    EXPECT_EQ(packed_column({"12345678901234567", "1"}),
              R"({"words":["12345678901234567","1"],"at":[0,1]})");
    EXPECT_EQ(packed_column({"007", "1"}), R"({"words":["007","1"],"at":[0,1]})");
    EXPECT_EQ(packed_column({"-01", "1"}), R"({"words":["-01","1"],"at":[0,1]})");
}

TEST(PackedTable, IsJsonWithAColumnEach) {
    const core::CsvTable table = core::split_csv("method,f\n\"a,b\",0.5\nids,\n", "rows.csv");
    const auto columns = nlohmann::json::parse(packed_columns(table));
    EXPECT_EQ(columns["method"]["words"], (std::vector<std::string>{"a,b", "ids"}));
    EXPECT_EQ(columns["f"], nlohmann::json::parse("[0.5,null]"));
    EXPECT_EQ(packed_table(table)["lines"], 2);
}

}  // namespace
}  // namespace ink::report
