#include <fmt/format.h>
#include <gmock/gmock.h>

#include <array>
#include <fstream>
#include <iterator>
#include <limits>
#include <random>

#include "tests/import/quake_files.h"
#include "tests/models/fetched_model.h"
#include "tests/program/run_program.h"

// What a user may get wrong: one clear line on stderr, exit code 2, and nothing left behind.

namespace ink::program {
namespace {

/// One model file is refused by each command that takes one.
void expect_model_refused(const Desk& desk, const std::string& model) {
    for (const Words command : {"compare --out out", "advise", "draw -o a.png", "truth -o a.png"})
        expect_refused(desk, command + "--size 64x36" + Words{model}, model);
}

std::string random_bytes(std::size_t count) {
    std::mt19937 random(7);
    std::string bytes(count, '\0');
    for (char& byte : bytes)
        byte = static_cast<char>(random() & 0xff);
    return bytes;
}

/// A binary STL of one triangle whose first corner is (x, 0, 0).
std::string stl_triangle(float x) {
    std::string stl(80, ' ');
    import::put(stl, std::uint32_t{1});
    import::put(stl, std::array{0.F, 0.F, 1.F, x, 0.F, 0.F, 1.F, 0.F, 0.F, 0.F, 1.F, 0.F});
    import::put(stl, std::uint16_t{0});
    return stl;
}

TEST(BadModel, MissingOrAFolder) {
    const Desk desk;
    expect_model_refused(desk, "missing.obj");
    std::filesystem::create_directory(desk.work() / "folder.obj");
    expect_model_refused(desk, "folder.obj");
}

TEST(BadModel, OfNoModelNoTriangleOrNumbersThatAreNone) {
    const Desk desk;
    const std::string letter = "Dear Anna,\n\nvery long ago, from afar\n";
    for (const auto& [name, content] :
         {std::pair<const char*, std::string>{"empty.obj", ""},
          {"letter.obj", letter},
          {"noise.glb", random_bytes(4096)},
          {"model.nosuchformat", letter},
          {"drawing.dxf", "0\nSECTION\n2\nENTITIES\n0\nENDSEC\n0\nEOF\n"},
          {"drawing.obj", "0\nSECTION\n2\nENTITIES\n0\nENDSEC\n0\nEOF\n"},
          {"points.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\n"},
          {"none.off", "OFF\n3 0 0\n0 0 0\n1 0 0\n0 1 0\n"},
          {"nan.stl", stl_triangle(std::numeric_limits<float>::quiet_NaN())},
          {"inf.stl", stl_triangle(std::numeric_limits<float>::infinity())},
          {"nan.obj", "v nan 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n"}})
        expect_model_refused(desk, desk.write(name, content));
}

TEST(BadModel, CutShort) {
    const Desk desk;
    const std::string whole = stl_triangle(0);
    expect_done(desk, {"draw", desk.write("whole.stl", whole), "-o", "a.png", "--size", "64x36"});
    std::filesystem::remove(desk.work() / "a.png");
    expect_model_refused(desk, desk.write("cut.stl", whole.substr(0, whole.size() - 20)));
    expect_model_refused(desk, desk.write("stump.stl", whole.substr(0, 9)));
}

TEST(BadModel, RealOneCutShort) {
    const auto path = fetched_model("jeep.glb");
    INK_SKIP_WITHOUT(path);
    const Desk desk;
    std::ifstream file(path, std::ios::binary);
    const std::string whole{std::istreambuf_iterator<char>(file), std::istreambuf_iterator<char>()};
    expect_model_refused(desk, desk.write("cut.glb", whole.substr(0, whole.size() / 2)));
}

TEST(BadModel, OneAmongGoodOnesCostsNoWork) {
    const Desk desk;
    desk.write("good.obj", kTriangleObj);
    expect_refused(desk, "compare good.obj missing.obj --out out", "missing.obj");
}

TEST(BadName, OfAnything) {
    expect_all_refused(Desk(),
                       {},
                       {{"compair --out out", "compair"},
                        {"new-method Foo-Bar", {"inkbench: new-method: a method cannot be called"}},
                        {"list nonsense", "nonsense"},
                        {"compare --methods mote9 --out out", "mote4"},
                        {"compare --methods mote4,mote9 --out out", "mote9"},
                        {"draw torus --methods mote9 -o a.png", "mote9"},
                        {"compare --scenes torrus --out out", "torus"},
                        {"draw torrus -o a.png", "torrus"},
                        {"truth torrus -o a.png", "torrus"},
                        {"compare --set treshold=100 --out out", "threshold"},
                        {"draw torus --methods mote4 --set nosuch=1 -o a.png", "nosuch"},
                        {"compare --set threshold=9 torus", {"a scene stands before --set"}}});
}

TEST(BadValue, Parameter) {
    const Desk desk;
    for (const std::string& setting :
         Words("threshold=abc threshold=-5 threshold=1e9 threshold=nan threshold= threshold =5") +
             Words{""})
        expect_refused(desk, {"compare", "--set", setting, "--out", "out"}, "");
}

TEST(BadValue, Size) {
    const Desk desk;
    for (const std::string& size :
         Words("0x0 0x100 100x0 100000x100000 16385x16 12x x12 12 -5x5 5x-5 1e3x5 12x12x12 axb") +
             Words{" 12x12", ""}) {
        expect_refused(desk, {"compare", "--size", size, "--out", "out"}, "--size");
        expect_refused(desk, {"draw", "torus", "--size", size, "-o", "a.png"}, "--size");
        expect_refused(desk, {"truth", "torus", "--size", size, "-o", "a.png"}, "--size");
    }
}

TEST(BadValue, Numbers) {
    const Desk desk;
    for (const char* threads : {"0", "-1", "two", "1000000", "1.5"})
        expect_refused(desk, {"compare", "--threads", threads, "--out", "out"}, "--threads");
    for (const char* views : {"0", "-1", "many", "100000", "1.5", "front,3", "top,file", ","})
        expect_refused(desk, {"compare", "--views", views, "--out", "out"}, "--views");
    expect_refused(desk, "draw cube -o a.png --views top,frnt", {"there is no 'frnt'"});
    expect_refused(desk, "draw cube -o a.png --views frnt", {"did you mean front?"});
    expect_refused(desk, "draw cube -o a.png --views top,top", {"'top' is named twice"});
    for (const char* seed : {"-1", "x", "99999999999999999999999"})
        expect_refused(desk, {"compare", "--seed", seed, "--out", "out"}, "--seed");
}

TEST(BadValue, Camera) {
    const Desk desk;
    const auto expect = [&](const Words& more, const std::string& culprit) {
        expect_refused(desk, "draw torus -o a.png" + more, {culprit});
    };
    for (const char* point : {"1,2", "1,2,3,4", "a,b,c", "nan,0,0", "inf,0,0", "", "1;2;3"})
        expect({"--eye", point}, "--eye");
    expect({"--eye", "1,2,3", "--target", "x"}, "--target");
    expect({"--eye", "1,2,3", "--target", "1,2,3"}, "");
    expect({"--eye", "1,2,3", "--up", "0"}, "--up");
    for (const char* up : {"0,0,0", "0,-0,0.0"})
        expect({"--eye", "1,2,3", "--up", up}, "length is 0");
    expect({"--target", "1,2,3"}, "--target: there is no --eye");
    expect({"--up", "0,0,1"}, "--up: there is no --eye");
    expect({"--views", "file", "--up", "z"}, "--up: there is no --eye");
    for (const char* up : {"0,0,1", "w", "", "Z", "-z"})
        expect({"--views", "top", "--up", up}, "is no axis (accepted: x, y, z)");
    expect({"--fov", "30"}, "--fov: there is no --eye");
    expect({"--views", "2", "--up", "0,0,1"}, "--up: there is no --eye");
    for (const char* fov : {"0", "-40", "180", "nan", "wide"})
        expect({"--eye", "1,2,3", "--fov", fov}, "fov");
    for (const char* height : {"0", "-1", "nan", "inf", "high"})
        expect({"--eye", "1,2,3", "--parallel", height}, "--parallel");
    expect({"--eye", "1,2,3", "--fov", "30", "--parallel", "2"}, "--fov: there is a --parallel");
    expect({"--views", "2", "--fit", "box", "--parallel", "2"}, "--fit box finds the height");
    expect({"--projection", "perspective", "--parallel", "2"}, "--projection parallel");
    expect({"--projection", "flat"}, "perspective, parallel, or both");
    expect({"--projection", "parallel,parallel"}, "named twice");
}

TEST(BadOutput, WhereNoFolderCanBe) {
    const Desk desk;
    desk.write("taken", "a file");
    expect_refused(desk, "compare --out taken", "taken");
    expect_refused(desk, "compare --out taken/out", "taken");
    expect_refused(desk, "compare --out /dev/null/out", "/dev/null/out");
    expect_refused(desk, {"compare", "--out", ""}, "--out");
    EXPECT_EQ(desk.read("taken"), "a file");
}

TEST(BadOutput, WhereNoFileCanBe) {
    const Desk desk;
    desk.write("taken", "a file");
    for (const char* file : {"nowhere/a.png", "taken/a.png", "/dev/null/a.png", ".", ""}) {
        expect_refused(desk, {"draw", "torus", "-o", file, "--size", "64x36"}, "");
        expect_refused(desk, {"truth", "torus", "-o", file, "--size", "64x36"}, "");
    }
    expect_refused(desk, "draw torus -o a.nosuchformat", "a.nosuchformat");
    expect_refused(desk, "draw torus -o a.svg", "a.svg");
    expect_refused(desk, "truth torus --svg a.png", "a.png");
    for (const char* epsilon : {"-1", "0.5", "nan", "x"})
        expect_refused(desk, {"truth", "torus", "--weld-epsilon", epsilon}, "--weld-epsilon");
}

TEST(BadOutput, EarlierResultsStay) {
    const Desk desk;
    desk.write("out/rows.csv", "of yesterday\n");
    expect_refused(desk, "compare --methods mote9 --out out", "mote9");
    expect_refused(desk, "compare missing.obj --out out", "missing.obj");
    EXPECT_EQ(desk.read("out/rows.csv"), "of yesterday\n");
}

TEST(BadScore, Images) {
    const Desk desk;
    expect_done(desk, "truth torus -o truth.png --size 64x36");
    expect_done(desk, "truth torus -o wide.png --size 80x36");
    desk.write("empty.png", "");
    desk.write("letter.png", "Dear Anna,\n");
    desk.write("cut.png", desk.read("truth.png").substr(0, 60));
    for (const char* bad : {"missing.png", "empty.png", "letter.png", "cut.png", "wide.png"}) {
        expect_refused(desk, {"score", bad, "truth.png"}, bad);
        expect_refused(desk, {"score", "truth.png", bad}, bad);
    }
    expect_refused(desk, {"score", "truth.png"}, "truth");
}

TEST(BadScore, Options) {
    const Desk desk;
    expect_done(desk, "truth torus -o truth.png --size 64x36");
    const auto expect = [&](const std::string& option, const std::string& value) {
        expect_refused(desk, {"score", "truth.png", "truth.png", option, value}, "");
    };
    for (const char* value : {"0", "-1", "nan", "inf", "8.5", "65", "x"})
        expect("--tol", value);
    for (const char* value : {"0", "-1", "256", "12.5", "x"})
        expect("--threshold", value);
    for (const char* value : {"-1", "18", "x"})
        expect("--band", value);
    for (const char* value : {"0", "-1", "256", "x"})
        expect("--ignore", value);
}

/// A triangle with keys.
constexpr const char* kMovingFbx = R"(; FBX 7.4.0 project file
FBXHeaderExtension:  { FBXVersion: 7400
}
Objects:  {
 Model: 1, "Model::m", "Mesh" {
 }
 Geometry: 2, "Geometry::g", "Mesh" {
  Vertices: *9 { a: 0,0,0,1,0,0,0,1,0 }
  PolygonVertexIndex: *3 { a: 0,1,-3 }
 }
 AnimationCurve: 3, "AnimCurve::", "" {
  KeyTime: *2 { a: 0,46186158000 }
  KeyValueFloat: *2 { a: 0,1 }
 }
}
Connections:  {
 C: "OO",1,0
 C: "OO",2,1
}
)";

TEST(BadInput, MotionThatIsNotReadIsRefusedWithAWayToIt) {
    const Desk desk;
    desk.write("walker.fbx", kMovingFbx);
    for (const char* line : {"timedemo walker.fbx",
                             "export walker.fbx -o out --time 1",
                             "export walker.fbx -o out --frame 1",
                             "draw walker.fbx -o a.png --animation walk"})
        EXPECT_THAT(refusal(desk, line), testing::ContainsRegex("walker.*at rest alone.*glTF"))
            << line;
}

TEST(BadName, TooLongForAFile) {
    const Desk desk;
    const std::string name(300, 'x');
    for (const char* line : {"compare {} --out out",
                             "compare cube --size 64x36 --out {}",
                             "compare cube --entrant mine={}",
                             "advise {}",
                             "draw {} -o a.png",
                             "draw cube --size 64x36 -o {}.png",
                             "truth {}.obj -o a.png",
                             "score {0} {0}",
                             "score {0}.png {0}.exr",
                             "figures {} --out out",
                             "export {} -o out",
                             "bake {}.glb -o out.glb",
                             "page {} -o a.html",
                             "page cube -o {}.html",
                             "page cube --run {} -o a.html",
                             "timedemo {}",
                             "tune mote4 --scenes {}",
                             "entrant-test {}"})
        expect_refused(desk, fmt::format(fmt::runtime(line), name), name);
}

}  // namespace
}  // namespace ink::program
