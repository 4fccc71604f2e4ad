#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <regex>

#include "tests/program/run_program.h"

namespace ink::program {
namespace {

using testing::HasSubstr;

std::vector<std::string> figures(const std::vector<std::string>& more) {
    std::vector<std::string> words = {"figures", "--repetitions", "1"};
    words.insert(words.end(), more.begin(), more.end());
    return words;
}

/// Width and height of a whole PNG, {0, 0} for anything else.
std::pair<int, int> png_size(const std::string& bytes) {
    if (bytes.size() < 45 || bytes.compare(0, 8, "\x89PNG\r\n\x1a\n") != 0) return {0, 0};
    if (bytes.substr(bytes.size() - 8, 4) != "IEND") return {0, 0};
    const auto number = [&](std::size_t at) {
        int value = 0;
        for (std::size_t i = at; i < at + 4; ++i)
            value = value * 256 + static_cast<unsigned char>(bytes[i]);
        return value;
    };
    return {number(16), number(20)};
}

/// What an SVG says of itself, {0, 0} if it is not whole.
std::pair<int, int> svg_size(const std::string& text) {
    std::smatch match;
    const std::regex size(R"re(^<svg [^>]*width="(\d+)" height="(\d+)")re");
    if (!text.ends_with("</svg>\n") || !std::regex_search(text, match, size)) return {0, 0};
    return {std::stoi(match[1]), std::stoi(match[2])};
}

TEST(Figures, OneCommandMakesThemAll) {
    const Desk desk;
    const Outcome outcome = desk.run(figures({"--scenes",
                                              "cube,tiles",
                                              "--methods",
                                              "mote4,decaudin,ids",
                                              "--size",
                                              "96x54",
                                              "--out",
                                              "out"}));
    ASSERT_EQ(outcome.exit_code, 0) << outcome.err;
    const std::string list = desk.read("out/figures.md");
    EXPECT_THAT(list, HasSubstr("Made by `inkbench figures --scenes cube,tiles"));
    for (const char* name : {"strips", "buffers", "zoom"}) {
        const std::string stem = std::string("out/") + name;
        const auto png = png_size(desk.read(stem + ".png"));
        EXPECT_GT(png.first, 100) << name;
        EXPECT_EQ(png, svg_size(desk.read(stem + ".svg"))) << name;
        EXPECT_THAT(list, HasSubstr(std::string("## ") + name));
    }
    for (const char* name : {"error_time", "classes"})
        EXPECT_GT(svg_size(desk.read(std::string("out/") + name + ".svg")).first, 500) << name;
    for (const char* method : {"mote4", "decaudin", "ids"}) {
        const std::string label = std::string(">") + method + "</text>";
        EXPECT_THAT(desk.read("out/strips.svg"), HasSubstr(label));
        EXPECT_THAT(desk.read("out/error_time.svg"), HasSubstr(label));
        EXPECT_THAT(desk.read("out/classes.svg"), HasSubstr(label));
    }
    EXPECT_EQ(parse_csv(desk.read("out/figure_rows.csv")).size(), 2U * (3 + 3));
    EXPECT_EQ(parse_csv(desk.read("out/figure_summary.csv")).size(), 6U);
    for (const auto& [path, size] : desk.inventory())
        EXPECT_THAT(path, testing::Not(HasSubstr(".part")));
}

TEST(Figures, AFigureWithNothingToShowIsNotLeftFromAnOlderRun) {
    const Desk desk;
    const auto run = [&](const char* methods) {
        return desk.run(
            figures({"--scenes", "cube", "--methods", methods, "--size", "64x36", "--out", "out"}));
    };
    ASSERT_EQ(run("mote4").exit_code, 0);
    EXPECT_NE(desk.read("out/buffers.png"), "");
    ASSERT_EQ(run("edge_list").exit_code, 0);
    EXPECT_EQ(desk.read("out/buffers.png"), "");
    EXPECT_THAT(desk.read("out/figures.md"), HasSubstr("No method that takes part shows a buffer"));
}

TEST(Figures, ImagesDoNotDependOnTheRun) {
    const Desk desk;
    for (const char* out : {"a", "b"}) {
        ASSERT_EQ(desk.run(figures({"--scenes",
                                    "cube",
                                    "--methods",
                                    "mote4,decaudin",
                                    "--size",
                                    "64x36",
                                    "--threads",
                                    out == std::string("a") ? "1" : "3",
                                    "--out",
                                    out}))
                      .exit_code,
                  0);
    }
    for (const char* file :
         {"strips.png", "strips.svg", "buffers.png", "zoom.png", "classes.svg"}) {
        const std::string a = desk.read(std::string("a/") + file);
        EXPECT_TRUE(a == desk.read(std::string("b/") + file) && !a.empty()) << file;
    }
}

TEST(Figures, OfARunHaveItsRowsItsSettingsAndItsSize) {
    const Desk desk;
    ASSERT_EQ(desk.run({"compare",
                        "--scenes",
                        "cube,tiles",
                        "--methods",
                        "mote4,decaudin,ids",
                        "--set",
                        "mote4.threshold=99",
                        "--size",
                        "96x54",
                        "--repetitions",
                        "1",
                        "--no-sweep",
                        "--no-crosscheck",
                        "--out",
                        "run"})
                  .exit_code,
              0);
    const Outcome outcome =
        desk.run(figures({"--from", "run", "--methods", "mote4,decaudin", "--out", "out"}));
    ASSERT_EQ(outcome.exit_code, 0) << outcome.err;
    EXPECT_THAT(desk.read("out/figures.md"),
                HasSubstr("Of the run in run: 2 scenes of 96 x 54 px"));
    const Table of_run = parse_csv(desk.read("run/summary.csv"));
    const Table of_charts = parse_csv(desk.read("out/figure_summary.csv"));
    ASSERT_EQ(of_charts.size(), 5U) << "two of the methods and the baselines";
    for (const auto& line : of_charts) {
        const auto same = std::find_if(of_run.begin(), of_run.end(), [&](const auto& other) {
            return other.at("method") == line.at("method");
        });
        ASSERT_NE(same, of_run.end());
        for (const char* column : {"f_2px", "f_lo", "f_hi", "recall_crease", "views", "draw_ms"})
            EXPECT_EQ(line.at(column), same->at(column)) << line.at("method") << " " << column;
    }
    for (const auto& row : parse_csv(desk.read("out/figure_rows.csv"))) {
        EXPECT_EQ(row.at("width"), "96");
        const bool is_set = row.at("params").find("threshold=99") != std::string::npos;
        EXPECT_EQ(is_set, row.at("method") == "mote4") << row.at("method");
    }
}

TEST(Figures, AFolderThatIsNoRunIsRefused) {
    const Desk desk;
    const auto refusal = [&](const std::vector<std::string>& more) {
        const Outcome outcome = desk.run(figures(more));
        EXPECT_EQ(outcome.exit_code, 2);
        return outcome.err;
    };
    EXPECT_THAT(refusal({"--from", "nowhere"}), HasSubstr("nowhere: there is no such folder"));
    std::filesystem::create_directories(desk.work() / "empty");
    EXPECT_THAT(refusal({"--from", "empty"}), HasSubstr("empty: there is no run in it"));
    std::filesystem::create_directories(desk.work() / "half");
    desk.write("half/run.toml", "identity = \"0\"\n[progress]\nstate = \"unfinished\"\n[asked]\n");
    EXPECT_THAT(refusal({"--from", "half"}), HasSubstr("its run is not finished"));
    std::filesystem::create_directories(desk.work() / "foreign");
    desk.write("foreign/run.toml", "[pears]\nprice = 3\n");
    EXPECT_THAT(refusal({"--from", "foreign"}), HasSubstr("foreign/run.toml"));
    EXPECT_THAT(refusal({"--from", "empty", "--set", "threshold=3"}), HasSubstr("inkbench: "));
}

TEST(Figures, BadInputIsRefusedBeforeAnyWork) {
    const Desk desk;
    const auto refusal = [&](const std::vector<std::string>& more) {
        const Outcome outcome = desk.run(figures(more));
        EXPECT_EQ(outcome.exit_code, 2);
        return outcome.err;
    };
    EXPECT_THAT(refusal({"--pair", "mote4"}), HasSubstr("--pair: 'mote4' is not two methods"));
    EXPECT_THAT(refusal({"--methods", "mote4,ids", "--pair", "mote4,sobel"}),
                HasSubstr("--pair: 'sobel' does not take part"));
    EXPECT_THAT(refusal({"--scenes", "nowhere"}), HasSubstr("nowhere"));
    EXPECT_THAT(refusal({"--repetitions", "0"}), HasSubstr("--repetitions"));
    EXPECT_TRUE(desk.inventory().empty()) << "nothing is left behind";
}

}  // namespace
}  // namespace ink::program
