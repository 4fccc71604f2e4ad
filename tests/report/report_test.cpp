#include "report/report.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <sstream>

#include "core/error.h"
#include "core/escape.h"
#include "image_io/image_file.h"
#include "report/figures.h"
#include "report/html.h"
#include "report/page.h"
#include "report/page_scenes.h"
#include "report/page_verdict.h"
#include "tests/report/made_up_report.h"
#include "tests/report/markup.h"

namespace ink::report {
namespace {

namespace fs = std::filesystem;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::Not;

constexpr const char* kNasty = R"(<script>alert("1 & 2")</script>')";

/// What follows each `key` in `text`, a few characters of it.
std::vector<std::string> all_after(const std::string& text, const std::string& key) {
    std::vector<std::string> found;
    for (auto at = text.find(key); at != std::string::npos; at = text.find(key, at + 1)) {
        found.push_back(text.substr(at + key.size(), 5));
    }
    return found;
}

int count_of(const std::string& text, const std::string& word) {
    return static_cast<int>(all_after(text, word).size());
}

ReportData failed_report() {
    ReportData data = made_up_report({});
    for (harness::Row& row : data.rows) {
        harness::Row failed;
        failed.method = row.method;
        failed.scene = row.scene;
        failed.status = kNasty;
        row = failed;
    }
    data.views.clear();
    return data;
}

TEST(ReportPage, AsksForNothingFromOutside) {
    const std::string page = report_page(made_up_report({}));
    EXPECT_EQ(page.find("http"), std::string::npos);
    EXPECT_EQ(page.find("url("), std::string::npos);
    EXPECT_EQ(page.find("@import"), std::string::npos);
    EXPECT_EQ(page.find("<link"), std::string::npos);
    const auto sources = all_after(page, "src=\"");
    ASSERT_GT(sources.size(), 10U);
    for (const std::string& source : sources)
        EXPECT_EQ(source, "data:");
    for (const std::string& target : all_after(page, "href=\""))
        EXPECT_EQ(target[0], '#');
}

TEST(ReportPage, IsWellNestedWhateverThereIsToSay) {
    EXPECT_EQ(nesting_error(report_page(made_up_report({}))), "");
    EXPECT_EQ(nesting_error(report_page({})), "");
    EXPECT_EQ(nesting_error(report_page(made_up_report({.methods = {}}))), "");
    EXPECT_EQ(nesting_error(report_page(failed_report())), "");
    EXPECT_EQ(
        nesting_error(report_page(made_up_report({.scenes = 1, .views = 1, .methods = {"a"}}))),
        "");
}

TEST(ReportPage, HasEveryMethodOnEveryScene) {
    ReportData data = made_up_report({.scenes = 2, .methods = {"first", "second"}});
    for (harness::Row& row : data.rows) {
        // Pooled over the scene's three views; the other scene must not leak in.
        if (row.method == "second") row.k_2px = row.scene == "scene_1" ? 123 : 777;
    }
    const std::string html = scene_verdicts_html(data.rows);
    EXPECT_EQ(nesting_error(html), "");
    EXPECT_EQ(count_of(html, "<details"), 2);
    EXPECT_EQ(count_of(html, ">second</th>"), 2);
    const std::size_t of_second_scene = html.find("scene_2");
    ASSERT_NE(of_second_scene, std::string::npos);
    EXPECT_THAT(html.substr(0, of_second_scene), HasSubstr(">.123<"));
    EXPECT_THAT(html.substr(of_second_scene), HasSubstr(".777"));
    EXPECT_THAT(html.substr(of_second_scene), Not(HasSubstr(".123")));
    EXPECT_EQ(scene_verdicts_html({}), "");
}

TEST(NestingError, SeesWhatIsWrong) {
    EXPECT_EQ(nesting_error("<p><b>x</b><img src=\">\"></p>"), "");
    EXPECT_EQ(nesting_error("<p><b>x</p></b>"), "</p> closes <b>");
    EXPECT_EQ(nesting_error("<p>"), "<p> is never closed");
    EXPECT_EQ(nesting_error("</p>"), "</p> closes nothing");
    EXPECT_EQ(nesting_error("<p a=1 <b>"), "a bare < in a tag");
}

TEST(ReportPage, EscapesEveryName) {
    ReportData data = made_up_report({.scene_prefix = kNasty});
    data.command = kNasty;
    for (harness::Row& row : data.rows) {
        row.view = std::string(kNasty) + row.view;
        row.params = kNasty;
    }
    for (harness::ShownView& view : data.views)
        view.view = std::string(kNasty) + view.view;
    const std::string page = report_page(data);
    EXPECT_EQ(count_of(page, "<script>"), 1) << "our own";
    EXPECT_EQ(page.find("alert(\"1"), std::string::npos);
    EXPECT_THAT(page, HasSubstr("&lt;script&gt;alert(&quot;1 &amp; 2&quot;)&lt;/script&gt;&#39;"));
    EXPECT_EQ(nesting_error(page), "");
}

TEST(ReportPage, ListsFailedCellsWithTheirStatusAndOnlyThen) {
    EXPECT_THAT(report_page(made_up_report({})), Not(HasSubstr("id=\"failed\"")));
    const std::string page = report_page(failed_report());
    EXPECT_THAT(page, HasSubstr("id=\"failed\""));
    EXPECT_THAT(page, HasSubstr("No verdict: no method was scored"));
    EXPECT_THAT(page, HasSubstr("&lt;script&gt;alert"));
}

TEST(ReportPage, NamesTheWinner) {
    const std::string page = report_page(made_up_report({}));
    EXPECT_THAT(page, HasSubstr("<h1>decaudin makes the fewest errors</h1>"));
}

TEST(ReportPage, ShowsEverySceneAndEveryMethodOfIt) {
    const std::string page = report_page(made_up_report({.scenes = 3}));
    EXPECT_EQ(count_of(page, "<article class=\"scene\""), 3);
    EXPECT_EQ(count_of(page, "type=\"range\""), 3);
    EXPECT_EQ(count_of(page, "type=\"radio\""), 3 * 5) << "four methods and the ceiling";
    EXPECT_EQ(count_of(page, " checked>"), 3);
    EXPECT_EQ(count_of(page, "class=\"pred on\""), 3);
}

TEST(ReportPage, SaysHowFarTruthAndCrosscheckAgree) {
    ReportData data = made_up_report({.scenes = 2, .views = 2});
    const std::string heading = "id=\"crosscheck\"";
    EXPECT_THAT(report_page(data), Not(HasSubstr(heading))) << "none was asked";
    for (harness::Row& row : data.rows) {
        row.crosscheck_px = row.view == "front" ? 3000 : 1000;
        row.reference_disagreement = row.view == "front" ? 0.0001 : 0.0005;
    }
    // Pooled: (3000 x 0.0001 + 1000 x 0.0005) / 4000 in both scenes.
    const std::string agreed = report_page(data);
    EXPECT_THAT(agreed, HasSubstr(heading));
    EXPECT_THAT(agreed,
                HasSubstr("disagree on 0.020 % of their lines over 4 views, at worst on 0.050 % "
                          "(scene_1 orbit_1)."));
    EXPECT_EQ(count_of(agreed, "<td class=\"text\">agreed</td>"), 2);
    EXPECT_THAT(agreed, Not(HasSubstr("Reference disagreement")));

    for (harness::Row& row : data.rows) {
        if (row.scene != "scene_2" || row.view != "orbit_1") continue;
        row.reference_disagreement = 0.04;
        row.status = "reference_disagreement: the cross-check disagrees on 4.000 % of the lines";
    }
    const std::string disputed = report_page(data);
    EXPECT_THAT(disputed, HasSubstr("at worst on 4.000 % (scene_2 orbit_1)."));
    EXPECT_THAT(disputed, HasSubstr("Reference disagreement"));
    EXPECT_THAT(disputed, HasSubstr("<li>scene_2, view orbit_1</li>"));
    EXPECT_EQ(count_of(disputed, "<td class=\"text\">agreed</td>"), 1);
    EXPECT_THAT(disputed, HasSubstr("<td>4.000</td><td>1000</td>"));
    EXPECT_EQ(nesting_error(disputed), "");
}

TEST(ReportPage, SaysWhyARunIsInvalid) {
    EXPECT_THAT(report_page(made_up_report({})), Not(HasSubstr("This run is invalid")));
    ReportData data = made_up_report({});
    data.faults = {"oracle has F = 0.990000 on <scene> view0, not 1"};
    const std::string page = report_page(data);
    EXPECT_THAT(page, HasSubstr("This run is invalid"));
    EXPECT_THAT(page, HasSubstr("<li>oracle has F = 0.990000 on &lt;scene&gt; view0, not 1</li>"));
}

TEST(ReportPage, SaysWhatAnInterruptedRunLacks) {
    ReportData data = made_up_report({});
    EXPECT_THAT(report_page(data), Not(HasSubstr("This run is not finished")));
    data.blocks = 40;
    for (int i = 0; i < 25; ++i)
        data.missing_blocks.push_back("cube & ball view" + std::to_string(i));
    const std::string page = report_page(data);
    EXPECT_THAT(page, HasSubstr("25 of 40 parts are missing"));
    EXPECT_THAT(page, HasSubstr("<li>cube &amp; ball view19</li><li>and 5 more</li>"));
    EXPECT_EQ(nesting_error(page), "");
}

TEST(ReportPage, NamesViewsWithoutAScoreWithReasonAndRemedy) {
    ReportData data = made_up_report({.scenes = 2});
    EXPECT_THAT(report_page(data), Not(HasSubstr("Some views have no score")));
    for (harness::Row& row : data.rows)
        if (row.scene == "scene_2") row.status = "too_large: 5 lines";
    const std::string page = report_page(data);
    EXPECT_THAT(page, HasSubstr("Some views have no score"));
    EXPECT_THAT(page, HasSubstr("too_large: 5 lines<br>Try: a smaller --size"));
    EXPECT_EQ(nesting_error(page), "");
}

TEST(EncodeScenes, ShrinksAndThenLeavesOutToStayInTheBudget) {
    const ReportData data = made_up_report({.scenes = 4, .width_px = 640, .height_px = 360});
    const PageScenes whole = encode_scenes(data.views, 100'000'000);
    EXPECT_EQ(whole.shrink_factor, 1);
    EXPECT_EQ(whole.left_out, 0U);
    std::size_t size = 0;
    for (const PageScene& scene : whole.scenes) {
        for (const PagePicture& image : scene.images)
            size += image.size();
    }
    const PageScenes smaller = encode_scenes(data.views, size - 1);
    EXPECT_GT(smaller.shrink_factor, 1);
    EXPECT_EQ(smaller.scenes.size(), 4U);
    const PageScenes none = encode_scenes(data.views, 1000);
    EXPECT_EQ(none.scenes.size(), 0U);
    EXPECT_EQ(none.left_out, 4U);
}

TEST(Escape, LeavesNothingThatMeansSomething) {
    EXPECT_EQ(core::escape("a<b>&\"'\x01\x7f"), "a&lt;b&gt;&amp;&quot;&#39;");
    EXPECT_EQ(core::escape("Würfel 立方体\n"), "Würfel 立方体\n");
}

TEST(Base64, MatchesTheExamplesOfRfc4648) {
    const auto encoded = [](std::string_view text) {
        return base64({reinterpret_cast<const std::uint8_t*>(text.data()), text.size()});
    };
    EXPECT_EQ(encoded(""), "");
    EXPECT_EQ(encoded("f"), "Zg==");
    EXPECT_EQ(encoded("fo"), "Zm8=");
    EXPECT_EQ(encoded("foo"), "Zm9v");
    EXPECT_EQ(encoded("foobar"), "Zm9vYmFy");
    EXPECT_EQ(encoded("\xff\xfe\xfd"), "//79");
}

class ReportFiles : public testing::Test {
  protected:
    void SetUp() override {
        fs::remove_all(folder_);
        fs::create_directories(folder_);
    }
    void TearDown() override { fs::remove_all(folder_); }

