// Codes that are repaired by views hold what codes hold, and are wrong at fewer pixels of a model
// that moves.

#include "methods/surface_codes/code_repair.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <memory>
#include <numeric>

#include "catalogue/catalogue.h"
#include "catalogue/shapes.h"
#include "edge/bit_mask.h"
#include "methods/surface_codes/baked_codes.h"
#include "methods/surface_codes/code_method.h"
#include "scene/animation.h"
#include "tests/methods/small_scenes.h"
#include "tests/methods/two_px.h"
#include "truth/truth.h"

namespace ink::methods {
namespace {

constexpr int kPoses = 3;

/// A tube that bends by so much.
scene::Mesh bent_tube(double angle_rad) {
    std::vector<catalogue::TubeNode> path;
    for (int i = 0; i <= 24; ++i) {
        const double s = i / 24.0, turned = angle_rad * s;
        const double away = angle_rad > 0 ? (1 - std::cos(turned)) / angle_rad : 0;
        const double along = angle_rad > 0 ? std::sin(turned) / angle_rad : s;
        path.push_back({{6 * away, 6 * along, 0}, 0.5});
    }
    return catalogue::make_tube(path, 16);
}

/// One that is straight at rest and rolls up.
scene::Scene rolling_tube() {
    scene::Scene scene = scene::scene_of(bent_tube(0));
    scene::Animation animation;
    animation.duration_s = kPoses - 1;
    animation.frames_per_s = 1;
    animation.node_of_instance = {scene::kNoNode};
    animation.vertex_frames.resize(1);
    scene::VertexFrames& frames = animation.vertex_frames[0];
    frames.frame_count = kPoses;
    for (int pose = 0; pose < kPoses; ++pose) {
        const auto places = bent_tube(2.2 * pose).positions;
        frames.positions.insert(frames.positions.end(), places.begin(), places.end());
    }
    scene.animation = std::make_shared<const scene::Animation>(std::move(animation));
    return scene;
}

SurfaceCodes prepared_codes(const scene::PreparedScene& scene) {
    const SurfaceCodeParams params;
    SurfaceCodes codes(code_options(params, surface_setup(params)));
    codes.prepare(scene);
    return codes;
}

/// Squares of all poses of the tube.
SeenSquares squares_of_tube(const SurfaceCodes& codes,
                            const scene::Scene& tube,
                            int views,
                            std::uint32_t seed) {
    return seen_squares(codes, 40, {kPoses, views, seed}, [&](const auto& visit) {
        for (int pose = 0; pose < kPoses; ++pose) {
            scene::Scene posed = tube;
            scene::pose_scene(posed, pose);
            visit(posed);
        }
    });
}

/// The weight of the squares in which codes are wrong about the line.
double wrong_weight(const SeenSquares& squares,
                    const CodeRange& range,
                    const std::vector<std::int32_t>& heights) {
    const Fold fold(range.count());
    double wrong = 0;
    for (std::size_t i = 0; i < squares.list.size(); ++i) {
        const SeenSquare& square = squares.list[i];
        bool is_drawn = false;
        for (std::uint32_t side = 0; side < square.pairs; ++side) {
            const auto& [a, b] = square.sides.at(side);
            is_drawn |= std::abs(fold.code(heights[a]) - fold.code(heights[b])) >= 2;
        }
        if (is_drawn != (square.is_line != 0)) wrong += double{squares.weights[i]};
    }
    return wrong;
}

/// The most steps between faces that go smoothly over into each other.
double most_steps(const SmoothMesh& mesh, const std::vector<std::int32_t>& heights) {
    std::int32_t most = 0;
    for (std::uint32_t corner = 0; corner < mesh.across.size(); ++corner)
        if (mesh.across[corner] != SmoothMesh::kNone)
            most = std::max(most, std::abs(heights[corner / 3] - heights[mesh.across[corner]]));
    return static_cast<double>(most) / kStep;
}

TEST(SeenSquares, ABoxHasLinesAtItsEdgesAlone) {
    const scene::Scene scene = scene::scene_of(catalogue::make_box({0, 0, 0}, {1, 1, 1}));
    const SurfaceCodes codes = prepared_codes(scene);
    const SeenSquares squares =
        seen_squares(codes, 40, {1, 8}, [&](const auto& visit) { visit(scene); });
    ASSERT_FALSE(squares.list.empty());
    ASSERT_EQ(squares.weights.size(), squares.list.size());
    for (const SeenSquare& square : squares.list) {
        EXPECT_EQ(square.is_line, 1U);
        for (std::uint32_t side = 0; side < square.pairs; ++side)
            EXPECT_NE(codes.mesh().patch_of[square.sides.at(side)[0]],
                      codes.mesh().patch_of[square.sides.at(side)[1]]);
    }
}

TEST(CodeRepair, HalvesWhatIsWrongOfATubeThatRollsUpAndKeepsNeighboursClose) {
    const scene::Scene tube = rolling_tube();
    const scene::PreparedScene rest(tube);
    SurfaceCodes codes = prepared_codes(rest);
    const auto heights = codes.heights(codes.object_lengths(2));
    const SeenSquares learnt = squares_of_tube(codes, tube, 16, 7);
    const auto repaired = repaired_heights(codes.mesh(), codes.range(), learnt, heights, 4000);
    const double all = std::accumulate(learnt.weights.begin(), learnt.weights.end(), 0.0);
    const double before = wrong_weight(learnt, codes.range(), heights);
    EXPECT_GT(before, 0.02 * all);
    EXPECT_LT(wrong_weight(learnt, codes.range(), repaired), before / 2);
    const SeenSquares others = squares_of_tube(codes, tube, 4, 8);
    EXPECT_LT(wrong_weight(others, codes.range(), repaired),
              0.7 * wrong_weight(others, codes.range(), heights));
    EXPECT_LE(most_steps(codes.mesh(), heights), 1);
    EXPECT_LE(most_steps(codes.mesh(), repaired), 1);
    EXPECT_EQ(repaired_heights(codes.mesh(), codes.range(), learnt, heights, 4000), repaired);
    EXPECT_EQ(repaired_heights(codes.mesh(), codes.range(), learnt, heights, 0), heights);
}

TEST(CodeRepair, HeightsAreTheCodesBeforeTheyAreFolded) {
    for (const char* name : {"teapot", "gear", "tiles"}) {
        const scene::Scene scene = catalogue::make_catalogue_scene(name);
        const scene::PreparedScene prepared(scene);
        SurfaceCodes codes = prepared_codes(prepared);
        const auto heights = codes.heights(codes.object_lengths(2));
        EXPECT_LE(most_steps(codes.mesh(), heights), 1) << name;
        EXPECT_EQ(codes.codes_of(heights), baked_codes(prepared, BakedMethod::surface8, 40))
            << name;
    }
}

TEST(CodeRepair, CodesOfAModelAtRestStayCodes) {
    const scene::Scene scene = catalogue::make_catalogue_scene("teapot");
    const scene::PreparedScene prepared(scene);
    const auto repaired = repaired_codes(prepared, 40, {});
    EXPECT_NE(repaired, baked_codes(prepared, BakedMethod::surface8, 40));
    EXPECT_GE(*std::ranges::min_element(repaired), 2U);
    EXPECT_LE(*std::ranges::max_element(repaired), 255U);
    const SurfaceCodes codes = prepared_codes(prepared);
    const SmoothMesh& mesh = codes.mesh();
    const auto code_of = [&](std::uint32_t face) {
        return static_cast<int>(repaired[mesh.topology.faces[face].triangle]);
    };
    for (std::uint32_t corner = 0; corner < mesh.across.size(); ++corner)
        if (mesh.across[corner] != SmoothMesh::kNone) {
            EXPECT_LE(std::abs(code_of(corner / 3) - code_of(mesh.across[corner])), 1);
        }
}

TEST(CodeRepair, DrawsAHandBetterInViewsThatItDidNotLearnFrom) {
    const scene::Scene scene = catalogue::make_catalogue_scene("hand");
    const scene::Sphere bounds = scene::bounding_sphere(scene);
    const auto plain = posed_method(find_method("surface8"), {}, scene);
    const auto repaired = posed_method(find_method("surface8"), {{"repaired", "true"}}, scene);
    double gain = 0;
    for (const glm::dvec3& way : {glm::dvec3{2, 1, 2}, {-2.5, 0.3, 1}, {0, 2, -2}}) {
        const scene::View view = view_from(
            scene, bounds.center_world + bounds.radius * way, bounds.center_world, {960, 540});
        const auto truth = truth::trace_truth(scene, view, {});
        const auto f = [&](method::Method& method) {
            return f_within_two_px(edge::threshold(image_by(method, {view, 1}), 128), truth.labels);
        };
        gain += (f(*repaired) - f(*plain)) / 3;
    }
    EXPECT_GT(gain, 0.004);
}

TEST(Fold, GoesUpAndDownAndHasHeightsBelowZero) {
    const Fold fold(4);
    std::vector<int> codes;
    for (int step = -4; step <= 7; ++step)
        codes.push_back(fold.code(step * kStep));
    EXPECT_EQ(codes, (std::vector<int>{2, 3, 2, 1, 0, 1, 2, 3, 2, 1, 0, 1}));
    for (int height = -10 * kStep; height < 10 * kStep; height += 100)
        EXPECT_LE(std::abs(fold.code(height) - fold.code(height + kStep)), 1) << height;
}

}  // namespace
}  // namespace ink::methods
