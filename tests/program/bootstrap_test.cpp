#include <gmock/gmock.h>

#include <filesystem>
#include <string>

#include "tests/program/run_program.h"

// The script that leads from nothing to a first result, with stand-ins for all that it calls: they
// write down how, install nothing and build nothing.

namespace ink::program {
namespace {

namespace fs = std::filesystem;
using testing::AllOf;
using testing::AnyOf;
using testing::HasSubstr;
using testing::Not;

class Bootstrap : public testing::Test {
  protected:
    Bootstrap() {
        fs::create_directories(tree() / "build/release");
        fs::copy_file(fs::path(INK_SOURCE_DIR) / "bootstrap", tree() / "bootstrap");
        desk_.write("tree/CMakePresets.json", "{}\n");
        stand_in("tree/build/release/inkbench", "echo inkbench \"$@\" >>" + calls());
        stand_in("bin/ctest", "echo ctest \"$@\" >>" + calls());
        stand_in("bin/apt-get", "echo apt-get \"$@\" >>" + calls());
        stand_in("bin/dpkg-query", "echo dpkg-query \"$@\" >>" + calls() + "; echo installed");
        // Remembers what it was configured with, as the real one does.
        stand_in("bin/cmake",
                 "echo cmake \"$@\" >>" + calls() + "\n[ \"$1\" = --preset ] || exit 0\n" + "cd " +
                     (tree() / "build/release").string() + "\ntouch build.ninja\n" +
                     "echo CMAKE_HOME_DIRECTORY:INTERNAL=" + tree().string() +
                     " >CMakeCache.txt\nfor word; do case $word in -D*) word=${word#-D}\n"
                     "echo \"${word%%=*}:BOOL=${word#*=}\" >>CMakeCache.txt;; esac; done");
    }

    fs::path tree() const { return desk_.work() / "tree"; }
    std::string calls() const { return (desk_.work() / "calls").string(); }

    void stand_in(const std::string& name, const std::string& script) {
        fs::create_directories((desk_.work() / name).parent_path());
        desk_.write(name, "#!/usr/bin/env bash\n" + script + "\n");
        fs::permissions(desk_.work() / name, fs::perms::owner_exec, fs::perm_options::add);
    }

    Outcome run(const Words& words) {
        fs::remove(calls());
        desk_.write("calls", "");
        Words all = {"PATH=" + (desk_.work() / "bin").string() + ":/usr/bin:/bin",
                     "bash",
                     (tree() / "bootstrap").string()};
        all += words;
        return desk_.run_other("/usr/bin/env", all);
    }

    /// What the script called, a line a call, after a success.
    std::string calls_of(const Words& words) {
        const Outcome outcome = run(words);
        EXPECT_EQ(outcome.exit_code, 0) << outcome.err << outcome.out;
        return desk_.read("calls");
    }

    Desk desk_;
};

TEST_F(Bootstrap, DemoBuildsTheProgramAlone) {
    EXPECT_THAT(calls_of({"demo"}),
                AllOf(HasSubstr("-DBUILD_TESTING=OFF -DINKBENCH_BENCH=OFF"),
                      HasSubstr("--target inkbench"),
                      HasSubstr(" node-d3\n"),
                      Not(HasSubstr("gtest")),
                      Not(HasSubstr("libbenchmark")),
                      Not(HasSubstr("python"))));
}

TEST_F(Bootstrap, DemoWritesOverItsOwnFolderOnly) {
    EXPECT_THAT(
        calls_of({"demo", "--size", "64x36"}),
        HasSubstr("inkbench compare --demo --size 64x36 --out inkbench-out/demo --force\n"));
    EXPECT_THAT(calls_of({"demo", "--out", "mine"}),
                HasSubstr("inkbench compare --demo --out mine\n"));
    EXPECT_THAT(calls_of({"demo", "--out=mine"}),
                HasSubstr("inkbench compare --demo --out=mine\n"));
}

TEST_F(Bootstrap, DemoSaysWhereTheReportIsAndHowToRunAll) {
    const Outcome outcome = run({"demo"});
    EXPECT_THAT(outcome.out,
                AllOf(HasSubstr((desk_.work() / "inkbench-out/demo/report.html").string()),
                      HasSubstr("build/release/inkbench compare\n")));
}

TEST_F(Bootstrap, TestConfiguresWhatDemoLeftOut) {
    EXPECT_EQ(run({"demo"}).exit_code, 0);
    EXPECT_THAT(calls_of({"test", "-R", "Cube"}),
                AllOf(HasSubstr("-DBUILD_TESTING=ON -DINKBENCH_BENCH=ON"),
                      HasSubstr(" libgtest-dev\n"),
                      HasSubstr("ctest --preset release"),
                      HasSubstr(" -R Cube\n")));
    // And is not undone by the next demo, nor done twice.
    EXPECT_THAT(calls_of({"demo"}), Not(HasSubstr("--preset release -D")));
    EXPECT_THAT(calls_of({"test"}), Not(HasSubstr("--preset release -D")));
}

TEST_F(Bootstrap, PackageBuildsTheModuleToo) {
    stand_in("bin/cpack", "echo cpack \"$@\" >>" + calls() + "; touch build/package/a.deb");
    fs::create_directories(tree() / "build/package");
    EXPECT_THAT(
        calls_of({"package"}),
        AllOf(HasSubstr(" pybind11-dev"), HasSubstr("--target inkbench inkbench_python\ncpack ")));
}

TEST_F(Bootstrap, InstallsABrowserAndAFuzzerOnlyIfAskedTo) {
    EXPECT_THAT(calls_of({"install"}), Not(AnyOf(HasSubstr("chromium"), HasSubstr("clang"))));
    EXPECT_THAT(calls_of({"install", "browser"}),
                AllOf(HasSubstr(" chromium-driver\n"), HasSubstr(" libgtest-dev\n")));
    EXPECT_THAT(calls_of({"install", "fuzz"}),
                AllOf(HasSubstr(" clang\n"), HasSubstr(" libclang-rt-dev\n")));
}

TEST_F(Bootstrap, RefusesWordsThatItDoesNotKnow) {
    for (const Words& words : {Words{"dmeo"}, Words{"install", "chrome"}}) {
        const Outcome outcome = run(words);
        EXPECT_EQ(outcome.exit_code, 2) << testing::PrintToString(words);
        EXPECT_THAT(outcome.err, AllOf(HasSubstr(words.back()), HasSubstr("accepted: ")));
        EXPECT_EQ(desk_.read("calls"), "");
    }
}

}  // namespace
}  // namespace ink::program
