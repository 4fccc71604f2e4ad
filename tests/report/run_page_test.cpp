#include "report/run_page.h"

#include <fmt/format.h>
#include <gmock/gmock.h>

#include <filesystem>
#include <fstream>
#include <nlohmann/json.hpp>

#include <set>

#include "core/error.h"
#include "core/image.h"
#include "experiment/run_data.h"
#include "experiment/run_record.h"
#include "harness/images/view_images.h"
#include "image_io/image_file.h"
#include "methods/registry.h"
#include "report/live_page.h"
#include "report/packed_run.h"
#include "tests/core/temp_folder.h"
#include "tests/report/made_up_rows.h"

namespace ink::report {
namespace {

namespace fs = std::filesystem;
using testing::HasSubstr;
using testing::Not;

/// A run folder with two views of one scene, one method, and images of both.
class RunPage : public testing::Test {
  protected:
    void SetUp() override {
        experiment::RunRecord record;
        record.name = "<made up>";
        record.kind = "compare";
        record.command = "inkbench compare </script>";
        record.identity = "0123456789abcdef";
        record.asked = "methods = 'mote4'\n";
        record.state = experiment::RunState::finished;
        experiment::write_record(record, folder_.path());
        run_.record = record;
        run_.folder = folder_.path();
        for (const char* view : {"front", "side"}) {
            harness::Row row = made_up_row("mote4", 0.8, 2);
            row.scene = "cube";
            row.view = view;
            row.width = 160;
            row.height = 90;
            row.threshold = 128;
            run_.tables.rows.push_back(row);
            write_images(row);
        }
    }

    void write_images(const harness::Row& row) const {
        const fs::path images = folder_ / harness::image_folder(row.scene, row.view);
        fs::create_directories(images);
        const auto labels = made_up_labels({}, 3);
        image_io::write_png(labels, images / "truth.png");
        image_io::write_png(made_up_drawing(labels, 0.2, 5), images / "mote4.png");
        image_io::write_png(core::Image<std::uint8_t>(160, 90), images / "mote4.errors.png");
    }

