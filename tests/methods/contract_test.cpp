// What every method of the registry must hold: one law each, over all of them.

#include <gmock/gmock.h>

#include <algorithm>
#include <set>

#include "catalogue/shapes.h"
#include "core/error.h"
#include "methods/registry.h"
#include "scene/animation.h"
#include "tests/core/error_text.h"
#include "tests/methods/names.h"
#include "tests/methods/small_scenes.h"
#include "tests/methods/two_px.h"

namespace ink::methods {
namespace {

/// A method, and how the camera looks.
using Contracted = std::tuple<std::string, scene::ProjectionKind>;

class Contract : public testing::TestWithParam<Contracted> {
  protected:
    static std::string method_name() { return std::get<0>(GetParam()); }
    const method::MethodInfo& info() const { return find_method(method_name()); }
    scene::View view_from(const scene::Scene& scene,
                          const glm::dvec3& eye_world,
                          const glm::dvec3& target_world,
                          std::pair<int, int> size_px) const {
        return methods::view_from(scene, eye_world, target_world, size_px, std::get<1>(GetParam()));
    }
    /// Whether flat faces are all that there is, each of one tone, and it looks at tones alone.
    static bool shows_nothing() {
        return !draws_polyhedra(method_name()) &&
               std::get<1>(GetParam()) == scene::ProjectionKind::parallel;
    }
    /// How many of so many pixels rounding may move: those at a step of a packed code, and of canny
    /// whole chains, which stay or go by their strongest pixel.
    static int allowed(int lines_px) { return 3 + lines_px / (method_name() == "canny" ? 4 : 14); }
    edge::EdgeImage draw(const core::ParamValues& values, int threads = 1) const {
        return drawn(info(), values, scene_, {view_, threads});
    }
    static scene::Scene with_its_cube_elsewhere(scene::Scene scene) {
        scene.instances[0].world_from_object = glm::translate(glm::dmat4(1), {1, 0.5, 0});
        return scene;
    }

