#include <fmt/format.h>
#include <gmock/gmock.h>

#include <string>

#include "tests/program/run_program.h"

// methods/measured.py on a small page: its tables are what compare says.

namespace ink::program {
namespace {

using testing::AllOf;
using testing::HasSubstr;
using testing::StartsWith;

constexpr const char* kAsked =
    "<!-- measured: --scenes cube --views 1 --size 160x90 --methods polygon_offset\n"
    "-\n"
    "factor=-4\n"
    "columns: f_2px precision_2px recall_contour\n"
    "-->\n";

Outcome measured(const Desk& desk, Words words) {
    words.insert(words.begin(), {"-B", INK_SOURCE_DIR "/methods/measured.py"});
    words.insert(words.end(), {"--program", INK_PROGRAM});
    return desk.run_other("/usr/bin/python3", words);
}

TEST(MeasuredTables, AreMadeAgainAndNothingElseIs) {
    const Desk desk;
    desk.write("page.md", std::string("before\n") + kAsked + "old\n<!-- /measured -->\nafter\n");
    const Outcome check = measured(desk, {"page.md", "--check"});
    EXPECT_EQ(check.exit_code, 1) << check.err;
    EXPECT_THAT(desk.read("page.md"), HasSubstr("old")) << "a check writes nothing";
    const Outcome outcome = measured(desk, {"page.md"});
    ASSERT_EQ(outcome.exit_code, 0) << outcome.err;
    const std::string page = desk.read("page.md");
    EXPECT_THAT(page,
                AllOf(StartsWith(std::string("before\n") + kAsked +
                                 "| setting | F | precision | recall of contour |\n"
                                 "|---|--:|--:|--:|\n| defaults | 0."),
                      HasSubstr("\n| `factor=-4` | 0."),
                      HasSubstr("|\n<!-- /measured -->\nafter\n")));
    EXPECT_EQ(measured(desk, {"page.md", "--check"}).exit_code, 0) << "it is as it was made";

    expect_done(
        desk,
        "compare --scenes cube --views 1 --size 160x90 --methods polygon_offset --no-sweep --out "
        "out");
    const Table rows = parse_csv(desk.read("out/rows.csv"));
    for (const auto& row : rows) {
        if (row.at("method") != "polygon_offset") continue;
        EXPECT_THAT(page,
                    HasSubstr(fmt::format("| defaults | {:.3f} | {:.3f} | {:.3f} |",
                                          std::stod(row.at("f_2px")),
                                          std::stod(row.at("precision_2px")),
                                          std::stod(row.at("recall_contour")))));
    }
}

TEST(MeasuredTables, RefuseAPageThatAsksForWhatIsNotThere) {
    const Desk desk;
    const auto refused = [&](const std::string& asked) {
        const std::string text = asked + "old\n<!-- /measured -->\n";
        desk.write("page.md", text);
        const Outcome outcome = measured(desk, {"page.md"});
        EXPECT_EQ(outcome.exit_code, 2);
        EXPECT_EQ(desk.read("page.md"), text);
        return outcome.err;
    };
    const std::string head =
        "<!-- measured: --scenes cube --size 160x90 --methods polygon_offset\n";
    EXPECT_THAT(refused(head + "-\ncolumns: speed\n-->\n"), HasSubstr("no column speed"));
    EXPECT_THAT(refused(head + "fctor=1\ncolumns: f_2px\n-->\n"), HasSubstr("fctor"));
    EXPECT_THAT(refused(head + "-->\n"), HasSubstr("settings and columns"));
    desk.write("page.md", head + "-\ncolumns: f_2px\n-->\n");
    EXPECT_THAT(measured(desk, {"page.md"}).err, HasSubstr("does not end"));
}

}  // namespace
}  // namespace ink::program
