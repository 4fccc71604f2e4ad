#include "report/live_page.h"

#include <gmock/gmock.h>

#include <nlohmann/json.hpp>

#include "bake/coded_mesh.h"
#include "catalogue/catalogue.h"
#include "core/error.h"
#include "tests/report/made_up_rows.h"
#include "tests/scene/small_meshes.h"

namespace ink::report {
namespace {

using testing::HasSubstr;
using testing::Not;

harness::SceneViews cube_views() {
    harness::SceneViews views{scene::scene_of({scene::unit_cube()}), {}};
    views.scene.name = "</script><b>";
    scene::View view{scene::look_at({0, 0, 4}, {0, 0, 0}, {0, 1, 0}, 0.7), 320, 180};
    view.camera.name = "front";
    views.views = {view};
    return views;
}

nlohmann::json data_of(const std::string& page) {
    constexpr std::string_view kBegin = "<script type=\"application/json\" id=\"data\">";
    const std::size_t begin = page.find(kBegin) + kBegin.size();
    return nlohmann::json::parse(page.substr(begin, page.find("</script>", begin) - begin));
}

TEST(LivePage, HoldsTheMeshItsViewsAndTheShaders) {
    const std::string page = live_page(cube_views(), std::nullopt);
    const nlohmann::json data = data_of(page);
    EXPECT_EQ(data["scene"], "</script><b>");
    EXPECT_EQ(data["triangle_count"], 12);
    EXPECT_EQ(data["views"][0]["name"], "front");
    EXPECT_EQ(data["views"][0]["width_px"], 320);
    EXPECT_FALSE(data.contains("scores"));
    for (const char* name : {"chords",
                             "surface_lookup",
                             "surface8",
                             "surface8_depth",
                             "label8",
                             "ids",
                             "roberts",
                             "decaudin",
                             "mote4",
                             "inverted_hull",
                             "fill",
                             "screen"})
        EXPECT_THAT(page, HasSubstr(std::string("//// method ") + name + "\n"));
    EXPECT_THAT(page, Not(HasSubstr("{{")));
    EXPECT_THAT(page, Not(HasSubstr("http://")));
    EXPECT_THAT(page, Not(HasSubstr("https://")));
    EXPECT_EQ(data["face_count"], 12);
    EXPECT_EQ(data["point_count"], 8);
    const bake::CodedMesh mesh = bake::coded_mesh(cube_views().scene);
    const std::size_t bytes = packed_mesh(mesh, {}).bytes.size();
    const std::size_t begin = page.find("class=\"mesh\">") + std::string("class=\"mesh\">").size();
    EXPECT_EQ(page.find("</script>", begin) - begin, (bytes + 2) / 3 * 4);
}

TEST(LivePage, HasTheExactLinesThatItIsGivenByViewAndClass) {
    const std::vector<ViewLines> lines = {{{"contour", "M1,2 3,4"}, {"crease", "M5,6 7,8"}}};
    const nlohmann::json data = data_of(live_page(cube_views(), std::nullopt, lines));
    EXPECT_EQ(data["views"][0]["lines"].dump(), R"({"contour":"M1,2 3,4","crease":"M5,6 7,8"})");
    EXPECT_TRUE(data_of(live_page(cube_views(), std::nullopt))["views"][0]["lines"].empty());
}

TEST(LivePage, ShowsWhatTheRunScoredAtTheViewsOfThatScene) {
    experiment::RunData run;
    run.folder = "runs/made up";
    for (const char* scene : {"</script><b>", "another"}) {
        harness::Row row = made_up_row("ids", 0.8, 2);
        row.scene = scene;
        row.view = "front";
        run.tables.rows.push_back(row);
    }
    run.tables.rows.back().f_2px = 0.1;
    const nlohmann::json data = data_of(live_page(cube_views(), run));
    EXPECT_EQ(data["run"], "made up");
    EXPECT_EQ(data["scores"].size(), 1U);
    EXPECT_EQ(data["scores"]["front"]["ids"]["f"], *run.tables.rows.front().f_2px);
    EXPECT_FALSE(data["scores"]["front"]["ids"].contains("why"));
}

TEST(LivePage, ShowsSoftFOrWhyAViewHasNone) {
    experiment::RunData run;
    harness::Row row = made_up_row("chords", 0.8, 2);
    row.scene = "</script><b>";
    row.view = "front";
    row.soft = score::SoftScore{.matched_px = 3, .missing_px = 1, .surplus_px = 1};
    run.tables.rows.push_back(row);
    row.method = "ids";
    row.f_2px.reset();
    row.soft.reset();
    row.status = "crowded: too dense";
    run.tables.rows.push_back(row);
    const nlohmann::json scores = data_of(live_page(cube_views(), run))["scores"]["front"];
    EXPECT_EQ(scores["chords"]["soft_f"], 0.75);
    EXPECT_EQ(scores["ids"], nlohmann::json({{"why", "crowded: too dense"}}));
}

std::string refusal_of(const harness::SceneViews& scene_views) {
    try {
        (void)live_page(scene_views, std::nullopt);
    } catch (const core::Error& error) {
        return error.what();
    }
    return "";
}

TEST(LivePage, OfNothingOrTooManyTrianglesIsRefusedInALine) {
    harness::SceneViews views = cube_views();
    views.scene.instances.clear();
    EXPECT_THAT(refusal_of(views), HasSubstr("no triangle"));
    views = cube_views();
    views.scene.instances.resize(kMostLiveTriangles / 12 + 1, views.scene.instances.front());
    EXPECT_THAT(refusal_of(views), testing::ContainsRegex("8000004 triangles.*8000000"));
}

}  // namespace
}  // namespace ink::report