    const scene::Scene scene_ = cube_on_floor();
    const scene::Scene moved_ = with_its_cube_elsewhere(scene_);
    // Not a multiple of the tile size either way, and more than one tile.
    const scene::View view_ = view_from(scene_, {4, 3, 6}, {0, 0, 0}, {150, 101});
};

int lines_in(const edge::EdgeImage& image) {
    return static_cast<int>(std::count_if(
        image.data(), image.data() + image.size(), [](std::uint8_t s) { return s > 0; }));
}

bool is_of_one_colour(const core::Image<glm::u8vec3>& rgb) {
    const glm::u8vec3 first = rgb.at(0, 0);
    return std::all_of(rgb.data(), rgb.data() + rgb.size(), [&](const glm::u8vec3& pixel) {
        return pixel == first;
    });
}

TEST_P(Contract, DrawsSomethingButNotEverything) {
    if (!draws_polyhedra(method_name())) GTEST_SKIP() << "it draws no line of a box on a floor";
    const int lines = lines_in(draw({}));
    EXPECT_GT(lines, draws_creases(method_name()) ? 200 : 100);
    EXPECT_LT(lines, 150 * 101 / 4);
}

TEST_P(Contract, WritesEveryPixelWhateverWasThere) {
    const auto method = posed_method(info(), {}, scene_);
    edge::EdgeImage over_zeros(view_.width_px, view_.height_px, 0);
    method->draw({view_, 1}, over_zeros);
    EXPECT_EQ(over_zeros, image_by(*method, {view_, 1}));
    EXPECT_EQ(over_zeros.width_px(), view_.width_px);
    EXPECT_EQ(over_zeros.height_px(), view_.height_px);
}

TEST_P(Contract, DrawsTheSameOnEveryThreadCount) {
    const auto one = draw({}, 1);
    EXPECT_EQ(one, draw({}, 2));
    EXPECT_EQ(one, draw({}, 4));
}

TEST_P(Contract, LayersHaveTheSizeOfTheViewAndAreTheSameOnEveryThreadCount) {
    const auto method = posed_method(info(), {}, scene_);
    const auto one = method->layers({view_, 1});
    const auto three = method->layers({view_, 3});
    ASSERT_EQ(one.size(), three.size());
    std::set<std::string> names;
    for (std::size_t i = 0; i < one.size(); ++i) {
        SCOPED_TRACE(one[i].name);
        names.insert(one[i].name);
        EXPECT_EQ(one[i].rgb.width_px(), 150);
        EXPECT_EQ(one[i].rgb.height_px(), 101);
        EXPECT_EQ(one[i].name, three[i].name);
        EXPECT_EQ(one[i].rgb, three[i].rgb);
        EXPECT_FALSE(is_of_one_colour(one[i].rgb));
    }
    EXPECT_EQ(names.size(), one.size()) << "two are called the same";
}

TEST_P(Contract, LayersChangeNoImage) {
    const auto method = posed_method(info(), {}, moved_);
    (void)image_by(*method, {view_, 1});
    method->pose(scene_);
    for (const scene::View& view : {view_, view_from(scene_, {0.2, 0.3, 5}, {0, 0, 0}, {90, 64})}) {
        (void)method->layers({view, 1});
        EXPECT_EQ(image_by(*method, {view_, 1}), draw({}));
    }
}

TEST_P(Contract, DrawsTheSameAfterTheCameraMovedAndCameBack) {
    const auto method = posed_method(info(), {}, scene_);
    const auto first = image_by(*method, {view_, 1});
    (void)image_by(*method, {view_from(scene_, {0.2, 0.3, 0.1}, {1, 0, 0}, {90, 64}), 1});
    EXPECT_EQ(image_by(*method, {view_, 1}), first);
}

TEST_P(Contract, DrawsTheSameAfterTheSceneMovedAndCameBack) {
    const auto method = info().make({});
    method->prepare(scene_);
    method->pose(moved_);
    const auto there = image_by(*method, {view_, 1});
    method->pose(scene_);
    const auto back = image_by(*method, {view_, 1});
    EXPECT_EQ(there, drawn(info(), {}, moved_, {view_, 1}));
    EXPECT_EQ(back, draw({}));
    EXPECT_TRUE(shows_nothing() || there != back);
}

/// The cube turns and grows on the floor, which moves away below it; its vertices move, too: it
/// becomes a wedge, so that bends, patches and clusters change with the pose.
scene::Scene moving_cube_on_floor() {
    scene::Scene scene = cube_on_floor();
    scene::Animation motion;
    motion.duration_s = 2;
    motion.frames_per_s = 1;
    scene::AnimatedNode turner;
    turner.translations = {{0, {0, 0, 0}}, {2, {0.5, 0.25, 0}}};
    turner.rotations = {{0, {1, 0, 0, 0}}, {2, {0.8, 0, 0.6, 0}}};
    turner.scales = {{0, {1, 1, 1}}, {2, {1, 1.5, 1}}};
    scene::AnimatedNode sinker;
    sinker.parent_from_node = scene.instances[1].world_from_object;
    sinker.translations = {{0, {0, -1, 0}}, {2, {0, -1.25, 0}}};
    sinker.rotations = {{0, {1, 0, 0, 0}}};
    sinker.scales = {{0, {1, 1, 1}}};
    motion.nodes = {turner, sinker};
    motion.node_of_instance = {0, 1};
    motion.vertex_frames.resize(2);
    scene::VertexFrames& frames = motion.vertex_frames[0];
    frames.frame_count = 3;
    for (const float squeeze : {1.0F, 0.75F, 0.125F}) {
        for (glm::vec3 p : scene.meshes[0].positions) {
            if (p.y > 0) p.x *= squeeze;
            frames.positions.push_back(p);
        }
    }
    scene.animation = std::make_shared<const scene::Animation>(motion);
    scene::check_animation(scene, motion);
    return scene;
}

/// What a method prepares of a pose that stays while the scene moves: its codes.
bool keeps_codes(const std::string& name) {
    static const std::set<std::string> kCoded = {"auto",
                                                 "label8",
                                                 "label_plane",
                                                 "surface8",
                                                 "surface8_depth",
                                                 "surface_lookup",
                                                 "strokes",
                                                 "chords"};
    return kCoded.contains(name);
}

TEST_P(Contract, AnAnimatedSceneIsDrawnAsIfPreparedInEveryPose) {
    scene::Scene moving = moving_cube_on_floor();
    const scene::Scene start = moving;
    const auto method = posed_method(info(), {}, moving);
    const auto at = [&](double time_s) {
        scene::pose_scene(moving, time_s);
        method->pose(moving);
        const auto image = image_by(*method, {view_, 1});
        const auto fresh = info().make({});
        fresh->prepare(keeps_codes(method_name()) ? start : moving);
        fresh->pose(moving);
        EXPECT_EQ(image, image_by(*fresh, {view_, 1})) << time_s << " s";
        return image;
    };
    const auto first = at(0);
    EXPECT_EQ(first, draw({})) << "it rests in its first pose";
    for (const double time_s : {0.5, 1.9, 2.0})
        EXPECT_TRUE(at(time_s) != first || shows_nothing());
    EXPECT_EQ(at(0), first) << "posed back";
}

/// A ring that a bone bends, a cube that a target drives out, and a cube on a node that turns. None
/// rests as it begins to move.
scene::Scene restless() {
    scene::Scene scene =
        scene_of({catalogue::make_torus({1.5, 0.5}, {24, 12}), cube_mesh(), cube_mesh()});
    scene::Animation motion;
    motion.duration_s = 2;
    scene::AnimatedNode bone;
    bone.translations = {{0, {0, 0, 0}}};
    bone.rotations = {{0, {0.6, 0, 0, 0.8}}, {2, {0.8, 0.6, 0, 0}}};
    bone.scales = {{0, {1, 1, 1}}};
    scene::AnimatedNode turner;
    turner.parent_from_node = glm::translate(glm::dmat4(1), {-2, 1, -1});
    turner.translations = {{0, {2, 1, 0}}};
    turner.rotations = {{0, {0.8, 0, 0.6, 0}}, {2, {1, 0, 0, 0}}};
    turner.scales = {{0, {1, 2, 1}}, {2, {1, 0.5, 1}}};
    motion.nodes = {{}, bone, turner};
    motion.node_of_instance = {scene::kNoNode, 0, 2};
    scene::Skin skin;
    skin.positions = scene.meshes[0].positions;
    skin.bones = {{0}, {1}};
    std::vector<std::vector<scene::BoneWeight>> weights;
    for (const glm::vec3& p : skin.positions)
        weights.push_back({{0, 0.5F - 0.25F * p.x}, {1, 0.5F + 0.25F * p.x}});
    scene::set_weights(weights, skin);
    motion.skins = {skin};
    scene::Morph::Target target;
    target.weights = {{0, 1}, {2, 0.25}};
    for (const glm::vec3& p : scene.meshes[1].positions)
        target.positions.push_back(p.x > 0 && p.y > 0 ? glm::vec3(2, 0, p.z) : glm::vec3(0));
    motion.morphs = {{.mesh = 1, .positions = scene.meshes[1].positions, .targets = {target}}};
    scene.animation = std::make_shared<const scene::Animation>(motion);
    scene::check_animation(scene, motion);
    scene::rest_scene(scene);
    return scene;
}

TEST_P(Contract, AModelThatMovesIsDrawnAsOneThatStandsStillInThatPose) {
    scene::Scene moving = restless();
    const scene::View view = view_from(moving, {4, 5, 7}, {0, 0, 0}, {150, 101});
    for (const double time_s : {-1.0, 0.0, 1.5, 2.0}) {
        if (time_s >= 0) scene::pose_scene(moving, time_s);
        scene::Scene still = moving;
        still.animation = nullptr;
        EXPECT_EQ(drawn(info(), {}, moving, {view, 1}), drawn(info(), {}, still, {view, 1}))
            << (time_s < 0 ? "at rest" : "at a time");
    }
}

TEST_P(Contract, DrawsTheSameFromAPreparedSceneThatItShares) {
    const scene::PreparedScene shared(scene_);
    const auto first = info().make({});
    first->prepare(shared);
    first->pose(shared);
    for (const core::ParamValues& values : info().sweep) {
        const auto second = info().make(values);
        second->prepare(shared);
        second->pose(shared);
        EXPECT_EQ(image_by(*second, {view_, 1}), draw(values));
        // What moves in one of them must not move in the other.
        second->pose(moved_);
        EXPECT_EQ(image_by(*second, {view_, 1}), drawn(info(), values, moved_, {view_, 1}));
        EXPECT_EQ(image_by(*first, {view_, 1}), draw({}));
    }
}

/// Pixels that are drawn in one image alone.
int differing(const edge::EdgeImage& a, const edge::EdgeImage& b, int threshold) {
    int count = 0;
    for (std::size_t i = 0; i < a.size(); ++i)
        count += (a.data()[i] >= threshold) != (b.data()[i] >= threshold) ? 1 : 0;
    return count;
}

TEST_P(Contract, TurnedWithTheSceneTheCameraSeesTheSame) {
    const int threshold = std::stoi(info().complete({}).at("threshold"));
    const edge::EdgeImage still = draw({});
    for (const double angle_rad : {0.8, 2.3, 4.4}) {
        const glm::dmat4 turn = glm::rotate(glm::dmat4(1), angle_rad, glm::dvec3(0.3, 1, -0.4));
        const scene::Turned turned(scene_, view_, turn);
        const auto image = drawn(method_name(), {}, turned.scene, {turned.view, 1});
        EXPECT_LE(differing(still, image, threshold), allowed(lines_in(still))) << angle_rad;
    }
}

TEST_P(Contract, TheOrderOfTrianglesAndCornersDoesNotMatter) {
    const int threshold = std::stoi(info().complete({}).at("threshold"));
    const edge::EdgeImage straight = draw({});
    scene::Scene shuffled = scene_;
    for (scene::Mesh& mesh : shuffled.meshes) {
        std::reverse(mesh.triangles.begin(), mesh.triangles.end());
        for (std::size_t t = 0; t < mesh.triangles.size(); t += 2)
            std::rotate(
                mesh.triangles[t].begin(), mesh.triangles[t].begin() + 1, mesh.triangles[t].end());
    }
    const auto image = drawn(method_name(), {}, shuffled, {view_, 1});
    EXPECT_LE(differing(straight, image, threshold), allowed(lines_in(straight)));
}

TEST_P(Contract, AMirroredSceneGivesTheMirroredLines) {
    const int threshold = std::stoi(info().complete({}).at("threshold"));
    scene::Scene mirrored = scene_;
    for (scene::Instance& instance : mirrored.instances)
        instance.world_from_object =
            glm::scale(glm::dmat4(1), glm::dvec3(-1, 1, 1)) * instance.world_from_object;
    const scene::View view = view_from(mirrored, {-4, 3, 6}, {0, 0, 0}, {150, 101});
    const auto lines = [&](const edge::EdgeImage& image, bool is_mirrored) {
        edge::EdgeImage straight(150, 101);
        for (int y = 0; y < 101; ++y)
            for (int x = 0; x < 150; ++x)
                straight.at(x, y) = image.at(is_mirrored ? 149 - x : x, y) >= threshold ? 255 : 0;
        return straight;
    };
    // Lines two pixels wide take the other side of the border between two pixels.
    const auto [of, near] =
        count_near(lines(draw({}), false), lines(drawn(info(), {}, mirrored, {view, 1}), true), 1);
    EXPECT_LE(of - near, allowed(of));
}

TEST_P(Contract, AnEmptySceneGivesZeros) {
    const scene::Scene empty;
    EXPECT_EQ(lines_in(drawn(method_name(), {}, empty, {view_, 1})), 0);
}

TEST_P(Contract, NothingVisibleGivesZeros) {
    const scene::View away = view_from(scene_, {4, 3, 6}, {8, 6, 12}, {150, 101});
    EXPECT_EQ(lines_in(drawn(method_name(), {}, scene_, {away, 1})), 0);
}

TEST_P(Contract, AnEmptyImageIsDrawnToo) {
    scene::View view = view_;
    view.width_px = 0;
    EXPECT_EQ(drawn(method_name(), {}, scene_, {view, 1}).size(), 0U);
}

TEST_P(Contract, EveryParameterWorksAtBothEndsAndInEveryChoice) {
    for (const core::Param& param : info().params) {
        std::set<double> values{param.min, param.max};
        if (param.kind == core::ParamKind::choice) {
            for (double choice = 0; choice <= param.max; ++choice)
                values.insert(choice);
        }
        for (const double value : values) {
            const core::ParamValues set{{param.name, core::format_param(param, value)}};
            SCOPED_TRACE(param.name + " = " + set.at(param.name));
            const auto one = draw(set, 1);
            EXPECT_EQ(one.width_px(), view_.width_px);
            EXPECT_EQ(one, draw(set, 3));
            EXPECT_EQ(info().complete(set).at(param.name), set.at(param.name));
        }
    }
}

TEST_P(Contract, AnEyeInsideTheModelIsDrawnToo) {
    const scene::View inside = view_from(scene_, {0.5, -0.9, 0.1}, {-1, 0, -0.4}, {150, 101});
    const auto image = drawn(method_name(), {}, scene_, {inside, 1});
    EXPECT_EQ(image, drawn(method_name(), {}, scene_, {inside, 3}));
    // From inside a box and a floor there are creases, but no contours.
    if (draws_creases(method_name())) {
        EXPECT_GT(lines_in(image), 50);
    }
}

TEST_P(Contract, AnUnknownParameterIsAnErrorThatNamesTheMethod) {
    EXPECT_THAT(core::error_text([this] {
                    return info().make({{"treshold", "3"}});
                }),
                testing::ContainsRegex("^" + method_name() + ": .*did you mean threshold.?"));
    EXPECT_THROW((void)info().make({{"threshold", "0"}}), core::Error);
}

TEST_P(Contract, ShipsAThresholdAndCountsItsBytes) {
    const int threshold = std::stoi(info().complete({}).at("threshold"));
    EXPECT_GE(threshold, 1);
    EXPECT_LE(threshold, 255);
    EXPECT_GT(info().make({})->bytes_per_px(), 0);
}

const core::Param* find_param(const method::MethodInfo& info, const std::string& name) {
    const auto found = std::find_if(info.params.begin(), info.params.end(), [&](const auto& param) {
        return param.name == name;
    });
    return found == info.params.end() ? nullptr : &*found;
}

TEST_P(Contract, HasAFamilyAndAMarkerThatNoOtherOfItHas) {
    // What chooses among families is of none.
    EXPECT_EQ(info().family == method::Family::other, info().is_planned);
    for (const method::MethodInfo& other : registry()) {
        const bool is_alike = other.family == info().family && other.marker == info().marker &&
                              other.preset_of.empty() == info().preset_of.empty();
        EXPECT_EQ(is_alike, other.name == info().name) << other.name;
    }
    EXPECT_FALSE(info().source.empty());
}

TEST_P(Contract, TunablesAreItsOwnAndTheSearchCanStartAtTheirDefaults) {
    for (const method::Tunable& tunable : info().tunables) {
        SCOPED_TRACE(tunable.param);
        const core::Param* param = find_param(info(), tunable.param);
        ASSERT_NE(param, nullptr);
        if (!tunable.range) continue;
        EXPECT_TRUE(param->is_number());
        EXPECT_GE(tunable.range->first, param->min);
        EXPECT_LE(tunable.range->second, param->max);
        EXPECT_LE(tunable.range->first, param->default_value);
        EXPECT_GE(tunable.range->second, param->default_value);
    }
    for (const method::SumLimit& limit : info().sum_limits) {
        double sum = 0;
        for (const std::string& name : limit.params) {
            ASSERT_NE(find_param(info(), name), nullptr) << name;
            sum += find_param(info(), name)->default_value;
        }
        EXPECT_LE(sum, limit.limit);
    }
}

TEST_P(Contract, BytesAreKnownOfSettingsUnlessTheSceneDecides) {
    const auto bytes = info().bytes_per_px({});
    EXPECT_EQ(bytes.has_value(), info().make({})->plan().empty());
    if (bytes) {
        EXPECT_EQ(*bytes, info().make({})->bytes_per_px());
    }
}

TEST_P(Contract, DrawsTheSameAtEveryThresholdUnlessItSaysOtherwise) {
    if (info().draws_by_threshold) GTEST_SKIP() << "it draws by its threshold";
    const edge::EdgeImage own = draw({});
    for (const char* threshold : {"1", "100", "255"})
        EXPECT_EQ(draw({{"threshold", threshold}}), own) << threshold;
}

TEST_P(Contract, IsSweptOverEightSettingsThatDiffer) {
    std::set<core::ParamValues> settings;
    for (const core::ParamValues& setting : info().sweep)
        settings.insert(info().complete(setting));  // throws for what no table knows
    EXPECT_EQ(settings.size(), info().sweep.size()) << "two come out the same";
    EXPECT_GE(settings.size(), 8U);
    EXPECT_EQ(settings.count(info().complete({})), 1U) << "the method as it comes";
}

TEST_P(Contract, EverySettingOfTheSweepDrawsSomethingButNotEverything) {
    if (!draws_polyhedra(method_name())) GTEST_SKIP() << "it draws no line of a box on a floor";
    for (const core::ParamValues& setting : info().sweep) {
        const int threshold = std::stoi(info().complete(setting).at("threshold"));
        const auto image = draw(setting);
        const auto lines = std::count_if(image.data(),
                                         image.data() + image.size(),
                                         [&](std::uint8_t s) { return s >= threshold; });
        SCOPED_TRACE(testing::PrintToString(setting));
        EXPECT_GT(lines, draws_creases(method_name()) ? 100 : 10);
        EXPECT_LT(lines, 150 * 101 / 4);
        EXPECT_EQ(image, draw(setting, 3));
    }
}

std::string name_of(const testing::TestParamInfo<Contracted>& contracted) {
    const auto& [method, projection] = contracted.param;
    return method + (projection == scene::ProjectionKind::parallel ? "_parallel" : "");
}

INSTANTIATE_TEST_SUITE_P(Every,
                         Contract,
                         testing::Combine(testing::ValuesIn(method_names()),
                                          testing::Values(scene::ProjectionKind::perspective,
                                                          scene::ProjectionKind::parallel)),
                         name_of);

TEST(Registry, NamesAreUnique) {
    const auto names = method_names();
    EXPECT_EQ(std::set<std::string>(names.begin(), names.end()).size(), names.size());
    EXPECT_GE(names.size(), 4U);
}

TEST(Registry, AnUnknownMethodIsAnErrorThatListsTheKnown) {
    EXPECT_THAT(core::error_text([] { return find_method("mote5"); }),
                testing::ContainsRegex("decaudin.*did you mean mote"));
}

}  // namespace
}  // namespace ink::methods
