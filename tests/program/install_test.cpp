#include <gmock/gmock.h>

#include <set>

#include "tests/program/run_program.h"

// `cmake --install` and what it installs: the program far from its build.

namespace ink::program {
namespace {

namespace fs = std::filesystem;
using testing::ElementsAre;
using testing::HasSubstr;

class Install : public testing::Test {
  protected:
    void SetUp() override {
        const Outcome outcome = desk_.run_other(
            INK_CMAKE, {"--install", INK_BINARY_DIR, "--prefix", (desk_.work() / "usr").string()});
        ASSERT_EQ(outcome.exit_code, 0) << outcome.err;
    }
    std::string installed(const char* file) const { return (desk_.work() / "usr" / file).string(); }

    static constexpr const char* kManPages = "share/man/man1/";
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
    for (const char* command : kCommands)
        pages.push_back(std::string("inkbench-") + command + ".1");
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

}  // namespace
}  // namespace ink::program
