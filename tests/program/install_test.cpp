#include <gmock/gmock.h>

#include <set>
#include <sstream>

#include "tests/program/run_program.h"

// `cmake --install` and what it installs: the program far from its build, and completions in bash.

namespace ink::program {
namespace {

namespace fs = std::filesystem;
using testing::Contains;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::IsSupersetOf;
using testing::Not;

class Install : public testing::Test {
  protected:
    void SetUp() override {
        const Outcome outcome = desk_.run_other(
            INK_CMAKE, {"--install", INK_BINARY_DIR, "--prefix", (desk_.work() / "usr").string()});
        ASSERT_EQ(outcome.exit_code, 0) << outcome.err;
    }
    std::string installed(const char* file) const { return (desk_.work() / "usr" / file).string(); }

    /// What bash offers for the last of `words`, after the installed script was read.
    Words completions(const Words& words) const {
        std::string line = "COMP_WORDS=(";
        for (const std::string& word : words)
            line += "'" + word + "' ";
        const std::string script =
            ". '" + installed(kScript) + "'; " + line +
            "); COMP_CWORD=$((${#COMP_WORDS[@]} - 1)); _inkbench; "
            "[ ${#COMPREPLY[@]} -eq 0 ] || printf '%s\\n' \"${COMPREPLY[@]}\"";
        const Outcome outcome =
            desk_.run_other("/bin/bash", {"--norc", "--noprofile", "-u", "-c", script});
        EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
        EXPECT_EQ(outcome.err, "");
        Words offered;
        std::istringstream lines(outcome.out);
        for (std::string offer; std::getline(lines, offer);)
            offered.push_back(offer);
        return offered;
    }