    std::string text_of(const fs::path& path) {
        std::ostringstream text;
        text << std::ifstream(path).rdbuf();
        return text.str();
    }
    std::vector<std::string> names() {
        std::vector<std::string> found;
        for (const auto& entry : fs::recursive_directory_iterator(folder_)) {
            if (!entry.is_directory()) found.push_back(fs::relative(entry.path(), folder_));
        }
        return found;
    }
    fs::path folder_ = fs::path(testing::TempDir()) /
                       ("ink_report_test_" +  // of one test: others run beside it
                        std::string(testing::UnitTest::GetInstance()->current_test_info()->name()));
};

TEST_F(ReportFiles, TheReportIsOneFile) {
    write_report(made_up_report({}), folder_ / "report.html");
    EXPECT_THAT(names(), testing::ElementsAre("report.html"));
    EXPECT_THAT(text_of(folder_ / "report.html"), testing::EndsWith("</html>\n"));
}

TEST_F(ReportFiles, AnUnwritablePlaceIsAnErrorThatLeavesNothing) {
    EXPECT_THROW(write_report({}, folder_ / "nowhere" / "report.html"), core::Error);
    fs::create_directories(folder_ / "taken" / "full");
    EXPECT_THROW(write_report({}, folder_ / "taken"), core::Error);
    EXPECT_THAT(names(), IsEmpty());
}

TEST_F(ReportFiles, FiguresAreStripsAndCharts) {
    write_figures(made_up_report({.scenes = 2}), folder_);
    EXPECT_THAT(names(),
                testing::UnorderedElementsAre("figures/scene_1.png",
                                              "figures/scene_2.png",
                                              "figures/overview.png",
                                              "figures/fronts.svg",
                                              "figures/classes.svg",
                                              "figures/causes.svg",
                                              "figures/cancellation.svg"));
    EXPECT_EQ(nesting_error(text_of(folder_ / "figures/fronts.svg")), "");
    EXPECT_THAT(text_of(folder_ / "figures/fronts.svg"), HasSubstr(">decaudin</text>"));
    EXPECT_EQ(nesting_error(text_of(folder_ / "figures/classes.svg")), "");
    EXPECT_EQ(nesting_error(text_of(folder_ / "figures/causes.svg")), "");
    EXPECT_THAT(text_of(folder_ / "figures/causes.svg"), HasSubstr(">decaudin</text>"));
}

TEST_F(ReportFiles, StripsOfManyMethodsGoOnBelow) {
    // The truth, 17 methods and the ceiling: 19 pictures of 160 x 90 in three lines of seven.
    std::vector<std::string> methods;
    for (int i = 1; i <= 17; ++i)
        methods.push_back("method" + std::to_string(i));
    write_figures(made_up_report({.scenes = 4, .methods = methods}), folder_);
    const auto strip = image_io::read_gray(folder_ / "figures/scene_1.png");
    EXPECT_EQ(strip.width_px(), 7 * (160 + 12) + 12);
    EXPECT_GE(strip.height_px(), 3 * (90 + 12 + 30));
    const auto overview = image_io::read_gray(folder_ / "figures/overview.png");
    EXPECT_EQ(overview.width_px(), strip.width_px());
    EXPECT_LT(overview.height_px(), 4 * strip.height_px());  // 72 pictures: three strips of four
}

TEST_F(ReportFiles, FiguresOfScenesWithOneFileNameDoNotOverwriteEachOther) {
    ReportData data = made_up_report({.scenes = 3, .views = 1});
    data.views[0].scene = "a/b";
    data.views[1].scene = "a:b";
    data.views[2].scene = "overview";
    write_figures(data, folder_);
    EXPECT_THAT(names(),
                testing::IsSupersetOf({"figures/a_b.png",
                                       "figures/a_b.2.png",
                                       "figures/overview.2.png",
                                       "figures/overview.png"}));
}

TEST_F(ReportFiles, FiguresWithoutAnythingToShowAreEmptyCharts) {
    write_figures({}, folder_);
    EXPECT_THAT(names(),
                testing::UnorderedElementsAre("figures/fronts.svg",
                                              "figures/classes.svg",
                                              "figures/causes.svg",
                                              "figures/cancellation.svg"));
}

TEST_F(ReportFiles, FiguresThatCannotBeWrittenAreAnError) {
    std::ofstream(folder_ / "figures") << "in the way";
    EXPECT_THROW(write_figures({}, folder_), core::Error);
}

TEST(FileStem, IsAlwaysAPlainName) {
    EXPECT_EQ(file_stem("dragon-2.ply"), "dragon-2.ply");
    EXPECT_EQ(file_stem("../etc/passwd"), "_.._etc_passwd");
    EXPECT_EQ(file_stem("a b<c>"), "a_b_c_");
    EXPECT_EQ(file_stem(""), "_");
    EXPECT_EQ(file_stem(std::string(300, 'x')).size(), 80U);
}

}  // namespace
}  // namespace ink::report
