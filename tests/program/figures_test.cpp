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
    expect_done(desk,
                "figures --scenes cube,torus --methods mote4,decaudin,ids --size 96x54 "
                "--repetitions 1 --views 2 --format pdf,svg --width 84mm --out out");
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
    EXPECT_THAT(
        expect_done(desk, "figures out/run --methods mote4,ids --only strips,classes --out again"),
        AllOf(HasSubstr("again/strips.svg"), HasSubstr("again/classes.png")));
    EXPECT_THAT(desk.read("again/strips.svg"),
                AllOf(HasSubstr(">ids</text>"), Not(HasSubstr(">decaudin</text>"))));
}

TEST(Figures, BadInputIsRefusedBeforeAnyWork) {
    const Desk desk;
    std::filesystem::create_directories(desk.work() / "empty");
    expect_all_refused(desk,
                       "figures",
                       {{"--scenes nowhere", "nowhere"},
                        {"--repetitions 0", "--repetitions"},
                        {"cube --width 84", "--width 84mm"},
                        {"cube --format eps", {"pdf, svg, png"}},
                        {"cube --window 1,2,3", "--window"},
                        {"empty", {"empty: it holds no rows.csv"}},
                        {"empty --size 64x36", {"--size: the run is made already"}},
                        {"empty cube", {"'cube' is no folder"}}});
}

TEST(Figures, WithoutPythonSayWhatToInstall) {
    const Desk desk;
    const Variable python("INKBENCH_PYTHON", "/nonexistent");
    for (const char* words : {"figures cube --size 64x36", "figures ."})
        expect_refused(desk,
                       words,
                       {"/nonexistent: it cannot be started",
                        "apt-get install python3 python3-pandas python3-matplotlib"});
}

TEST(Figures, WithoutPandasSayWhatToInstall) {
    const Desk desk;
    // Python without its distribution's packages.
    desk.write("python", "#!/bin/sh\nexec /usr/bin/python3 -S \"$@\"\n");
    const std::string program = (desk.work() / "python").string();
    std::filesystem::permissions(program, std::filesystem::perms::owner_all);
    const Variable python("INKBENCH_PYTHON", program.c_str());
    const std::string outcome = refusal(desk, "figures cube --size 64x36");
    EXPECT_THAT(outcome, HasSubstr("apt-get install python3-pandas python3-matplotlib"));
    EXPECT_THAT(outcome, Not(HasSubstr("Traceback")));
}

}  // namespace
}  // namespace ink::program
