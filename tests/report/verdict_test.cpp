#include "report/text/verdict.h"

#include <gmock/gmock.h>

#include <algorithm>
#include <sstream>

#include "core/text_table.h"
#include "tests/report/made_up_rows.h"

namespace ink::report {
namespace {

using testing::AllOf;
using testing::ContainsRegex;
using testing::HasSubstr;
using testing::Not;

/// What a run is asked, and how much of it is missing.
struct Asked {
    summary::AnswerRule rule = {};
    Missing missing = {};
};

std::string verdict_table(const std::vector<harness::Row>& rows, const Asked& asked = {}) {
    return report::verdict_table(rows, summary::compare_methods(rows, asked.rule), asked.missing);
}

std::string verdict_markdown(const std::vector<harness::Row>& rows, const Asked& asked = {}) {
    return report::verdict_markdown(
        rows, summary::compare_methods(rows, asked.rule), asked.missing);
}

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

constexpr const char* kAnswer =
    " finds 90.0 % of the outline, and 90.0 % of what it draws is right, in 8.00 ms. Its F is "
    "0.900, the highest. ";
constexpr const char* kRest =
    " has 0.600 in 2.00 ms (-0.300). 1 scene is too few for an interval. F is at 2 px, over 3 "
    "views of 1 scene pooled. Best by part: fine on training scenes (F .900), fine on held-out "
    "scenes (F .900).";

TEST(VerdictTable, IsATableWithTheAnswerBelowIt) {
    // One scene has no interval, and no model took part.
    EXPECT_EQ(verdict_table(small_comparison()),
              std::string(R"(method     F 2px  80 %  train  held-out  real  draw ms  B/px  views
rough       .600     -   .600      .600     -     2.00     5      3
fine        .900     -   .900      .900     -     8.00     5      3
none *      .000     -   .000      .000     -        -     -      3
sampled *   .970     -   .970      .970     -        -     -      3
oracle *   1.000     -  1.000     1.000     -        -     -      3
`*` a baseline, no method

fine)") + kAnswer +
                  "rough" + kRest);
}

TEST(VerdictMarkdown, IsTheSameTableAndAnswer) {
    EXPECT_THAT(
        verdict_markdown(small_comparison()),
        testing::StartsWith(
            std::string(
                R"(| method | F 2px | 80 % | train | held-out | real | draw ms | B/px | views |
|---|--:|--:|--:|--:|--:|--:|--:|--:|
| rough | .600 | - | .600 | .600 | - | 2.00 | 5 | 3 |
| fine | .900 | - | .900 | .900 | - | 8.00 | 5 | 3 |
| none * | .000 | - | .000 | .000 | - | - | - | 3 |
| sampled * | .970 | - | .970 | .970 | - | - | - | 3 |
| oracle * | 1.000 | - | 1.000 | 1.000 | - | - | - | 3 |

`*` a baseline, no method

**fine**)") +
            kAnswer + "`rough`" + kRest + "\n\nFor a paper: "));
}

/// `count` scenes of two methods: `quick`, and `exact` that is better by .006 on all but the first,
/// or on which they swap in turns.
std::vector<harness::Row> close_comparison(int count, bool in_turns = false) {
    std::vector<harness::Row> rows;
    for (int i = 0; i < count; ++i) {
        const bool is_swapped = in_turns ? i % 2 == 1 : i == 0;
        harness::Row quick = made_up_row("quick", (is_swapped ? 0.986 : 0.980) - 0.005 * i, 1.6);
        harness::Row exact = made_up_row("exact", (is_swapped ? 0.980 : 0.987) - 0.005 * i, 13);
        quick.scene = exact.scene = std::to_string(i);
        quick.split = exact.split = "real";
        rows.insert(rows.end(), {quick, exact});
    }
    return rows;
}

TEST(VerdictTable, NamesTheCheapestWithinTheMarginAndThenTheMostExact) {
    const auto rows = close_comparison(12);
    EXPECT_THAT(
        verdict_table(rows),
        AllOf(HasSubstr(
                  "\nquick finds 95.3 % of the outline, and 95.3 % of what it draws is right, in "
                  "1.60 ms. Its F is 0.953; none is higher by more than 0.01. The most exact, "
                  "exact, leads with 0.959 in 13.0 ms, 8.1 times as long (+0.006 ["),
              HasSubstr("], 85 % interval over 12 models).")));
    EXPECT_THAT(verdict_markdown(rows),
                AllOf(HasSubstr("\n**quick** finds"), HasSubstr("The most exact, `exact`, leads")));
    EXPECT_THAT(
        verdict_table(rows, {.rule = {.f_margin = 0.001}}),
        HasSubstr("in 13.0 ms. Its F is 0.959, the highest. It leads: quick has 0.953 in 1.60 ms"));
    EXPECT_THAT(
        verdict_table(rows, {.rule = {.budget_ms = 5}}),
        AllOf(HasSubstr("\nWithin 5.00 ms, quick finds"),
              HasSubstr("in 1.60 ms. Its F is 0.953; it is the only method in that time.")));
    EXPECT_THAT(
        verdict_table(rows, {.rule = {.budget_ms = 1}}),
        HasSubstr("\nWithin 1.00 ms, none has a score: none is faster than 1.60 ms (quick)."));
}

// At a margin that lies on the gap, drawings of scenes name now the one, now the other.
TEST(VerdictTable, NamesBothWhereTheChoiceOfScenesDecides) {
    const auto rows = close_comparison(12);
    const Asked on_the_gap = {.rule = {.f_margin = 0.0061}};
    EXPECT_THAT(
        verdict_table(rows, on_the_gap),
        AllOf(
            ContainsRegex(
                "\nquick finds 95.3 % .* in 1.60 ms; or exact finds 95.9 % .* in 13.0 ms."),
            ContainsRegex(" [0-9]+ % of drawings of scenes name the second: quick is 0.0059 below "
                          "the best, and the margin is 0.0061.")));
    EXPECT_THAT(verdict_markdown(rows, on_the_gap), HasSubstr("in 1.60 ms; or **exact** finds"));
    EXPECT_THAT(verdict_table(rows), Not(HasSubstr("drawings of scenes")));
}

TEST(VerdictTable, NamesWhatTimesCannotTellApart) {
    std::vector<harness::Row> rows = small_comparison();
    for (harness::Row& row : rows)
        if (row.method == "rough") row.draw_ns = 6'600'000;
    const Asked options = {.rule = {.f_margin = 0.5}};
    EXPECT_THAT(
        verdict_table(rows, options),
        ContainsRegex("\nfine finds .* Its F is 0.900, the highest. rough has 0.600 .* Another "
                      "run may name rough: the times are that close."));
    EXPECT_THAT(verdict_table(small_comparison(), options), Not(HasSubstr("may name")));
}

TEST(VerdictTable, OfFewScenesHasNoInterval) {
    const std::string table = verdict_table(close_comparison(4));
    EXPECT_THAT(table,
                HasSubstr("(+0.004). 4 models are too few for an interval; better on 3 of 4."));
    EXPECT_THAT(table,
                AllOf(Not(HasSubstr("[")), Not(HasSubstr("leads")), Not(HasSubstr("cover"))));
    EXPECT_THAT(verdict_table(close_comparison(6)), HasSubstr("["));
}

TEST(VerdictTable, OfARunThatIsNotFinishedSaysSoFirst) {
    const Asked cut_off{.missing = {3, 12}};
    const char* first =
        "This run is not finished: 3 of 12 parts are missing, and every number is of "
        "the rest.\n\n";
    EXPECT_THAT(verdict_table(small_comparison(), cut_off), testing::StartsWith(first));
    EXPECT_THAT(verdict_markdown(small_comparison(), cut_off), testing::StartsWith(first));
}

TEST(VerdictMarkdown, SaysHowManyTimesAreUncertainWhereAnyAre) {
    std::vector<harness::Row> rows = small_comparison();
    for (harness::Row& row : rows)
        row.draw_n = row.draw_ns ? 9 : 0;
    const std::string quiet = verdict_markdown(rows, {});
    EXPECT_THAT(quiet, Not(HasSubstr("busy")));
    rows[0].time_doubt = "waited";
    rows[6].time_doubt = "spread";
    EXPECT_EQ(verdict_markdown(rows, {}),
              quiet + "\nbusy machine: times of 2 of 6 cells are uncertain.\n");
}

TEST(VerdictTable, SaysWhichSceneAnErrorSitsIn) {
    std::vector<harness::Row> rows = close_comparison(6);
    rows[3].k_2px = 300;
    EXPECT_THAT(verdict_table(rows),
                AllOf(HasSubstr("exact has 0.860 (83 % of its error in 1) in 13.0 ms"),
                      HasSubstr("\nMost of the error in one scene: exact 83 % in 1.")));
    rows[2].k_2px = 300;
    EXPECT_THAT(verdict_table(rows), HasSubstr(" quick has 8"));
}

TEST(VerdictMarkdown, HasASentenceForAPaper) {
    std::vector<harness::Row> rows = close_comparison(4);
    for (harness::Row& row : rows) {
        row.width = 640;
        row.height = 360;
    }
    EXPECT_THAT(
        verdict_markdown(rows),
        HasSubstr("\nFor a paper: Over 4 models (4 views of 640x360 px), quick has F = 0.974 "
                  "at 2 px in 1.60 ms; the most exact method, exact, has F = 0.978 in 13.0 "
                  "ms, 8.1 times as long (difference +0.004).\n"));
}

// `quick` is as good as `exact` within 2 px, and its ink is far from it.
TEST(VerdictTable, IsBySoftFWhereInkWasScored) {
    std::vector<harness::Row> rows = close_comparison(7);
    for (harness::Row& row : rows) {
        const double matched = row.method == "quick" ? 700 : 980;
        row.soft = {1.5, matched, 0, 1000 - matched, 1000 - matched};
    }
    const std::string table = verdict_table(rows);
    EXPECT_THAT(lines_of(table).at(0),
                ContainsRegex("method +soft F +80 % +train +held-out +real +F 2px"));
    EXPECT_THAT(lines_of(table).at(2), ContainsRegex("exact +.980 +.980-.980 +- +- +.980 +.971"));
    for (const std::string& line : lines_of(table.substr(0, table.rfind("\n\n"))))
        EXPECT_LE(line.size(), 90U) << line;
    EXPECT_THAT(
        table,
        AllOf(HasSubstr(
                  "\nexact finds 98.0 % of the ink, and 98.0 % of the ink it draws is right, "
                  "in 13.0 ms. Its soft F is 0.980, the highest. It leads: quick has 0.700 in 1.60 "
                  "ms (-0.280 ["),
              HasSubstr("Soft F is of lines 1.5 px wide, over 7 views of 7 scenes pooled. "
                        "It holds for real models")));
    EXPECT_THAT(verdict_markdown(rows),
                HasSubstr("exact has soft F = 0.980 of lines 1.5 px wide in 13.0 ms; the next, "
                          "quick, has soft F = 0.700 in 1.60 ms"));
}

TEST(VerdictTable, SaysHowManyCellsFailed) {
    std::vector<harness::Row> rows = small_comparison();
    rows[0].status = "failed: out of ink";
    const std::string table = verdict_table(rows);
    EXPECT_THAT(table, HasSubstr("2/3"));
    EXPECT_THAT(table, HasSubstr("1 cell has no score and no part in these numbers."));
}

TEST(VerdictTable, SaysHowManyScenesAndViewsHaveAScore) {
    std::vector<harness::Row> rows = close_comparison(12);
    for (harness::Row& row : rows)
        if (row.scene == "0") row.status = "crowded";
    EXPECT_THAT(verdict_table(rows), HasSubstr("over 11 of 12 views of 11 of 12 scenes pooled."));
    EXPECT_THAT(verdict_table(close_comparison(12)),
                HasSubstr("over 12 views of 12 scenes pooled."));
}

TEST(VerdictTable, SaysThatAMethodLeadsOnlyWhereItDoes) {
    const auto rows = [](double lead) {
        std::vector<harness::Row> all;
        for (int i = 0; i < 8; ++i) {
            harness::Row even = made_up_row("even", 0.7, 3);
            harness::Row other = made_up_row("other", i % 2 == 0 ? 0.7 + lead : 0.91, 3);
            even.scene = other.scene = std::to_string(i);
            all.insert(all.end(), {even, other});
        }
        return all;
    };
    EXPECT_THAT(verdict_table(rows(-0.2)), AllOf(HasSubstr("even has"), Not(HasSubstr("lead"))));
    EXPECT_THAT(verdict_table(rows(0.2)), HasSubstr("the highest. It leads: even has 0.700"));
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

TEST(VerdictTable, SaysThatAllIsFoundOnlyWhereAllIs) {
    harness::Row row = made_up_row("fine", 1, 8);
    EXPECT_THAT(verdict_table({row}), HasSubstr("finds 100 % of the outline"));
    row.n_truth = 10'000;
    row.k_2px = row.n_pred = 9'999;
    EXPECT_THAT(verdict_table({row}), HasSubstr("finds 99.9 % of the outline, and 100 % of what"));
    row.k_2px = row.n_pred = 0;
    EXPECT_THAT(verdict_table({row}), HasSubstr("0.0 % of the outline, and nothing of what"));
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
