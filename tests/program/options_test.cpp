#include <fmt/format.h>
#include <gmock/gmock.h>

#include "tests/program/run_program.h"

// Scenes, methods and folders are spelt alike in every command.

namespace ink::program {
namespace {

using testing::AllOf;
using testing::HasSubstr;
using testing::UnorderedElementsAreArray;

constexpr const char* kOneCube = R"(name = "tiny"
kind = "compare"
[grid]
scenes = ["cube"]
views = 1
methods = ["mote4"]
sizes = ["64x36"]
)";

/// The catalogue's scenes for which `is_wanted`, a,b.
std::string scenes_that(const Desk& desk,
                        const std::function<bool(const nlohmann::json&)>& is_wanted) {
    const auto all = expect_json(desk, "list scenes --json");
    std::string list;
    for (const auto& scene : all.at("scenes"))
        if (is_wanted(scene)) list += scene.at("name").get<std::string>() + ",";
    list.pop_back();
    return list;
}

TEST(SceneOption, AllSpellingsMeanTheSame) {
    const Desk desk;
    desk.write("tiny.toml", kOneCube);
    const Words plan = "run tiny.toml --dry-run";
    const std::string wanted = expect_done(desk, plan + "--scenes torus,gem");
    EXPECT_THAT(wanted, AllOf(HasSubstr("torus"), HasSubstr("gem")));
    for (const Words& spelling : {Words{"--scenes", " torus , gem "},
                                  Words("--scenes torus --scenes gem"),
                                  Words("--scene torus --scene=gem"),
                                  Words("--scenes torus gem"),
                                  Words("--scenes tor?s ge[m]"),
                                  Words{"--scenes", "torus,tor*,gem"},
                                  Words{"torus", "gem"},
                                  Words{"torus, gem"}})
        EXPECT_EQ(expect_done(desk, plan + spelling), wanted) << testing::PrintToString(spelling);
}

TEST(SceneOption, GroupsAndGlobsAreTheCataloguesScenes) {
    const Desk desk;
    desk.write("tiny.toml", kOneCube);
    const Words plan = "run tiny.toml --dry-run";
    const auto split = [](const char* name) {
        return [name](const nlohmann::json& scene) { return scene.at("split") == name; };
    };
    const auto is_c = [](const nlohmann::json& scene) {
        return scene.at("name").get<std::string>().front() == 'c';
    };
    const auto any = [](const nlohmann::json&) { return true; };
    EXPECT_EQ(expect_done(desk, plan + "--scenes train"),
              expect_done(desk, plan + "--scenes" + scenes_that(desk, split("train"))));
    EXPECT_EQ(expect_done(desk, plan + "heldout"),
              expect_done(desk, plan + scenes_that(desk, split("heldout"))));
    EXPECT_EQ(expect_done(desk, plan + "--scenes catalogue"),
              expect_done(desk, plan + "--scenes" + scenes_that(desk, any)));
    EXPECT_EQ(expect_done(desk, plan + "--scenes c*"),
              expect_done(desk, plan + "--scenes" + scenes_that(desk, is_c)));
}

TEST(SceneOption, ModelFilesStandInListsAndGlobsToo) {
    const Desk desk;
    for (const char* name : {"one.obj", "two.obj", "a, b.obj"})
        desk.write(name, kTriangleObj);
    const Words plan = "compare --methods mote4 --size 64x36 --dry-run";
    const std::string both = expect_done(desk, plan + "one.obj two.obj");
    EXPECT_THAT(both, AllOf(HasSubstr(" one view0 "), HasSubstr(" two view0 ")));
    EXPECT_EQ(expect_done(desk, plan + "--scenes one.obj,two.obj"), both);
    EXPECT_EQ(expect_done(desk, plan + "--scene ???.obj"), both);
    EXPECT_THAT(expect_done(desk, plan + Words{"a, b.obj"}), HasSubstr(" a, b view0 "));
}

TEST(SceneOption, EveryCommandTakesBothWays) {
    const Desk desk;
    const std::vector<Words> commands = {
        "compare --methods mote4 --no-sweep --repetitions 1 --out out",
        "figures --methods mote4 --repetitions 1 --only strips --out figures",
        "tune --method mote4 --evaluations 2 --no-random --force",
        "advise -o a.png",
        "draw -o a.png",
        "truth -o b.png",
        "explain",
        "timedemo --method mote4 --frames 2"};
    for (const Words& command : commands) {
        for (const char* scene : {"cube", "--scene cube"})
            expect_done(desk, command + "--size 64x36" + scene);
    }
    expect_done(desk, "truth -o b.png --size 64x36 --scenes=cube");
}

TEST(SceneOption, OfOneSceneSaysSoWhereThereAreMore) {
    for (const Words command : {"advise", "draw -o a.png", "truth", "explain", "timedemo"})
        expect_all_refused(Desk(),
                           command,
                           {{"", {command[0], "the scene is missing"}},
                            {"cube --scene torus", {command[0], "one scene", "2: torus, cube"}}});
}

TEST(SceneOption, UnknownNamesListWhatThereIs) {
    const Desk desk;
    for (const char* wrong : {"torsu", "cube,torsu", "torsu*"}) {
        expect_refused(desk,
                       fmt::format("compare --scenes {} --out out", wrong),
                       {"--scenes", "torsu", "staircase", "heldout", "did you mean torus?"});
    }
    expect_refused(desk, {"compare", "--scenes", "", "--out", "out"}, {"--scenes", "no scene"});
    expect_refused(desk, {"compare", "--scenes", " , ", "--out", "out"}, {"--scenes", "no scene"});
    expect_refused(desk, "compare no/*.obj --out out", {"no/*.obj"});
}

TEST(MethodOption, AllSpellingsMeanTheSame) {
    const Desk desk;
    const auto drawn = [&](const Words& spelling) {
        expect_done(
            desk,
            "compare cube --size 64x36 --views 1 --no-sweep --no-times --force -o out" + spelling);
        Words methods;
        for (const auto& row : rows_of(desk))
            methods.push_back(row.at("method"));
        return methods;
    };
    const Words wanted = drawn("--methods mote2,mote4,mote16,ids");
    for (const Words& spelling : {Words{"--method", "mote2, mote4 ,mote16,ids"},
                                  Words("--methods mote2 --method mote4,mote16,ids"),
                                  Words("--methods mote?,mote?? --method=ids"),
                                  Words("--methods mote[24],mote2 --methods mote16,ids")})
        EXPECT_THAT(drawn(spelling), UnorderedElementsAreArray(wanted))
            << testing::PrintToString(spelling);
    const Words plan = "compare cube --dry-run";
    EXPECT_EQ(expect_done(desk, plan + "--methods all"), expect_done(desk, plan));
}

TEST(MethodOption, UnknownNamesListWhatThereIs) {
    const Desk desk;
    for (const char* command : {"compare", "figures", "timedemo", "stress"}) {
        expect_refused(desk,
                       {command, "--methods", "sobl"},
                       {"--method", "sobl", "decaudin", "did you mean sobel?"});
        expect_refused(desk, {command, "--method", "sobl*"}, {"no method fits", "sobel?"});
    }
    expect_refused(desk, "draw cube -o a.png --method mote*", {"not one method"});
    expect_refused(desk, {"tune", "sobl"}, {"sobl", "did you mean sobel?"});
    expect_refused(desk, {"tune"}, {"tune", "the method is missing"});
    expect_refused(desk, "compare --methods ids,ids", {"'ids' is named twice"});
    expect_refused(desk, "compare --methods ,", {"--methods", "names no method"});
}

TEST(DemoOption, IsADozenScenesUnlessOthersAreNamed) {
    const Desk desk;
    const std::string plan = expect_done(desk, "compare --demo --dry-run");
    EXPECT_THAT(plan, HasSubstr(" in 12 blocks"));
    expect_done(desk, "compare --demo --scenes cube --methods ids --size 64x36");
    const Table rows = rows_of(desk, "inkbench-out/demo");
    EXPECT_EQ(rows.size(), 5U);  // with four baselines
    EXPECT_EQ(rows.at(0).at("scene"), "cube");
}

TEST(OutOption, IsSpeltTwoWaysEverywhere) {
    const Desk desk;
    const Words compare = "compare cube --methods ids --no-sweep --no-times --size 64x36";
    expect_done(desk, compare + "--out a/b");
    expect_done(desk, compare + "-o c");
    EXPECT_EQ(desk.read("a/b/rows.csv"), desk.read("c/rows.csv"));
    EXPECT_NE(desk.read("c/rows.csv"), "");
}

TEST(OutOption, IsAFolderCalledAfterTheScenesUnlessSaid) {
    const Desk desk;
    desk.write("my cube.obj", kCubeObj);
    const Words compare = "compare --methods ids --no-sweep --no-times --size 64x36";
    expect_done(desk, compare + Words{"my cube.obj"});
    expect_done(desk, compare + "cube torus");
    EXPECT_EQ(rows_of(desk, "inkbench-out/my_cube").at(0).at("scene"), "my cube");
    EXPECT_EQ(rows_of(desk, "inkbench-out/cube_torus").at(0).at("scene"), "cube");
}

TEST(ViewOption, TakesTheNamesOfViews) {
    const Desk desk;
    desk.write("cube.obj", kCubeObj);
    const Words model = "cube.obj --size 64x36";
    expect_done(desk, "draw -o view.png --view iso" + model);
    expect_done(desk, "draw -o views.png --views iso" + model);
    EXPECT_EQ(desk.read("view.png"), desk.read("views.png"));
    EXPECT_THAT(expect_done(desk, "truth --view front" + model), HasSubstr("cube.obj front\n"));
    expect_done(desk, "score view.png --view iso --model cube.obj");
    // A built-in scene's own view comes first, and those that were asked for are all there are.
    EXPECT_THAT(expect_done(desk, "explain cube --view front --json"), HasSubstr("\"fov_deg\""));
    expect_refused(desk, "draw -o a.png --views 2 --view top" + model, {"no view 'top'", "view1"});
}

TEST(RecordedCommand, CanBePastedIntoAShell) {
    const Desk desk;
    expect_done(desk,
                "tune mote4 --scenes cub* --size 64x36 --evaluations 2 --no-random "
                "--quiet --out out");
    EXPECT_THAT(desk.read("out/mote4_cube.toml"),
                AllOf(HasSubstr("inkbench tune mote4"),
                      HasSubstr("--scenes 'cub*' --size 64x36"),
                      testing::Not(HasSubstr("--quiet"))));
}

}  // namespace
}  // namespace ink::program