    const core::TempFolder folder_;
    experiment::RunData run_;
};

TEST_F(RunPage, NamesFromOutsideCloseNoElement) {
    const std::string page = run_page({run_}).html;
    EXPECT_THAT(page, HasSubstr("inkbench compare \\u003c/script>"));
    const fs::path odd = folder_ / "<b>";
    fs::create_directories(odd);
    fs::copy(folder_ / "run.toml", odd / "run.toml");
    EXPECT_THAT(run_page({experiment::read_run(odd)}).html,
                HasSubstr("<title>Inkbench: &lt;b&gt;</title>"));
}

TEST_F(RunPage, SaysWhatTheVerdictSaysAndHowRunsDiffer) {
    run_.comparison = summary::compare_methods(run_.tables.rows);
    const std::string page = run_page({run_, run_}).html;
    EXPECT_THAT(
        page,
        HasSubstr(
            R"("words":{"first":"mote4 finds 80.0 % of the outline, and 80.0 % of what it )"
            R"(draws is right, in 2.00 ms","rest":"Its F is 0.800; it is the only method.")"));
    EXPECT_THAT(page, HasSubstr(R"("summary.csv":{"lines":1,)")) << "which its folder lacks";
    EXPECT_THAT(
        page,
        HasSubstr(R"("diffs":[[{},{"mote4":{"f_2px":null,"soft_f":null,"time_ratio":null}}],)"));
}

TEST_F(RunPage, SaysWhatTheAnswerIsAndWhatToDoWithIt) {
    run_.comparison = summary::compare_methods(run_.tables.rows);
    run_.record.asked = "[grid]\nscenes = ['cube', 'my models/spot.obj']\n";
    run_.csv = experiment::split_tables(
        {{"methods.csv", "method,preset_of,summary\nmote4,,sums\n"}}, run_.folder);
    const TakeHome home = take_home(run_, fs::path(INK_SOURCE_DIR) / "experiments/pages");
    EXPECT_EQ(home.method, "sums");
    EXPECT_EQ(home.address, "../../methods/mote4/mote4.md");
    const std::string run = run_.folder.string();
    std::vector<std::string> lines;
    for (const auto& [what, line] : home.commands)
        lines.push_back(line);
    EXPECT_THAT(lines,
                testing::ElementsAre("inkbench page 'my models/spot.obj' --run " + run,
                                     "inkbench bake 'my models/spot.obj' -o spot.ink.glb --edges",
                                     "inkbench advise 'my models/spot.obj'",
                                     "inkbench figures " + run));
    run_.comparison = {};
    EXPECT_TRUE(take_home(run_, run_.folder).commands.empty());
}

TEST_F(RunPage, AFileThatCannotBeWrittenIsAnError) {
    EXPECT_THROW(write_run_page({run_}, folder_ / "no" / "page.html"), core::Error);
}

TEST_F(RunPage, LinksToTheLivePagesOfTheRunsFolder) {
    EXPECT_THAT(run_page({run_}).html, HasSubstr(R"("live":{})"));
    const fs::path live = folder_ / live_page_path("cube");
    fs::create_directories(live.parent_path());
    std::ofstream(live) << "<!doctype html>";
    EXPECT_THAT(run_page({run_}).html, HasSubstr(R"("live":{"cube":"live/cube.html"})"));
    fs::create_directories(folder_ / "elsewhere");
    EXPECT_THAT(run_page({run_}, folder_ / "elsewhere").html, HasSubstr(R"("../live/cube.html")"));
}

TEST_F(RunPage, HoldsTheImagesOfEveryView) {
    const auto images =
        nlohmann::json::parse(packed_images({run_}, folder_.path(), 1'000'000).json);
    ASSERT_EQ(images.size(), 1U);
    EXPECT_EQ(images[0].size(), 2U);
    const auto& view = images[0]["cube\nfront"];
    EXPECT_EQ(view["width"], 160);
    EXPECT_EQ(view["height"], 90);
    EXPECT_THAT(view["truth"].get<std::string>(), testing::StartsWith("iVBORw0KGgo"));
    const auto image = view["methods"].at("mote4").get<std::size_t>();
    EXPECT_THAT(view["images"].at(image).get<std::string>(), testing::StartsWith("iVBORw0KGgo"));
}

TEST_F(RunPage, HoldsTheInkOfMethodsThatDrawIt) {
    const auto ink_of = [this](const char* is_ink) {
        run_.csv = experiment::split_tables(
            {{"methods.csv", std::string("method,ink\nmote4,") + is_ink + "\n"}}, run_.folder);
        const auto images =
            nlohmann::json::parse(packed_images({run_}, folder_.path(), 1'000'000).json);
        return images[0]["cube\nfront"]["inks"].at(0);
    };
    EXPECT_TRUE(ink_of("false").is_null());
    EXPECT_THAT(ink_of("true").get<std::string>(), testing::StartsWith("iVBORw0KGgo"));
}

TEST_F(RunPage, ImagesThatAreTooManyLieBesideThePage) {
    const PackedImages whole = packed_images({run_}, folder_.path(), 1'000'000);
    EXPECT_TRUE(whole.beside.empty());
    const PackedImages parted =
        packed_images({run_}, folder_ / "elsewhere", whole.json.size() * 3 / 4);
    const auto views = nlohmann::json::parse(parted.json)[0];
    EXPECT_TRUE(views["cube\nfront"].contains("truth")) << "the first view has room first";
    EXPECT_EQ(views["cube\nside"],
              nlohmann::json::parse(R"({"width":160,"height":90,"methods":{"mote4":0},)"
                                    R"("beside":"../images/cube/side/page.js"})"));
    ASSERT_EQ(parted.beside.size(), 1U);
    const auto& [file, script] = *parted.beside.begin();
    EXPECT_EQ(file, folder_ / "images/cube/side/page.js");
    const auto all = nlohmann::json::parse(whole.json)[0]["cube\nside"];
    EXPECT_EQ(
        script,
        fmt::format("document.currentScript.images={{\"truth\":{},\"images\":{},\"inks\":{}}};\n",
                    all["truth"].dump(),
                    all["images"].dump(),
                    all["inks"].dump()));
}

TEST_F(RunPage, ARunOfAnotherSizeHasNoImagesOfItsOwn) {
    for (harness::Row& row : run_.tables.rows)
        row.width = 320;
    const auto images =
        nlohmann::json::parse(packed_images({run_}, folder_.path(), 1'000'000).json);
    EXPECT_TRUE(images[0]["cube\nfront"]["methods"].empty());
}

TEST(MethodLooks, NoTwoMethodsOfAFamilyShareAMarker) {
    std::set<std::tuple<method::Family, method::Marker, bool>> looks;
    for (const method::MethodInfo& info : methods::registry()) {
        const bool is_hollow = !info.preset_of.empty();
        EXPECT_TRUE(looks.insert({info.family, info.marker, is_hollow}).second) << info.name;
    }
}

}  // namespace
}  // namespace ink::report
