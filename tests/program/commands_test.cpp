#include <fmt/format.h>
#include <gmock/gmock.h>

#include <algorithm>
#include <filesystem>
#include <map>
#include <regex>
#include <set>

#include "tests/program/run_program.h"
#include "tests/report/markup.h"

// The commands as a user runs them, on scenes small enough to be quick.

namespace ink::program {
namespace {

using testing::AllOf;
using testing::Contains;
using testing::ContainsRegex;
using testing::HasSubstr;
using testing::Key;
using testing::Not;
using testing::StartsWith;

TEST(Version, NamesTheLibraries) {
    const std::string version = expect_done(Desk(), {"--version"});
    EXPECT_THAT(version, StartsWith("inkbench "));
    for (const char* library : {"embree", "openimageio", "onetbb", "fmt", "glm"}) {
        EXPECT_TRUE(std::regex_search(version, std::regex(std::string(library) + " +[0-9]+\\.")))
            << library << " in\n"
            << version;
    }
}

TEST(List, NamesMethodsScenesAndParametersOnAScreen) {
    const Desk desk;
    const std::string names = expect_done(desk, {"list"});
    EXPECT_LT(std::count(names.begin(), names.end(), '\n'), 80);
    for (const std::string& all : {names, expect_done(desk, "list all")}) {
        for (const char* word :
             {"decaudin", "mote2", "mote4", "mote16", "torus", "threshold", "f_2px"})
            EXPECT_THAT(all, HasSubstr(word));
    }
}

TEST(List, TellsTheSameAsJson) {
    const Desk desk;
    const auto all = expect_json(desk, "list --json");
    for (const char* topic :
         {"methods", "scenes", "params", "metrics", "skips", "shadings", "axes"}) {
        const auto one = expect_json(desk, fmt::format("list {} --json", topic));
        EXPECT_EQ(one, nlohmann::json({{topic, all.at(topic)}}));
        const std::string text = expect_done(desk, {"list", topic});
        for (const auto& entry : all.at(topic)) {
            const auto name = entry.at(entry.contains("method") ? "method" : "name");
            EXPECT_THAT(text, HasSubstr(name.get<std::string>()));
        }
    }
    refusal(desk, "list nothing --json");
    EXPECT_THAT(expect_done(desk, "list methods"),
                ContainsRegex("shader: [0-9]+/[0-9]+/[0-9]+ instructions of "
                              "vertex/fragment/pixel on RDNA2, "));
}

TEST(List, GivesMethodsAsATableToo) {
    const Desk desk;
    const Table table = parse_csv(expect_done(desk, "list methods --csv"));
    const Table tuned = only(table, "mote4_tuned");
    ASSERT_EQ(tuned.size(), 1U);
    EXPECT_EQ(tuned[0].at("family"), "packed");
    EXPECT_EQ(tuned[0].at("preset_of"), "mote4");
    EXPECT_EQ(only(table, "sampled").at(0).at("role"), "one_sample");
    EXPECT_THAT(refusal(desk, "list scenes --csv"), HasSubstr("inkbench list methods --csv"));
}

TEST(Compare, WritesRowsCurvesAndAReport) {
    const Desk desk;
    const std::string out =
        expect_done(desk,
                    "compare --scenes torus --methods mote4,decaudin --size 320x180 --out out "
                    "--set mote4.threshold=77 --seed 5");
    EXPECT_THAT(out, AllOf(HasSubstr("mote4"), HasSubstr("out/report.html")));
    const Table rows = rows_of(desk);
    ASSERT_FALSE(rows.empty());
    for (const std::string& column :
         Words("method scene view split width height threads seed params status f_2px f_1px "
               "precision_2px recall_2px recall_contour recall_boundary recall_crease "
               "recall_intersection recall_seam mean_width_px ap prepare_ns draw_ns bytes_per_px "
               "image_hash truth_px")) {
        EXPECT_THAT(rows.front(), Contains(Key(column)));
    }
    std::set<std::string> methods;
    for (const auto& row : rows) {
        methods.insert(row.at("method"));
        EXPECT_EQ(row.at("status"), "ok") << row.at("method");
        EXPECT_EQ(row.at("scene"), "torus");
        EXPECT_EQ(row.at("width"), "320");
        EXPECT_EQ(row.at("height"), "180");
        EXPECT_EQ(row.at("seed"), "5");
    }
    for (const auto& row : only(rows, "mote4"))
        EXPECT_THAT(row.at("params"), HasSubstr("threshold=77"));
    EXPECT_EQ(
        methods,
        (std::set<std::string>{"none", "sampled", "exact_corner", "oracle", "mote4", "decaudin"}));
    // 99 thresholds of each row, and the header.
    const std::string curves = desk.read("out/curves.csv");
    EXPECT_EQ(static_cast<std::size_t>(std::count(curves.begin(), curves.end(), '\n')),
              99 * rows.size() + 1);
}

TEST(Compare, AnswersAFinishedRunAnewByAnotherRule) {
    const Desk desk;
    const Words words =
        "compare --scenes torus,cube --methods mote4,id_lookup --size 320x180 --repetitions 1 "
        "--no-sweep --images none --out out";
    const auto answers = [&desk] {
        std::map<std::string, std::string> found;
        for (const auto& line : parse_csv(desk.read("out/summary.csv")))
            found[line.at("method")] = line.at("answer");
        return found;
    };
    expect_done(desk, words);
    const std::string rows = desk.read("out/rows.csv");
    EXPECT_EQ(answers()["id_lookup"], "best");
    EXPECT_EQ(answers()["mote4"], "answer");
    EXPECT_THAT(expect_done(desk, words + "--f-margin 0.001"), HasSubstr("\nid_lookup finds "));
    EXPECT_EQ(desk.read("out/rows.csv"), rows) << "nothing is measured again";
    EXPECT_EQ(answers()["id_lookup"], "both");
    EXPECT_EQ(answers()["mote4"], "");
    EXPECT_THAT(desk.read("out/verdict.md"), HasSubstr("\n**id_lookup** finds "));
    EXPECT_THAT(desk.read("out/run.toml"), HasSubstr("f_margin = 0.001"));
}

TEST(Compare, WritesTolerancesAndSweepUnlessToldNotTo) {
    const Desk desk;
    Words words = "compare --scenes torus,staircase --size 320x180 --repetitions 1 --out out";
    const std::string out = expect_done(desk, words);
    EXPECT_THAT(out,
                AllOf(StartsWith("method "),
                      HasSubstr("\noracle *"),
                      HasSubstr(" % of the outline, and "),
                      HasSubstr("2 scenes are too few for an interval; better on ")));
    const Table rows = rows_of(desk);
    const Table tolerances = parse_csv(desk.read("out/tolerances.csv"));
    EXPECT_EQ(tolerances.size(), 5 * rows.size());
    for (const char* column : {"cell", "tolerance_px", "k", "n_pred", "n_truth"})
        EXPECT_THAT(tolerances.front(), Contains(Key(column)));
    std::map<std::string, std::set<std::string>> settings;
    for (const auto& setting : parse_csv(desk.read("out/sweep.csv"))) {
        EXPECT_EQ(setting.at("status"), "ok");
        EXPECT_NE(setting.at("f_2px"), "");
        EXPECT_THAT(setting, Contains(Key("threshold"))) << "every method's sweep varies it";
    }
    for (const auto& setting : table_of_run(desk, "out", "sweep.csv"))
        settings[setting.at("method")].insert(setting.at("setting"));
    std::set<std::string> methods;
    for (const auto& row : rows) {
        if (row.at("draw_ns") != "") methods.insert(row.at("method"));
    }
    EXPECT_GE(methods.size(), 16U);
    EXPECT_EQ(settings.size(), methods.size()) << "every method that drew";
    for (const auto& [method, params] : settings)
        EXPECT_GE(params.size(), 8U) << method;
    for (const auto& row : rows)
        EXPECT_NE(row.at("f_random_2px"), "");
    EXPECT_EQ(page_table(desk, "out", "sweep.csv")["lines"],
              parse_csv(desk.read("out/sweep.csv")).size());
    EXPECT_THAT(desk.read("out/verdict.md"), HasSubstr("| method | F 2px | 80 % |"));
    EXPECT_NE(desk.read("out/differences.csv"), "");

    words += "--no-sweep";
    expect_refused(desk, words, {"it holds another run", "--force"});
    EXPECT_NE(desk.read("out/sweep.csv"), "") << "nothing is lost";
    expect_done(desk, words + "--force");
    EXPECT_EQ(desk.read("out/sweep.csv"), "") << "an older one must not pass for this run's";
    EXPECT_EQ(rows_of(desk).size(), rows.size());
}

/// `compare` of methods that use the crease angle, on a scene of crossing blocks.
Words crease_words(const Words& more) {
    return "compare --scenes blocks --methods ids,edge_hash,inverted_hull --size 320x180 --quick "
           "--images none --out out" +
           more;
}

TEST(Compare, CreaseMovesTheMethodsThatUseIt) {
    const Desk desk;
    expect_done(desk, crease_words("--crease 60 --set edge_hash.crease_deg=30"));
    const Table rows = rows_of(desk);
    for (const auto& row : rows)
        EXPECT_EQ(row.at("crease_deg"), "60");
    EXPECT_THAT(only(rows, "ids").front().at("params"), HasSubstr("crease_deg=60"));
    EXPECT_THAT(only(rows, "edge_hash").front().at("params"), HasSubstr("crease_deg=30"));
    EXPECT_THAT(only(rows, "inverted_hull").front().at("params"), HasSubstr("crease_deg=180"));
    EXPECT_THAT(desk.read("out/run.toml"), HasSubstr("crease_deg = 60"));
}

/// No file or address is named from which something would be loaded.
void expect_whole_in_itself(const std::string& page) {
    ASSERT_THAT(page, HasSubstr("</html>"));
    const std::regex outside(
        R"re((src|href)\s*=\s*["'](?!data:|#|["'])|@import|url\((?!["']?(data:|#)))re");
    std::smatch match;
    EXPECT_FALSE(std::regex_search(page.begin(), page.end(), match, outside))
        << std::string(match[0].first, std::min(match[0].first + 80, page.end()));
}

TEST(Report, IsMadeFromTheFolderAloneWhereverItIs) {
    const Desk desk;
    expect_done(desk, "compare --scenes cube,tiles --methods mote4,ids --size 160x90 --out out");
    const std::string page = desk.read("out/report.html");
    expect_whole_in_itself(page);
    std::filesystem::create_directory(desk.work() / "elsewhere");
    std::filesystem::rename(desk.work() / "out", desk.work() / "elsewhere/out");
    EXPECT_THAT(expect_done(desk, "report elsewhere/out -o elsewhere/again.html"),
                HasSubstr("elsewhere/again.html"));
    const std::regex folder_in_commands("elsewhere/out");
    EXPECT_EQ(std::regex_replace(desk.read("elsewhere/again.html"), folder_in_commands, "out"),
              page);
    const std::string views = "elsewhere/out/images/cube/front/";
    desk.write(views + "layer_object.png", "");
    const Outcome unshown = desk.run("report elsewhere/out");
    EXPECT_EQ(unshown.exit_code, 0);
    EXPECT_THAT(unshown.err, HasSubstr(views + "layer_object.png: the file is empty"));
    desk.write(views + "ids.png", "");
    const Outcome shown = desk.run("report elsewhere/out");
    EXPECT_EQ(shown.exit_code, 2) << "the page shows it";
    EXPECT_THAT(shown.err, HasSubstr(views + "ids.png: the file is empty"));
    expect_refused(desk, "report elsewhere/out elsewhere/out", {"-o FILE.html"});
    expect_refused(desk, "report nowhere", {"there is no run in it"});
}

TEST(Compare, ViewsAreThoseThatWereAskedFor) {
    const Desk desk;
    desk.write("cube.obj", kCubeObj);
    const auto views = [&](const Words& more) {
        expect_done(desk,
                    "compare cube.obj --methods mote2 --size 160x90 --out out --force" + more);
        return only(rows_of(desk), "mote2");
    };
    EXPECT_EQ(views("--views 5").size(), 5U);
    const Table named = views("--views top,iso");
    EXPECT_EQ(named.size(), 2U);
    EXPECT_EQ(named.front().at("view"), "top");
    EXPECT_EQ(named.front().at("projection"), "parallel");
    EXPECT_THAT(desk.read("out/run.toml"), HasSubstr("directions = [ 'top', 'iso' ]"));
    const Table both = views("--views 2 --projection perspective,parallel");
    EXPECT_EQ(both.size(), 4U);
    EXPECT_EQ(both.back().at("view"), "view1.parallel");
    EXPECT_THAT(desk.read("out/run.toml"),
                HasSubstr("projections = [ 'perspective', 'parallel' ]"));
    EXPECT_EQ(views("--eye 3,2,4 --parallel 3").size(), 1U);
    EXPECT_EQ(views("--eye 3,2,4 --target 0.5,0.5,0.5 --up 0,1,0 --fov 30").size(), 1U);
}

TEST(Truth, WritesLayersAndCurvesByTheEndingOfTheName) {
    const Desk desk;
    const std::string summary =
        expect_done(desk, "truth torus --size 160x90 -o truth.exr --svg curves.svg");
    EXPECT_THAT(summary, HasSubstr("behind contours: sky"));
    EXPECT_THAT(desk.read("truth.exr"), StartsWith("\x76\x2f\x31\x01")) << "OpenEXR's magic";
    EXPECT_THAT(desk.read("curves.svg"), AllOf(StartsWith("<svg"), HasSubstr("data-dihedral-deg")));
    expect_done(desk, "truth torus --size 160x90 -o again.svg");
    EXPECT_EQ(desk.read("again.svg"), desk.read("curves.svg"));
    expect_done(desk, "draw torus --size 160x90 -o ink.exr");
    EXPECT_THAT(desk.read("ink.exr"), StartsWith("\x76\x2f\x31\x01"));
}

TEST(Truth, DrawsASheetPerView) {
    const Desk desk;
    desk.write("cube.obj", kCubeObj);
    const auto done = [&](const Words& words) {  // such sheets are warned of
        const Outcome outcome = desk.run(words);
        EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
        return outcome.out;
    };
    const Words cube = "truth cube.obj --size 160x90";
    const std::string told = done(cube + "--views front,iso --drawing sheets --hidden --threads 1");
    EXPECT_THAT(told,
                ContainsRegex("cube.obj iso: sheets/iso.svg, [0-9.]+ x [0-9.]+ mm, scale 1:1 "
                              "\\(1 mm a unit\\), y up, 4 visible, 3 hidden lines"));
    EXPECT_THAT(told, Not(HasSubstr("behind contours"))) << "lines alone";
    const std::string iso = desk.read("sheets/iso.svg");
    EXPECT_EQ(report::nesting_error(iso), "");
    EXPECT_THAT(iso, AllOf(HasSubstr(R"(width="3.3424mm")"), HasSubstr("hidden-crease-3")));
    EXPECT_THAT(desk.read("sheets/front.svg"),
                AllOf(HasSubstr(R"(id="contour-1")"), Not(HasSubstr("hidden-crease-1"))))
        << "what lies behind the outline is not dashed over it";

    done(cube + "--views iso --drawing one.svg --hidden --threads 2");
    EXPECT_EQ(desk.read("one.svg"), iso);
    const std::string both =
        done(cube + "--views iso -o a.png --drawing wide.svg --sheet-width 90");
    EXPECT_THAT(both, AllOf(HasSubstr("wide.svg"), HasSubstr("behind contours")));
    const std::string ten_times = done(cube + "--views iso --drawing ten.svg --scale 10");
    EXPECT_THAT(ten_times, HasSubstr("scale 10:1 (10 mm a unit)"));
    done(cube + "--views iso --drawing ratio.svg --scale 10:1");
    EXPECT_EQ(desk.read("ratio.svg"), desk.read("ten.svg"));
    EXPECT_THAT(desk.read("ten.svg"), HasSubstr(R"(width="33.4235mm")"));
    EXPECT_THAT(done(cube + "--views 3 --view view1 --drawing view1.svg"), Not(HasSubstr("a unit")))
        << "in perspective";
    EXPECT_THAT(desk.read("view1.svg"), HasSubstr(R"(width="42.3333mm")"));
    EXPECT_THAT(desk.read("wide.svg"), AllOf(HasSubstr("90mm"), Not(HasSubstr("hidden"))));
}

TEST(Truth, FitsDrawingsToPaperAndWarnsOfOddSheets) {
    const Desk desk;
    desk.write("cube.obj", kCubeObj);
    const Words cube = "truth cube.obj --size 160x90 --views front --drawing front.svg";
    const Outcome fitted = desk.run(cube + "--sheet A4");
    EXPECT_THAT(fitted.out,
                HasSubstr("front.svg, 210 x 297 mm, scale 100:1 (100 mm a unit), y up, 1 vis"));
    EXPECT_EQ(fitted.err, "");
    EXPECT_THAT(desk.read("front.svg"), HasSubstr("55,98.5 "));
    EXPECT_THAT(desk.run(cube).err,
                HasSubstr("front: its sheet of 3.342 x 1.88 mm is smaller than"));
    EXPECT_THAT(desk.run(cube + "--scale 1000:1").err, HasSubstr("is larger than A0"));
    expect_done(desk, "truth cube.obj --size 160x90 --views front --drawing front.dxf --sheet A3");
    EXPECT_THAT(desk.read("front.dxf"), AllOf(HasSubstr("AC1009"), HasSubstr("\nCONTOUR\n")));
}

TEST(Truth, ViewsByNameStandUprightByAnAxis) {
    const Desk desk;
    desk.write("box.obj", kTriangleObj);
    desk.write("box.stl",
               "solid\nfacet normal 0 0 0\nouter loop\nvertex 0 0 0\nvertex 1 0 0\nvertex 0 0 1\n"
               "endloop\nendfacet\nendsolid\n");
    const auto up_of = [&](const std::string& words) {
        const std::string told = expect_done(desk, "explain --size 16x16 " + words);
        const std::string before = "up in views by name: ";
        return told.substr(told.find(before) + before.size(), 1);
    };
    EXPECT_EQ(up_of("box.stl"), "z");
    EXPECT_EQ(up_of("box.obj"), "y");
    EXPECT_EQ(up_of("box.obj --views top --up x"), "x");
    EXPECT_THAT(
        desk.run("truth box.stl --views front --size 64x64 --drawing front.svg --sheet A4").out,
        HasSubstr(", z up,"));
    EXPECT_THAT(desk.run("compare box.stl --views top --size 32x32 --methods ids --quick").err,
                HasSubstr("box.stl: z is up"));
}

TEST(Truth, RefusesDrawingsThatCannotBe) {
    const Desk desk;
    const auto expect = [&](const Words& more, const std::string& culprit) {
        expect_refused(desk, "truth cube --size 16x16" + more, {culprit});
    };
    for (const char* option : {"--hidden", "--sheet-width 80", "--scale 8", "--sheet A4"})
        expect(option, Words(option)[0] + ": there is no drawing");
    expect("--drawing a.svg --scale 2", "is in perspective");
    expect("--drawing a.svg --views iso --scale 2 --sheet-width 80", "--sheet-width beside it");
    for (const char* scale : {"0", "1:0", "-2", "1:", "half"})
        expect(Words("--drawing a.svg --views iso --scale") + Words(scale), "is no scale");
    expect("--drawing a.svg --views iso --sheet A5", "A4, A3, A2, A1, A0");
    expect("--drawing a.svg --sheet A4 --sheet-width 80", "--sheet-width beside it");
    expect("--drawing a.svg --views iso --sheet A4 --scale 500", "at 500 view 'iso' does not fit");
    expect("--drawing a.svg --sheet-width 0", "a number 1..10000");
    expect("--drawing a.svg --views top,iso", "one file has no room for 2 views");
    expect("--drawing a.svg --views 3", "one file has no room for 3 views");
    expect("--drawing none/a.svg", "its folder does not exist");
    expect("--drawing a.png", "a name that ends in .svg or .dxf");
}

TEST(Truth, WeldEpsilonClosesCracksAndIsRecorded) {
    const Desk desk;
    // Two triangles of a square that miss each other by a hair.
    desk.write("crack.obj",
               "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0.00001 0 0\nv 1.00001 1 0\nv 0 1 0\n"
               "f 1 2 3\nf 4 5 6\n");
    const Words exact = "truth crack.obj --size 64x36 --no-cache";
    EXPECT_THAT(expect_done(desk, exact), Not(HasSubstr("epsilon joined")));
    EXPECT_THAT(expect_done(desk, exact + "--weld-epsilon 1e-4"),
                HasSubstr("epsilon joined 2 vertices"));
    expect_done(desk,
                "compare crack.obj --methods mote4 --views 1 --size 64x36 --repetitions 1 "
                "--weld-epsilon 0.0001 --out out");
    for (const auto& row : rows_of(desk))
        EXPECT_EQ(row.at("weld_epsilon"), "0.0001");
}

TEST(DrawTruthScore, WorkHandInHand) {
    const Desk desk;
    expect_done(desk, "draw torus --methods mote4 --size 320x180 -o ink.png");
    expect_done(desk, "truth torus --size 320x180 -o truth.png");
    EXPECT_THAT(desk.read("ink.png"), StartsWith("\x89PNG"));
    EXPECT_THAT(desk.read("truth.png"), StartsWith("\x89PNG"));
    const auto json =
        expect_json(desk, "score truth.png truth.png --threshold 1 --ignore 7 --json");
    EXPECT_EQ(json.at("k"), json.at("n_truth"));
    EXPECT_GT(json.at("n_truth"), 100);
    for (const std::string& key : Words("k n_pred n_truth f precision recall surplus off_line lost "
                                        "missing mean_width unmatched_duplicates false_positives "
                                        "unmatched_truth false_negatives mean_width_px classes")) {
        EXPECT_TRUE(json.contains(key)) << key;
    }
}

TEST(Csv, IsReadByItsRules) {
    const Table table = {{{"a", "1"}, {"b", "x,y"}}, {{"a", "\"hi\", she said"}, {"b", ""}}};
    EXPECT_EQ(parse_csv("a,b\n1,\"x,y\"\n\"\"\"hi\"\", she said\",\n"), table);
    EXPECT_ANY_THROW((void)parse_csv("a,b\n1\n"));
}

}  // namespace
}  // namespace ink::program
