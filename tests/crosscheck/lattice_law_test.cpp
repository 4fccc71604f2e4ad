// Laws over random scenes on a lattice, where faces lie in one plane, edges on edges and eyes in
// the planes of both: truth and cross-check agree, a line is whole or not there, and turning a
// scene changes nothing.

#include <functional>
#include <glm/gtc/quaternion.hpp>

#include "harness/truths/compare_truths.h"
#include "scene/predicates.h"
#include "tests/crosscheck/lattice_shapes.h"
#include "truth/model.h"

namespace ink::crosscheck {
namespace {

constexpr int kScenes = 100;
constexpr int kFarthest = 12;  ///< an eye, along each axis
constexpr int kNearest = 7;    ///< along at least one: the scenes reach to 6 at most
constexpr double kMostAbstained = 0.01;

/// A scene and where it is seen from.
struct Setting {
    scene::Scene scene;
    glm::dvec3 eye{0}, target{0}, up{0, 1, 0};
    scene::ProjectionKind projection = scene::ProjectionKind::perspective;

    [[nodiscard]] scene::View view() const {
        scene::View view = truth::view_from(eye, target);
        const double near = view.camera.near;
        view.camera = scene::look_at(eye, target, up, 40 * std::numbers::pi / 180);
        view.camera.near = near;
        view.width_px = 240;
        view.height_px = 180;
        if (projection == scene::ProjectionKind::parallel) {
            view.camera = scene::parallel_camera({target, target - eye, up, 12},
                                                 scene::bounding_sphere(scene));
        }
        return view;
    }
};

enum class Parts { solids, soups };

/// One to four objects, some of two parts.
scene::Scene any_scene(LatticeShapes& shapes, Parts parts) {
    const auto any_part = [&] {
        return parts == Parts::soups ? shapes.soup() : shapes.any_solid();
    };
    std::vector<scene::Mesh> objects;
    for (int i = shapes.number(1, 4); i > 0; --i) {
        scene::Mesh object = any_part();
        if (shapes.number(0, 3) == 0) {
            const scene::Mesh other = any_part();
            for (const scene::Triangle& t : other.triangles) {
                const auto& p = other.positions;
                truth::add_triangle(object, p[t[0]], p[t[1]], p[t[2]]);
            }
        }
        objects.push_back(std::move(object));
    }
    return truth::scene_of(std::move(objects));
}

/// Solids that lie on each other, in one plane and edge on edge.
scene::Scene touching_solids(LatticeShapes& shapes) {
    std::vector<scene::Mesh> objects;
    for (int i = shapes.number(2, 6); i > 0; --i)
        objects.push_back(shapes.any_solid());
    return truth::scene_of(std::move(objects));
}

/// A lattice point in the plane of a face, or in that of an edge and a vertex; nothing if a scene
/// has no face or chance finds none.
std::optional<glm::dvec3> eye_in_a_plane(LatticeShapes& shapes, const scene::Scene& scene) {
    const scene::Topology topology = scene::weld(scene);
    if (topology.faces.empty()) return std::nullopt;
    const auto& p = topology.p_world;
    const auto one_of = [&](const auto& all) -> const auto& {
        return all[static_cast<std::size_t>(shapes.number(0, static_cast<int>(all.size()) - 1))];
    };
    for (int attempt = 0; attempt < 3000; ++attempt) {
        const glm::dvec3 eye(shapes.place(-kFarthest, kFarthest));
        if (std::max({std::abs(eye.x), std::abs(eye.y), std::abs(eye.z)}) < kNearest) continue;
        const scene::Face& face = one_of(topology.faces);
        const bool is_face = shapes.number(0, 1) == 0;
        const glm::dvec3 third = is_face ? p[face.vertices[2]] : one_of(p);
        if (scene::orient3d(p[face.vertices[0]], p[face.vertices[1]], third, eye) == 0) return eye;
    }
    return std::nullopt;
}

/// `has_cut`: the near plane cuts a parallel view, and the cross-check may abstain beside the cut.
void expect_agreement(const truth::Model& model,
                      const scene::View& view,
                      const truth::Truth& truth,
                      bool has_cut = false) {
    const SamplingOptions options;
    const SampledLines crosscheck = sample_lines(model.topology, view, options);
    harness::Agreement agreement = harness::compare_truths(truth.curves, crosscheck, view);
    harness::judge_disagreements(model.topology, view, options, agreement);
    EXPECT_LE(crosscheck.counts.unexplained, has_cut ? 2U : 0U);
    EXPECT_LT(agreement.abstained_share(), has_cut ? 0.1 : kMostAbstained);
    for (std::size_t i = 0; i < truth::kLineClasses.size(); ++i) {
        const harness::ClassAgreement& c = agreement.by_class[i];
        EXPECT_TRUE(c.is_agreed()) << truth::name(truth::kLineClasses[i]) << ": " << c.truth_px
                                   << " px seen to " << c.truth_share() << ", " << c.crosscheck_px
                                   << " px traced to " << c.crosscheck_share();
    }
}

class LatticeLaw : public testing::TestWithParam<Parts> {};

/// Holds truth and cross-check of scenes against each other, seen from the planes of their faces
/// and edges; returns how many were.
int expect_no_tie(int scenes,
                  scene::ProjectionKind projection,
                  LatticeShapes& shapes,
                  const std::function<scene::Scene()>& next) {
    int seen = 0;
    for (int i = 0; i < scenes; ++i) {
        SCOPED_TRACE(i);
        Setting setting{next(), {}, glm::dvec3(shapes.place(-1, 1))};
        setting.projection = projection;
        const auto eye = eye_in_a_plane(shapes, setting.scene);
        if (!eye) continue;
        setting.eye = *eye;
        const glm::dvec3 sight = glm::normalize(setting.target - setting.eye);
        if (std::abs(sight.y) > 0.99) setting.up = {1, 0, 0};
        const truth::Model model = truth::build_model(setting.scene, {.threads = 1});
        const truth::Truth truth =
            truth::trace_truth(model, setting.view(), {.threads = 1, .layers = false});
        expect_agreement(model, setting.view(), truth);
        ++seen;
    }
    return seen;
}

TEST_P(LatticeLaw, AnEyeInThePlanesOfFacesAndEdgesIsNoTie) {
    std::mt19937_64 random(31);
    LatticeShapes shapes(random);
    const auto next = [&] { return any_scene(shapes, GetParam()); };
    EXPECT_GT(expect_no_tie(kScenes, scene::ProjectionKind::perspective, shapes, next),
              kScenes / 2);
}

TEST_P(LatticeLaw, ADirectionInThePlanesOfFacesAndEdgesIsNoTie) {
    std::mt19937_64 random(33);
    LatticeShapes shapes(random);
    const auto next = [&] { return any_scene(shapes, GetParam()); };
    EXPECT_GT(expect_no_tie(kScenes, scene::ProjectionKind::parallel, shapes, next), kScenes / 2);
}

/// A house of slabs that touch, with pillars and benches on its floor.
scene::Scene house(LatticeShapes& shapes) {
    std::vector<scene::Mesh> objects = {truth::box({-5, -1, -5}, {5, 0, 5}),
                                        truth::box({-5, 4, -5}, {5, 5, 5}),
                                        truth::box({-5, 0, -5}, {-4, 4, 5}),
                                        truth::box({4, 0, -5}, {5, 4, 2}),
                                        truth::box({-4, 0, -5}, {4, 4, -4}),
                                        truth::box({-4, 0, 4}, {1, 3, 5})};
    for (int i = shapes.number(2, 5); i > 0; --i) {
        const glm::vec3 low(shapes.number(-4, 2), 0, shapes.number(-4, 2));
        const int width = shapes.number(1, 2), height = shapes.number(1, 4);
        objects.push_back(truth::box(low, low + glm::vec3(width, height, shapes.number(1, 2))));
    }
    return truth::scene_of(std::move(objects));
}

TEST(LatticeHouse, SeenFromInsideAlongItsWallsThereIsNoTie) {
    std::mt19937_64 random(54);
    LatticeShapes shapes(random);
    for (int i = 0; i < 24; ++i) {
        SCOPED_TRACE(i);
        Setting setting{house(shapes), shapes.place(-4, 4), {}};
        setting.eye.y = shapes.number(1, 3);
        glm::dvec3 way(0);
        way[i % 2 == 0 ? 0 : 2] = i % 4 < 2 ? 1 : -1;
        if (i % 3 == 0) way = glm::dvec3(shapes.place(-1, 1)) + 2.0 * way;
        setting.target = setting.eye + way;
        const truth::Model model = truth::build_model(setting.scene, {.threads = 1});
        for (const auto kind :
             {scene::ProjectionKind::perspective, scene::ProjectionKind::parallel}) {
            setting.projection = kind;
            SCOPED_TRACE(scene::kProjectionNames[static_cast<std::size_t>(kind)]);
            const truth::Truth truth =
                truth::trace_truth(model, setting.view(), {.threads = 1, .layers = false});
            expect_agreement(model, setting.view(), truth, kind == scene::ProjectionKind::parallel);
        }
    }
}

class LatticeOfSolids : public testing::TestWithParam<scene::ProjectionKind> {
  protected:
    void expect_no_tie(unsigned seed, int scenes) {
        std::mt19937_64 random(seed);
        LatticeShapes shapes(random);
        const auto next = [&] { return touching_solids(shapes); };
        EXPECT_GT(crosscheck::expect_no_tie(scenes, GetParam(), shapes, next), scenes * 9 / 10);
    }
};

TEST_P(LatticeOfSolids, AgreeInAFewScenes) {
    expect_no_tie(51, 30);
}

TEST_P(LatticeOfSolids, AgreeInFourHundred) {
    expect_no_tie(52, 400);
}

INSTANTIATE_TEST_SUITE_P(Truth,
                         LatticeOfSolids,
                         testing::Values(scene::ProjectionKind::perspective,
                                         scene::ProjectionKind::parallel),
                         [](const auto& test) {
                             return std::string(
                                 scene::kProjectionNames[static_cast<std::size_t>(test.param)]);
                         });

TEST_P(LatticeLaw, TurnedAndRoundedAnewTheLinesAreTheSame) {
    std::mt19937_64 random(32);
    LatticeShapes shapes(random);
    std::uniform_real_distribution<double> aside(-0.45, 0.45);
    std::normal_distribution<double> normal;
    for (int i = 0; i < kScenes; ++i) {
        SCOPED_TRACE(i);
        const double x = aside(random), y = aside(random), z = aside(random);
        // From within a unit of a corner of a box round the scene: in no plane of it.
        Setting setting{any_scene(shapes, GetParam()),
                        glm::dvec3(shapes.place(0, 1)) * 18.0 - 9.0 + glm::dvec3(x, y, z),
                        glm::dvec3(shapes.place(-1, 1)) + glm::dvec3(z, x, y)};
        auto expected =
            truth::lengths(truth::trace_truth(setting.scene, setting.view(), {.threads = 1}));
        const double a = normal(random), b = normal(random), c = normal(random);
        const glm::dmat3 turn = glm::mat3_cast(glm::normalize(glm::dquat(normal(random), a, b, c)));
        for (scene::Mesh& mesh : setting.scene.meshes) {
            for (glm::vec3& p : mesh.positions)
                p = glm::vec3(turn * glm::dvec3(p));
        }
        setting.eye = turn * setting.eye;
        setting.target = turn * setting.target;
        setting.up = turn * setting.up;
        const truth::Model model = truth::build_model(setting.scene, {.threads = 1});
        const truth::Truth truth =
            truth::trace_truth(model, setting.view(), {.threads = 1, .layers = false});
        auto found = truth::lengths(truth);
        for (const truth::LineClass line_class : truth::kLineClasses) {
            const double length = expected[line_class];
            EXPECT_NEAR(found[line_class], length, 0.3 + 1e-3 * length) << truth::name(line_class);
        }
        expect_agreement(model, setting.view(), truth);
    }
}

INSTANTIATE_TEST_SUITE_P(Truth,
                         LatticeLaw,
                         testing::Values(Parts::solids, Parts::soups),
                         [](const auto& test) {
                             return test.param == Parts::solids ? "solids" : "soups";
                         });

}  // namespace
}  // namespace ink::crosscheck
