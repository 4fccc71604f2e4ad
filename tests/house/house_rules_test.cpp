#include "tests/house/house_rules.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

// Every rule is broken here on purpose, so that a rule that has stopped looking is noticed.

namespace ink::house {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::SizeIs;

SourceTree tree_of(std::vector<SourceFile> files) {
    SourceTree tree;
    tree.files = std::move(files);
    return tree;
}

/// A file that includes `paths`, one a line.
SourceFile file_with(std::string path, const std::vector<std::string>& paths) {
    SourceFile file{std::move(path), ""};
    for (const std::string& included : paths)
        file.text += "#include \"" + included + "\"\n";
    return file;
}

Findings arrow(const std::string& from, const std::string& to) {
    return check_arrows(tree_of({file_with(from, {to})}));
}

TEST(Arrows, ThoseOfTheTableAreAllowed) {
    EXPECT_THAT(arrow("src/raster/pass/pass.cpp", "scene/mesh.h"), IsEmpty());
    EXPECT_THAT(arrow("src/raster/pass/pass.cpp", "raster/pass/pass.h"), IsEmpty());
    EXPECT_THAT(arrow("src/harness/cell.cpp", "methods/registry.h"), IsEmpty());
    EXPECT_THAT(arrow("src/score/score.h", "truth/line_class.h"), IsEmpty());
    EXPECT_THAT(arrow("src/crosscheck/dense_sampling.h", "truth/line_class.h"), IsEmpty());
    EXPECT_THAT(arrow("methods/mote4/mote4.cpp", "shade/gouraud.h"), IsEmpty());
    EXPECT_THAT(arrow("src/core/parallel.cpp", "tbb/parallel_for.h"), IsEmpty());
}

TEST(Arrows, AllOthersAreNot) {
    EXPECT_THAT(arrow("src/core/image.h", "scene/mesh.h"),
                ElementsAre("src/core/image.h:1: scene/mesh.h is not allowed in core"));
    EXPECT_THAT(arrow("src/edge/thin.cpp", "scene/mesh.h"), SizeIs(1));
    EXPECT_THAT(arrow("src/raster/pass/pass.h", "edge/thin.h"), SizeIs(1));
    EXPECT_THAT(arrow("src/shade/gouraud.cpp", "truth/truth.h"), SizeIs(1));
    EXPECT_THAT(arrow("src/truth/truth.cpp", "raster/pass/pass.h"), SizeIs(1));
    EXPECT_THAT(arrow("src/score/score.cpp", "truth/truth.h"), SizeIs(1));
    EXPECT_THAT(arrow("src/import/import.cpp", "harness/row.h"), SizeIs(1));
    EXPECT_THAT(arrow("src/crosscheck/dense_sampling.cpp", "truth/truth.h"), SizeIs(1));
    EXPECT_THAT(arrow("src/harness/cell.cpp", "report/page.h"), SizeIs(1));
    EXPECT_THAT(arrow("src/experiment/summary.cpp", "tune/tune.h"), SizeIs(1));
    EXPECT_THAT(arrow("src/experiment/summary.cpp", "report/page.h"), SizeIs(1));
    EXPECT_THAT(arrow("methods/mote4/mote4.cpp", "score/score.h"), SizeIs(1));
    EXPECT_THAT(arrow("src/method/method.h", "truth/line_class.h"), SizeIs(1));
}

TEST(Arrows, AngleBracketsAndSpacesHideNothing) {
    EXPECT_THAT(check_arrows(tree_of({{"src/core/a.h", "  #  include <scene/mesh.h>\n"}})),
                SizeIs(1));
}

TEST(Arrows, TheLineIsNamed) {
    const auto tree =
        tree_of({file_with("src/edge/a.cpp", {"core/image.h", "raster/pass/pass.h"})});
    EXPECT_THAT(check_arrows(tree), ElementsAre(HasSubstr("src/edge/a.cpp:2: raster/pass/pass.h")));
}

TEST(Arrows, PathsStartAtTheRoot) {
    EXPECT_THAT(arrow("src/edge/thin.cpp", "../core/image.h"), SizeIs(1));
    EXPECT_THAT(arrow("src/edge/thin.cpp", "thin.h"), SizeIs(1));
    EXPECT_THAT(arrow("src/edge/thin.cpp", "src/core/image.h"), SizeIs(1));
    EXPECT_THAT(arrow("src/edge/thin.cpp", "tests/shared_files.h"), SizeIs(1));
}

TEST(Arrows, MethodsDoNotKnowEachOther) {
    EXPECT_THAT(arrow("methods/mote4/mote4.cpp", "methods/mote4/mote4.h"), IsEmpty());
    EXPECT_THAT(arrow("methods/mote4/mote4.cpp", "method/method.h"), IsEmpty());
    EXPECT_THAT(arrow("methods/registry.cpp", "methods/mote4/mote4.h"), IsEmpty());
    EXPECT_THAT(arrow("methods/mote16/mote16.cpp", "methods/mote4/mote4.h"), SizeIs(1));
    EXPECT_THAT(arrow("src/buffers/packed_buffer.h", "methods/mote4/mote4.h"), SizeIs(1));
}

TEST(Libraries, OneDoorEach) {
    const SourceFile door =
        file_with("src/truth/embree.h", {"embree3/rtcore.h", "embree4/rtcore.h"});
    const SourceFile bench = file_with("bench/packets.cpp", {"embree3/rtcore.h"});
    EXPECT_THAT(check_libraries(tree_of({door, bench})), IsEmpty());
    const SourceFile window = file_with("tests/raster/ids_test.cpp", {"embree4/rtcore.h"});
    EXPECT_THAT(check_libraries(tree_of({door, window})), SizeIs(2));
    EXPECT_THAT(check_libraries(tree_of({file_with("src/a/a.cpp", {"OpenImageIO/imageio.h"}),
                                         file_with("src/b/b.cpp", {"OpenImageIO/imageio.h"})})),
                SizeIs(2));
    EXPECT_THAT(check_libraries(tree_of({file_with("src/a/a.cpp", {"assimp/scene.h"}),
                                         file_with("src/b/b.cpp", {"assimp/mesh.h"})})),
                SizeIs(2));
}

TEST(Libraries, OpenCvAndCli11StayWhereTheyServe) {
    EXPECT_THAT(check_libraries(tree_of({file_with("src/score/a.cpp", {"opencv2/core.hpp"})})),
                IsEmpty());
    EXPECT_THAT(check_libraries(tree_of({file_with("src/edge/a.cpp", {"opencv2/core.hpp"})})),
                SizeIs(1));
    EXPECT_THAT(check_libraries(tree_of({file_with("src/draw/a.cpp", {"CLI/CLI.hpp"})})),
                SizeIs(1));
}

/// The folders that the project must have, and a CMakeLists.txt in each.
SourceTree empty_house() {
    SourceTree tree;
    tree.folders = {"methods", "tests", "bench", "src"};
    for (const std::string& room : room_names()) {
        if (room != "methods") tree.folders.push_back("src/" + room);
    }
    for (const std::string& folder : tree.folders)
        tree.files.push_back({folder + "/CMakeLists.txt", ""});
    return tree;
}

TEST(Folders, TheRoomsOfTheTableAreAllThereMayBe) {
    EXPECT_THAT(check_folders(empty_house()), IsEmpty());
    SourceTree more = empty_house();
    more.folders.push_back("src/video");
    EXPECT_THAT(check_folders(more),
                ElementsAre("src/video: no room of this name", "src/video: no CMakeLists.txt"));
    SourceTree less = empty_house();
    less.folders.pop_back();
    EXPECT_THAT(check_folders(less), ElementsAre("src/tune: this room is missing"));
}

TEST(Folders, ARoomHasItsCMakeLists) {
    SourceTree tree = empty_house();
    tree.files.pop_back();
    EXPECT_THAT(check_folders(tree), ElementsAre("src/tune: no CMakeLists.txt"));
}

TEST(Sizes, AFolderHoldsSixtyFilesAndNotOneMore) {
    SourceTree tree;
    for (int i = 0; i < 60; ++i)
        tree.files.push_back({"src/edge/f" + std::to_string(i) + ".cpp", "\n"});
    EXPECT_THAT(check_sizes(tree), IsEmpty());
    tree.files.push_back({"src/edge/deep/f.cpp", "\n"});
    tree.files.push_back({"tests/edge/f.cpp", "\n"});
    EXPECT_THAT(check_sizes(tree), IsEmpty());
    tree.files.push_back({"src/edge/f.h", "\n"});
    EXPECT_THAT(check_sizes(tree), ElementsAre("src/edge: 61 files"));
}

TEST(Sizes, AFolderHoldsSoManyLines) {
    const SourceFile most{"src/edge/a.cpp", std::string(4300, '\n')};
    EXPECT_THAT(check_sizes(tree_of({most})), IsEmpty());
    EXPECT_THAT(check_sizes(tree_of({most, {"src/edge/b.h", "\n"}})),
                ElementsAre("src/edge: 4301 lines"));
}

TEST(Folders, NoDrawers) {
    for (const char* drawer : {"src/core/utils", "tests/common", "methods/helpers"}) {
        SourceTree tree = empty_house();
        tree.folders.emplace_back(drawer);
        EXPECT_THAT(check_folders(tree), ElementsAre(HasSubstr("a drawer"))) << drawer;
    }
}

/// A tree with one method that lacks nothing.
SourceTree one_method() {
    SourceTree tree;
    tree.folders = {"methods", "methods/dots"};
    tree.files = {{"methods/registry.cpp",
                   "#include \"methods/dots/dots.h\"\nstatic const methods = {\n    dots(),\n};\n"},
                  {"methods/CMakeLists.txt", "dots/dots.cpp\n"},
                  {"methods/dots/dots.h", ""},
                  {"methods/dots/dots.cpp", ""},
                  {"methods/dots/dots.md", ""}};
    return tree;
}

TEST(Methods, AWordOfTheLanguageMayBeListedByALongerName) {
    SourceTree tree = one_method();
    tree.files[0].text = "#include \"methods/dots/dots.h\"\n    dots_method(),\n";
    EXPECT_THAT(check_methods(tree), IsEmpty());
}

TEST(Methods, EachHasItsFilesAndItsLines) {
    EXPECT_THAT(check_methods(one_method()), IsEmpty());
    for (const std::size_t file : {2, 3, 4}) {
        SourceTree tree = one_method();
        tree.files.erase(tree.files.begin() + static_cast<std::ptrdiff_t>(file));
        EXPECT_THAT(check_methods(tree), ElementsAre(HasSubstr(": missing"))) << file;
    }
    SourceTree forgotten = one_method();
    forgotten.files[0].text = "#include \"methods/dots/dots.h\"\n";
    forgotten.files[1].text = "dashes/dashes.cpp\n";
    EXPECT_THAT(check_methods(forgotten),
                ElementsAre("methods/registry.cpp: no line for dots",
                            "methods/CMakeLists.txt: no line for dots"));
    EXPECT_THAT(check_methods(SourceTree{}), SizeIs(1));
}

TEST(Methods, APresetHasAPageAndALineAndNoCode) {
    SourceTree tree = one_method();
    tree.folders.emplace_back("methods/fine_dots");
    tree.files[1].text += "fine_dots/fine_dots.toml\n";
    tree.files.push_back({"methods/fine_dots/fine_dots.toml", ""});
    tree.files.push_back({"methods/fine_dots/fine_dots.md", ""});
    EXPECT_THAT(check_methods(tree), IsEmpty());
    tree.files.back().path = "methods/fine_dots/fine_dots.cpp";
    tree.files[1].text = "dots/dots.cpp\n";
    EXPECT_THAT(check_methods(tree),
                ElementsAre("methods/fine_dots/fine_dots.md: missing",
                            "methods/fine_dots/fine_dots.cpp: a preset has no code",
                            "methods/CMakeLists.txt: no line for fine_dots"));
}

TEST(Headers, BeginWithTheirGuard) {
    EXPECT_THAT(check_headers(tree_of({{"a.h", "// Why.\n\n#pragma once\nint a;\n"}})), IsEmpty());
    EXPECT_THAT(check_headers(tree_of({{"a.h", "#include <vector>\n#pragma once\n"}})), SizeIs(1));
    EXPECT_THAT(check_headers(tree_of({{"a.h", "#ifndef A_H\n#define A_H\n#endif\n"}})), SizeIs(1));
    EXPECT_THAT(check_headers(tree_of({{"a.h", ""}})), SizeIs(1));
}

TEST(Flags, BuildFilesStayPortableAndExact) {
    for (const char* flag : {"-march=native", "-mtune=native", "-ffast-math", "-Ofast"}) {
        for (const char* path : {"CMakePresets.json", "src/core/CMakeLists.txt", "cmake/a.cmake"}) {
            EXPECT_THAT(check_flags(tree_of({{path, std::string("x ") + flag}})), SizeIs(1))
                << flag;
        }
        EXPECT_THAT(check_flags(tree_of({{"README.md", flag}})), IsEmpty()) << "prose may name it";
    }
    EXPECT_THAT(check_flags(tree_of({{"CMakeLists.txt", "-ffp-contract=off -O3"}})), IsEmpty());
}

TEST(Words, PathsOfOneMachineAreFound) {
    // Put together here, so that this file holds none of them.
    const std::string work = std::string("/wo") + "rk/";
    EXPECT_THAT(check_words(tree_of({{"a.md", "see " + work + "x"}})), SizeIs(1));
    EXPECT_THAT(check_words(tree_of({{"a.md", work + "x"}})), SizeIs(1));
    EXPECT_THAT(check_words(tree_of({{"a.md", std::string("/tm") + "p/bash_jobs.0/1"}})),
                SizeIs(1));
    EXPECT_THAT(check_words(tree_of({{"a.md", std::string("/home") + "/someone/x"}})), SizeIs(1));
    EXPECT_THAT(check_words(tree_of({{"a.md", "frame" + work + "time, the ${dir}" + work}})),
                IsEmpty());
}

TEST(Words, HostsOfPackagesAreFound) {
    for (const std::string& host : {std::string("deb.debian") + ".org",
                                    std::string("pypi") + ".org",
                                    std::string("europe.pkg") + ".dev",
                                    std::string("crates") + ".io"}) {
        EXPECT_THAT(check_words(tree_of({{"bootstrap", "a\nhttps://" + host + "/x"}})),
                    ElementsAre(HasSubstr("bootstrap:2: ")))
            << host;
    }
}

}  // namespace
}  // namespace ink::house
