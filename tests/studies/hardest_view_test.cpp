#include "studies/hardest/hardest_view.h"

#include <gtest/gtest.h>

#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/trigonometric.hpp>
#include <numbers>
#include <random>

#include "catalogue/catalogue.h"
#include "methods/method_configs.h"
#include "scene/views/framing.h"
#include "studies/hardest/hardest_table.h"

namespace ink::studies {
namespace {

harness::SceneViews scene_called(const std::string& name) {
    return harness::make_scene_views(catalogue::make_catalogue_scene(name),
                                     {.width_px = 128, .height_px = 72});
}

HardestOptions options_of(const std::string& method, int evaluations) {
    HardestOptions options{methods::make_configs(method, {}).front()};
    options.evaluations = evaluations;
    options.seed = 5;
    options.least_truth_px = 40;
    options.cell.trace.truth.threads = 1;
    return options;
}

std::vector<HardestLook> found(const std::string& scene, const HardestOptions& options) {
    return search_hardest_views(scene_called(scene), options).value();
}

const HardestLook& worst_of(const std::vector<HardestLook>& looks) {
    return *std::find_if(
        looks.begin(), looks.end(), [](const HardestLook& look) { return look.rank == 1; });
}

TEST(ViewSpace, HoldsSensibleViewsAlone) {
    const scene::Scene scene = catalogue::make_catalogue_scene("gear");
    const ViewSpace space(scene);
    ASSERT_EQ(space.size(), 8U) << "it moves";
    std::mt19937 random(3);
    for (int i = 0; i < 200; ++i) {
        std::vector<double> point(space.size());
        for (double& x : point)
            x = static_cast<double>(random() % 1001) / 1000;
        const ViewChoice choice = space.at(point);
        const scene::Sphere& ball = space.ball();
        const double radii = glm::distance(choice.eye, ball.center_world) / ball.radius;
        EXPECT_GE(radii, kNearest_radii - 1e-3);
        EXPECT_LE(radii, kFarthest_radii + 1e-3);
        EXPECT_LE(glm::distance(choice.target, ball.center_world), ball.radius * 1.001);
        EXPECT_GE(choice.fov_deg, kLeastFov_deg);
        EXPECT_LE(choice.fov_deg, kMostFov_deg);
        ASSERT_TRUE(choice.time_s);
        EXPECT_GE(*choice.time_s, 0);
        EXPECT_LE(*choice.time_s, scene.animation->duration_s);
    }
}

TEST(ViewSpace, FindsThePointOfACamera) {
    const scene::Scene scene = catalogue::make_catalogue_scene("rocket");
    const ViewSpace space(scene);
    // The target lies in the plane through the middle that faces the eye: the point is the same.
    std::vector<double> point = {0.3, 0.6, 0.5, 0.5, 0.5, 0.5, 0.25};
    const ViewChoice choice = space.at(point);
    const scene::Camera camera =
        harness::make_camera(choice.camera(), scene.origin, scene::bounding_sphere(scene));
    const std::vector<double> back = space.point_of(camera);
    for (std::size_t i = 0; i < point.size(); ++i)
        EXPECT_NEAR(back[i], point[i], 2e-3) << i;
}

TEST(ViewSpace, RefusesASceneWithoutExtent) {
    scene::Scene scene = catalogue::make_catalogue_scene("cube");
    scene.instances.resize(1);
    for (scene::Mesh& mesh : scene.meshes)
        std::fill(mesh.positions.begin(), mesh.positions.end(), glm::vec3(1));
    EXPECT_THROW(ViewSpace{scene}, core::Error);
}

TEST(HardestView, IsAtLeastAsBadAsAsManyRandomViews) {
    for (const char* scene : {"staircase", "teapot"}) {
        const HardestOptions options = options_of("mote4", 120);
        const HardestLook worst = worst_of(found(scene, options));
        for (const HardestLook& look : random_views(scene_called(scene), options)) {
            if (!look.is_candidate()) continue;
            EXPECT_LE(worst.value, look.value) << scene << " " << look.view_words();
        }
    }
}

TEST(HardestView, IsTheSameBySeed) {
    HardestOptions options = options_of("mote4", 25);
    const std::string first = hardest_table(false).file(found("rocket", options));
    EXPECT_EQ(hardest_table(false).file(found("rocket", options)), first);
    options.seed = 6;
    EXPECT_NE(hardest_table(false).file(found("rocket", options)), first);
}

TEST(HardestView, RanksDistinctCandidates) {
    const harness::SceneViews scene_views = scene_called("staircase");
    const HardestOptions options = options_of("mote4", 60);
    const std::vector<HardestLook> looks = search_hardest_views(scene_views, options).value();
    const ViewSpace space(scene_views.scene);
    std::vector<const HardestLook*> kept(static_cast<std::size_t>(options.worst));
    double least = 1;
    for (const HardestLook& look : looks) {
        if (look.phase == "usual") {
            EXPECT_FALSE(look.rank);
            continue;
        }
        if (look.is_candidate()) {
            EXPECT_GE(look.count.n_truth, options.least_truth_px);
            EXPECT_EQ(look.value, look.f_2px.value());
            least = std::min(least, look.value);
        } else {
            EXPECT_GE(look.value, 1);
        }
        if (look.rank) kept.at(static_cast<std::size_t>(*look.rank - 1)) = &look;
    }
    ASSERT_NE(kept.front(), nullptr);
    EXPECT_EQ(kept.front()->value, least);
    for (std::size_t i = 1; i < kept.size(); ++i) {
        ASSERT_NE(kept[i], nullptr) << i;
        EXPECT_GE(kept[i]->value, kept[i - 1]->value);
        for (std::size_t j = 0; j < i; ++j) {
            const double along =
                glm::dot(space.direction(kept[i]->choice), space.direction(kept[j]->choice));
            EXPECT_LT(along, std::cos(glm::radians(kDistinct_deg)));
        }
    }
}

TEST(HardestView, AgainstAnotherIsTheLossToIt) {
    HardestOptions options = options_of("mote4", 40);
    options.against = methods::make_configs("id_lookup", {}).front();
    for (const HardestLook& look : found("rocket", options)) {
        EXPECT_EQ(look.against, "id_lookup");
        if (look.is_candidate()) {
            EXPECT_EQ(look.value, look.f_2px.value() - look.f_against.value());
        }
    }
}

TEST(HardestView, WithAWidthOfTrueLinesIsOfSoftF) {
    HardestOptions options = options_of("surface_lookup", 30);
    options.against = methods::make_configs("strokes", {}).front();
    options.cell.line_width_px = 1;
    const std::vector<HardestLook> looks = found("rocket", options);
    for (const HardestLook& look : looks) {
        if (look.is_candidate()) {
            EXPECT_EQ(look.value, look.soft->f().value() - look.soft_f_against.value());
        }
    }
    EXPECT_LT(worst_of(looks).value, 0) << "strokes draws more of the ink";
    const std::string text = hardest_table(true).file(looks);
    const auto read = hardest_table(true).read(core::split_csv(text, "hardest.csv"));
    EXPECT_EQ(hardest_table(true).file(read), text);
    EXPECT_NE(hardest_text(read).find("soft F least"), std::string::npos);
}

TEST(HardestView, OfASceneThatMovesIsAtAMoment) {
    const harness::SceneViews rest = scene_called("gear");
    const std::vector<HardestLook> looks =
        search_hardest_views(rest, options_of("mote4", 20)).value();
    const HardestLook& worst = worst_of(looks);
    EXPECT_EQ(worst.scene, "gear");
    EXPECT_EQ(worst.shown_as, fmt::format("gear.{:g}s", worst.choice.time_s.value()));
    const std::vector<harness::SceneViews> views = worst_scene_views(rest, looks);
    ASSERT_FALSE(views.empty());
    EXPECT_EQ(views.front().scene.name, worst.shown_as);
    EXPECT_EQ(views.front().views.front().camera.name, "mote4_1");
}

TEST(HardestTable, ReadsWhatItWrote) {
    const std::vector<HardestLook> looks = found("gear", options_of("mote4", 10));
    const std::string text = hardest_table(false).file(looks);
    const auto read = hardest_table(false).read(core::split_csv(text, "hardest.csv"));
    EXPECT_EQ(hardest_table(false).file(read), text);
    EXPECT_NE(hardest_text(read).find(worst_of(looks).view_words()), std::string::npos);
    EXPECT_EQ(hardest_text({}), "");
}

}  // namespace
}  // namespace ink::studies
