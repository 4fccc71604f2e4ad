#include <gmock/gmock.h>

#include <cstdlib>
#include <filesystem>

#include "tests/program/run_program.h"

// `inkbench figures` as far as it is C++: what it asks of the script, and the run that it makes
// first. What is drawn, tests/notebooks look at.

namespace ink::program {
namespace {

using testing::AllOf;
using testing::HasSubstr;
using testing::Not;
using testing::StartsWith;

std::vector<std::string> figures(const std::vector<std::string>& more) {
    std::vector<std::string> words = {"figures"};
    words.insert(words.end(), more.begin(), more.end());
    return words;
}

/// A setting of the environment for as long as the test lasts.
class Variable {
  public:
    Variable(const char* name, const char* value) : name_(name) { setenv(name, value, 1); }
    ~Variable() { unsetenv(name_); }
    Variable(const Variable&) = delete;
    Variable& operator=(const Variable&) = delete;

  private:
    const char* name_;
};

TEST(Figures, OfScenesAndMethodsMakeTheRunFirst) {
    const Desk desk;
    const Outcome outcome = desk.run(figures({"--scenes",
                                              "cube,torus",
                                              "--methods",
                                              "mote4,decaudin,ids",
                                              "--size",
                                              "96x54",
                                              "--repetitions",
                                              "1",
                                              "--views",
                                              "2",
                                              "--format",
                                              "pdf,svg",
                                              "--width",
                                              "84mm",
                                              "--out",
                                              "out"}));
    ASSERT_EQ(outcome.exit_code, 0) << outcome.err;
    EXPECT_THAT(desk.read("out/figures.md"),
                AllOf(HasSubstr("## strips"),
                      HasSubstr("`inkbench figures --scenes cube,torus --methods "
                                "mote4,decaudin,ids --size 96x54")));
    for (const char* name : {"strips", "error_time", "classes"}) {
        EXPECT_THAT(desk.read(std::string("out/") + name + ".pdf"), StartsWith("%PDF")) << name;
        EXPECT_THAT(desk.read(std::string("out/") + name + ".svg"), HasSubstr(">mote4</text>"))
            << name;
    }
    EXPECT_THAT(desk.read("out/strips.svg"), HasSubstr("torus view1"))
        << "every view that is asked";
    EXPECT_EQ(parse_csv(desk.read("out/run/rows.csv")).size(), 2U * 2 * (3 + 4));
    EXPECT_EQ(desk.read("out/run/sweep.csv"), "");
    for (const auto& [path, size] : desk.inventory())
        EXPECT_THAT(path, Not(HasSubstr(".part")));

    // The run that it made is one like any other.
    const Outcome again = desk.run(
        figures({"out/run", "--methods", "mote4,ids", "--only", "strips,f", "--out", "again"}));
    ASSERT_EQ(again.exit_code, 0) << again.err;
    EXPECT_THAT(again.out, AllOf(HasSubstr("again/strips.svg"), HasSubstr("again/f.png")));
    EXPECT_THAT(desk.read("again/strips.svg"),
                AllOf(HasSubstr(">ids</text>"), Not(HasSubstr(">decaudin</text>"))));
}

TEST(Figures, BadInputIsRefusedBeforeAnyWork) {
    const Desk desk;
    const auto refusal = [&](const std::vector<std::string>& more) {
        const Outcome outcome = desk.run(figures(more));
        EXPECT_EQ(outcome.exit_code, 2) << outcome.err;
        return outcome.err;
    };
    EXPECT_THAT(refusal({"--scenes", "nowhere"}), HasSubstr("nowhere"));
    EXPECT_THAT(refusal({"--repetitions", "0"}), HasSubstr("--repetitions"));
    EXPECT_THAT(refusal({"cube", "--width", "84"}), AllOf(HasSubstr("--width"), HasSubstr("84mm")));
    EXPECT_THAT(refusal({"cube", "--format", "eps"}), HasSubstr("pdf, svg, png"));
    EXPECT_THAT(refusal({"cube", "--window", "1,2,3"}), HasSubstr("--window"));
    EXPECT_TRUE(desk.inventory().empty()) << "nothing is left behind";
    std::filesystem::create_directories(desk.work() / "empty");
    EXPECT_THAT(refusal({"empty"}), HasSubstr("empty: it holds no rows.csv"));
    EXPECT_THAT(refusal({"empty", "--size", "64x36"}),
                HasSubstr("--size: the run is made already"));
    EXPECT_THAT(refusal({"empty", "cube"}), HasSubstr("'cube' is no folder"));
    EXPECT_EQ(desk.inventory().size(), 1U);
}

TEST(Figures, WithoutPythonSayWhatToInstall) {
    const Desk desk;
    const Variable python("INKBENCH_PYTHON", "/nonexistent");
    for (const std::vector<std::string>& words :
         {std::vector<std::string>{"cube", "--size", "64x36"}, std::vector<std::string>{"."}}) {
        const Outcome outcome = desk.run(figures(words));
        EXPECT_EQ(outcome.exit_code, 2);
        EXPECT_THAT(outcome.err,
                    AllOf(HasSubstr("/nonexistent: it cannot be started"),
                          HasSubstr("apt-get install python3 python3-pandas python3-matplotlib")));
    }
    EXPECT_TRUE(desk.inventory().empty()) << "no run is made for figures that cannot be";
}

TEST(Figures, WithoutPandasSayWhatToInstall) {
    const Desk desk;
    // Python without its distribution's packages.
    desk.write("python", "#!/bin/sh\nexec /usr/bin/python3 -S \"$@\"\n");
    const std::string program = (desk.work() / "python").string();
    std::filesystem::permissions(program, std::filesystem::perms::owner_all);
    const Variable python("INKBENCH_PYTHON", program.c_str());
    const Outcome outcome = desk.run(figures({"cube", "--size", "64x36"}));
    EXPECT_EQ(outcome.exit_code, 2);
    EXPECT_THAT(outcome.err, HasSubstr("apt-get install python3-pandas python3-matplotlib"));
    EXPECT_THAT(outcome.err, Not(HasSubstr("Traceback")));
}

}  // namespace
}  // namespace ink::program