    static constexpr const char* kManPages = "share/man/man1/";
    static constexpr const char* kScript = "share/bash-completion/completions/inkbench";
    Desk desk_;
};

TEST_F(Install, TheProgramReadsModelsWhereItIs) {
    std::set<std::string> files;
    for (const auto& entry : fs::recursive_directory_iterator(desk_.work() / "usr"))
        if (entry.is_regular_file())
            files.insert(entry.path().lexically_relative(desk_.work() / "usr").string());
    std::erase_if(files, [](const std::string& file) {
        return (file.starts_with("share/inkbench/notebooks/paper/") && file.ends_with(".py")) ||
               file.starts_with(kManPages) || file.starts_with("lib/python");
    });
    EXPECT_THAT(files,
                ElementsAre("bin/inkbench",
                            "bin/inkbench_import",
                            INK_LIBDIR "/inkbench/inkbench_images.so",
                            kScript,
                            "share/doc/inkbench/copyright",
                            "share/inkbench/notebooks/figures.py",
                            "share/inkbench/notebooks/paper/vocabulary.json"))
        << "nothing else is installed";
    desk_.write("one.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n");
    // By a link, as package managers make them: the child is beside the program itself.
    fs::create_symlink(installed("bin/inkbench"), desk_.work() / "ink");
    const Outcome outcome = desk_.run_other((desk_.work() / "ink").string(),
                                            {"draw", "one.obj", "-o", "a.png", "--size", "64x36"});
    EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
    EXPECT_EQ(desk_.read("a.png").substr(1, 3), "PNG");
}

TEST_F(Install, FiguresAreDrawnByTheInstalledScript) {
    const std::string script = installed("share/inkbench/notebooks/figures.py");
    desk_.write("marked.py", "import sys\nprint('the installed one')\nsys.exit(0)\n");
    fs::copy_file(desk_.work() / "marked.py", script, fs::copy_options::overwrite_existing);
    fs::create_directory(desk_.work() / "run");
    const Outcome outcome = desk_.run_other(installed("bin/inkbench"), {"figures", "run"});
    EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
    EXPECT_EQ(outcome.out, "the installed one\n");
}

TEST_F(Install, EverySubcommandHasAManualPageThatSaysWhatItsHelpSays) {
    if (!fs::exists(installed(kManPages))) GTEST_SKIP() << "built without help2man";
    Words pages = {"inkbench.1"};
    for (const std::string& command : completions({"inkbench", ""})) {
        if (command.front() != '-') pages.push_back("inkbench-" + command + ".1");
    }
    Words found;
    for (const auto& entry : fs::directory_iterator(installed(kManPages)))
        found.push_back(entry.path().filename().string());
    EXPECT_THAT(found, testing::UnorderedElementsAreArray(pages));
    const std::string page = desk_.read("usr/share/man/man1/inkbench-score.1");
    EXPECT_THAT(page, HasSubstr(".TH INKBENCH-SCORE \"1\""));
    EXPECT_THAT(page, HasSubstr("inkbench-score \\- Score an outline image against a truth"));
    EXPECT_THAT(page, HasSubstr(".SH OPTIONS"));
    EXPECT_THAT(page, HasSubstr("fail\\-under"));
}

TEST_F(Install, BashCompletesCommandsOptionsAndNames) {
    EXPECT_THAT(completions({"inkbench", "com"}), ElementsAre("compare", "completions"));
    EXPECT_THAT(completions({"inkbench", "--"}), IsSupersetOf({"--help", "--version"}));
    EXPECT_THAT(completions({"inkbench", "compare", "--meth"}),
                ElementsAre("--methods", "--method"));
    EXPECT_THAT(completions({"inkbench", "draw", "--"}), IsSupersetOf({"--output", "--shading"}));
    EXPECT_THAT(completions({"inkbench", "draw", "--"}), Not(Contains("--sweep-views")));
    EXPECT_THAT(completions({"inkbench", "compare", "--methods", "mote1"}),
                IsSupersetOf({"mote16"}));
    EXPECT_THAT(completions({"inkbench", "tune", "plan"}), ElementsAre("plane_distance"));
    EXPECT_THAT(completions({"inkbench", "compare", "--scenes", "stairc"}),
                ElementsAre("staircase"));
    EXPECT_THAT(completions({"inkbench", "truth", "heldo"}), ElementsAre("heldout"));
    EXPECT_THAT(completions({"inkbench", "help", "strE"}), IsEmpty());
    EXPECT_THAT(completions({"inkbench", "help", "str"}), ElementsAre("stress"));
    EXPECT_THAT(completions({"inkbench", "list", "sc"}), ElementsAre("scenes"));
}

TEST_F(Install, BashCompletesTheLastOfAListAndValuesBehindAnEqualsSign) {
    EXPECT_THAT(completions({"inkbench", "compare", "--scenes", "cube,stairc"}),
                ElementsAre("cube,staircase"));
    EXPECT_THAT(completions({"inkbench", "compare", "--scenes", "=", "stairc"}),
                ElementsAre("staircase"));
    EXPECT_THAT(completions({"inkbench", "draw", "--dither", "="}),
                ElementsAre("none", "565", "332"));
    EXPECT_THAT(completions({"inkbench", "draw", "cube", "--size", "6"}), IsEmpty());
    EXPECT_THAT(completions({"inkbench", "compare", "--no-skip", "occ"}),
                ElementsAre("occlusion_culling"));
}

TEST_F(Install, BashCompletesEveryOptionThatHelpShows) {
    for (const std::string& command : completions({"inkbench", ""})) {
        if (command.front() == '-') continue;
        std::istringstream help(desk_.run({command, "--help"}).out);
        const Words offered = completions({"inkbench", command, "-"});
        for (std::string line; std::getline(help, line);) {
            if (!line.starts_with("  -")) continue;
            const std::string names = line.substr(2, line.find(' ', 2) - 2);
            std::istringstream spellings(names);
            for (std::string name; std::getline(spellings, name, ',');)
                EXPECT_THAT(offered, Contains(name)) << command;
        }
    }
}

}  // namespace
}  // namespace ink::program
