#include "report/text/verdict.h"

#include <gmock/gmock.h>

#include <algorithm>
#include <sstream>

#include "core/text_table.h"
#include "summary/paired_differences.h"
#include "tests/report/made_up_rows.h"

namespace ink::report {
namespace {

using testing::AllOf;
using testing::HasSubstr;
using testing::Not;

/// Three views of two methods, with baselines: `rough` is cheap, `fine` is better on every view.
std::vector<harness::Row> small_comparison() {
    std::vector<harness::Row> rows;
    for (int i = 0; i < 3; ++i) {
        for (harness::Row row : {made_up_row("rough", 0.6, 2.0),
                                 made_up_row("fine", 0.9, 8.0),
                                 made_up_row("none", 0, 0),
                                 made_up_row("sampled", 0.97, 0),
                                 made_up_row("oracle", 1, 0)}) {
            row.scene = "cube";
            row.view = std::to_string(i);
            row.split = i == 2 ? "heldout" : "train";
            rows.push_back(row);
        }
    }
    return rows;
}

std::vector<std::string> lines_of(const std::string& text) {
    std::istringstream stream(text);
    std::vector<std::string> lines;
    for (std::string line; std::getline(stream, line);)
        lines.push_back(line);
    return lines;
}

std::vector<std::string> words_of(const std::string& line) {
    std::istringstream stream(line);
    return {std::istream_iterator<std::string>(stream), {}};
}

TEST(VerdictTable, WarnsWhereAMethodOfOneSampleBeatsSampled) {
    const auto rows = [](const char* method) {
        return std::vector{made_up_row(method, 0.98, 1.0),
                           made_up_row("none", 0, 0),
                           made_up_row("sampled", 0.87, 0),
                           made_up_row("oracle", 1, 0)};
    };
    const char* warning = "Warning: ids (F .980) above `sampled` (F .870)";
    EXPECT_THAT(verdict_table(rows("ids")), HasSubstr(warning));
    EXPECT_THAT(verdict_markdown(rows("ids")), HasSubstr(warning));
    // Drawn edges are no samples.
    EXPECT_THAT(verdict_table(rows("edge_list")), Not(HasSubstr("Warning")));
    EXPECT_THAT(verdict_table(small_comparison()), Not(HasSubstr("Warning")));
}

TEST(VerdictTable, ComparesAMethodThatSamplesCornersWithTheExactCorners) {
    const auto rows = [](double exact) {
        std::vector<harness::Row> all = {made_up_row("ids", 0.98, 1.0),
                                         made_up_row("sampled", 0.87, 0),
                                         made_up_row("exact_corner", exact, 0)};
        all.front().params = "of=patch;samples=corner;threshold=128";
        return all;
    };
    EXPECT_THAT(verdict_table(rows(0.99)), Not(HasSubstr("Warning")));
    EXPECT_THAT(verdict_table(rows(0.95)),
                HasSubstr("Warning: ids (F .980) above `exact_corner` (F .950)"));
}

TEST(VerdictTable, HasTheNumbersOfEachMethod) {
    const auto lines = lines_of(verdict_table(small_comparison()));
    EXPECT_THAT(words_of(lines.at(1)),
                testing::ElementsAre("rough",
                                     ".600",
                                     "-",  // one scene has no interval
                                     ".600",
                                     ".600",
                                     "-",  // no model took part
                                     "2.00",
                                     "5",
                                     "3"));
    EXPECT_THAT(words_of(lines.at(2)),
                testing::ElementsAre("fine", ".900", "-", ".900", ".900", "-", "8.00", "5", "3"));
}

TEST(VerdictTable, MarksTheBaselinesAndGivesThemNoTime) {
    const auto lines = lines_of(verdict_table(small_comparison()));
    const auto words = words_of(lines.at(5));
    EXPECT_EQ(words.at(0) + words.at(1), "oracle*");
    EXPECT_EQ(words.at(2), "1.000");
    EXPECT_EQ(words.at(7), "-");
}

TEST(VerdictTable, EndsWithOneSentence) {
    EXPECT_EQ(lines_of(verdict_table(small_comparison())).back(),
              "fine makes the fewest errors: F .900 at 2 px over 3 views pooled, 8.00 ms a frame, "
              "4.0 times as long as the cheapest, rough (2.00 ms, F .600). Best by part: fine on "
              "training scenes (F .900), fine on held-out scenes (F .900).");
}

TEST(VerdictTable, SaysOnWhichPartsItHolds) {
    std::vector<harness::Row> rows = small_comparison();
    for (harness::Row& row : rows)
        row.split = "real";
    EXPECT_THAT(lines_of(verdict_table(rows)).back(),
                HasSubstr("It holds for real models: no others took part."));
}

TEST(VerdictTable, SaysHowManyCellsFailed) {
    std::vector<harness::Row> rows = small_comparison();
    rows[0].status = "failed: out of ink";
    const std::string table = verdict_table(rows);
    EXPECT_THAT(table, HasSubstr("2/3"));
    EXPECT_THAT(table, HasSubstr("1 cell has no score and no part in these numbers."));
}

TEST(VerdictTable, SaysSoIfADifferenceIsNotSignificant) {
    std::vector<harness::Row> rows;
    for (int i = 0; i < 8; ++i) {
        harness::Row even = made_up_row("even", 0.7, 3);
        harness::Row moody = made_up_row("moody", i % 2 == 0 ? 0.5 : 0.91, 3);
        even.scene = moody.scene = std::to_string(i);
        rows.insert(rows.end(), {even, moody});
    }
    EXPECT_THAT(verdict_table(rows), HasSubstr("These scenes cannot tell it from even (F .700)"));
    EXPECT_THAT(verdict_table(small_comparison()), Not(HasSubstr("cannot tell")));
}

TEST(VerdictTable, SaysSoIfADifferenceIsSignificant) {
    std::vector<harness::Row> rows;
    for (int i = 0; i < 8; ++i) {
        harness::Row good = made_up_row("good", 0.7 + 0.01 * i, 3);
        harness::Row better = made_up_row("better", 0.72 + 0.01 * i, 3);
        good.scene = better.scene = std::to_string(i);
        rows.insert(rows.end(), {good, better});
    }
    EXPECT_THAT(
        verdict_table(rows),
        HasSubstr("Its paired difference to good (F .735) is +.020 [+.020, +.020]: significant."));
}

TEST(VerdictTable, NamesMethodsWholeAndFitsATerminal) {
    std::vector<harness::Row> rows = small_comparison();
    for (harness::Row& row : rows) {
        if (!harness::is_baseline(row.method))
            row.method += std::string(16 - row.method.size(), 'x');
    }
    rows[0].status = "failed";
    const std::string table = verdict_table(rows);
    EXPECT_THAT(table, AllOf(HasSubstr("\nfinexxxxxxxxxxxx "), HasSubstr("\nroughxxxxxxxxxxx ")));
    for (const std::string& line : lines_of(table.substr(0, table.rfind("\n\n"))))
        EXPECT_LE(line.size(), 90U) << line;
}

TEST(VerdictTable, WithoutAMethodThereIsNoVerdict) {
    EXPECT_EQ(verdict_table({}), "No method was scored on any view, so there is no verdict.");
    EXPECT_THAT(verdict_table({made_up_row("oracle", 1, 0)}), HasSubstr("there is no verdict"));
}

TEST(VerdictTable, AMethodAloneWinsNothing) {
    EXPECT_THAT(verdict_table({made_up_row("fine", 0.9, 8)}),
                HasSubstr("fine is the only method scored: F .900 at 2 px over 1 view pooled"));
}

TEST(VerdictMarkdown, IsATableOfEqualLines) {
    const auto lines = lines_of(verdict_markdown(small_comparison()));
    EXPECT_THAT(lines.at(0), HasSubstr("| method | F 2px | 95 % | train | held-out | real |"));
    EXPECT_THAT(lines.at(2), HasSubstr("| rough | .600 | - |"));
    const auto bars = [](const std::string& line) {
        return std::count(line.begin(), line.end(), '|');
    };
    for (std::size_t i = 1; i < 7; ++i)
        EXPECT_EQ(bars(lines.at(i)), bars(lines.at(0)));
}

TEST(VerdictTable, IsOneTableAndTheVerdictBelowIt) {
    const auto lines = lines_of(verdict_table(small_comparison()));
    ASSERT_EQ(lines.size(), 9U);  // headings, five methods, the star, a gap, the sentence
    EXPECT_EQ(lines.at(6), "`*` a baseline, no method");
    EXPECT_EQ(lines.at(7), "");
}

TEST(VerdictMarkdown, IsTheSameTableAndVerdict) {
    const std::string text = verdict_markdown(small_comparison());
    EXPECT_EQ(lines_of(text).size(), 11U);  // a rule below the headings, a gap below the table
    EXPECT_EQ(lines_of(text).back(), lines_of(verdict_table(small_comparison())).back());
}

TEST(FormatPairedDifference, HasTheIntervalIfThereIsOne) {
    EXPECT_EQ(
        summary::format_paired_difference({"a", "b", 0.0123, statistics::Interval{-0.002, 0.021}}),
        "+.012 [-.002, +.021]");
    // With three digits nobody could tell on which side of 0 it ends.
    EXPECT_EQ(summary::format_paired_difference(
                  {"a", "b", 0.0011, statistics::Interval{-0.0002, 0.0018}}),
              "+.0011 [-.0002, +.0018]");
    EXPECT_EQ(summary::format_paired_difference({"a", "b", -0.5, std::nullopt}), "-.500");
}

TEST(FormatShare, DropsTheZeroBeforeThePoint) {
    EXPECT_EQ(core::format_share(0.9124), ".912");
    EXPECT_EQ(core::format_share(1), "1.000");
    EXPECT_EQ(core::format_share(0), ".000");
    EXPECT_EQ(core::format_share(std::nullopt), "-");
}

TEST(FormatMs, KeepsThreeDigits) {
    EXPECT_EQ(format_ms(0.0421), "0.042");
    EXPECT_EQ(format_ms(3.096), "3.10");
    EXPECT_EQ(format_ms(9.996), "10.0");
    EXPECT_EQ(format_ms(12.34), "12.3");
    EXPECT_EQ(format_ms(99.96), "100");
    EXPECT_EQ(format_ms(1234.4), "1234");
}

TEST(VerdictTable, WarnsOfViewsInWhichRoundingShows) {
    std::vector<harness::Row> rows = small_comparison();
    EXPECT_THAT(verdict_table(rows), Not(HasSubstr("rounding")));
    for (harness::Row& row : rows)
        if (row.view == "1") row.rounding_px = 0.25;
    const auto says = AllOf(HasSubstr("in 1 view rounding of coordinates may move lines"),
                            HasSubstr("by 0.25 px in 1 of cube"));
    EXPECT_THAT(verdict_table(rows), says);
    EXPECT_THAT(verdict_markdown(rows), says);
}

}  // namespace
}  // namespace ink::report
