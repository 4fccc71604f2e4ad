#include "tests/truth/shapes.h"

namespace ink::truth {
namespace {

scene::View crowd_view() {
    return view_from({3, 4, 9}, {0, 0.5, 0});
}

TEST(Law, MixedOrientationChangesNothing) {
    scene::Scene scene = crowd();
    const Truth straight = trace(scene, crowd_view());
    Noise noise(5);
    for (scene::Mesh& mesh : scene.meshes) {
        for (scene::Triangle& t : mesh.triangles) {
            if (noise.next() < 0.5) std::swap(t[1], t[2]);
        }
    }
    const Truth mixed = trace(scene, crowd_view());
    EXPECT_GT(drawn_px(straight), 1000U);
    EXPECT_EQ(straight.labels, mixed.labels);
    EXPECT_EQ(straight.sampled, mixed.sampled);
    EXPECT_EQ(straight.exact_corner, mixed.exact_corner);
    EXPECT_EQ(straight.layers.triangle, mixed.layers.triangle);
    EXPECT_EQ(lengths(straight), lengths(mixed));
}

TEST(Law, ThreadsChangeNothing) {
    const scene::Scene scene = crowd();
    const Truth one = trace(scene, crowd_view(), 1);
    const Truth two = trace(scene, crowd_view(), 2);
    expect_same_truth(one, two);
}

TEST(Law, DuplicatedFacesAreCountedAndChangeNothing) {
    scene::Scene scene = crowd();
    const Truth once = trace(scene, crowd_view());
    for (scene::Mesh& mesh : scene.meshes) {
        const scene::Triangle t = mesh.triangles.front();
        mesh.triangles.push_back({t[2], t[1], t[0]});
    }
    const Truth twice = trace(scene, crowd_view());
    EXPECT_EQ(twice.counts.duplicate, once.counts.duplicate + scene.meshes.size());
    EXPECT_EQ(once.labels, twice.labels);
}

TEST(Law, VerticesMayBeSplitByMaterial) {
    // One mesh with shared vertices against the same triangles, three vertices each, of two
    // materials.
    scene::Mesh shared;
    shared.positions = {{-1, -1, 0}, {1, -1, 0}, {1, 1, 0}, {-1, 1, 0}, {0, 0, 1}};
    shared.triangles = {{0, 1, 4}, {1, 2, 4}, {2, 3, 4}, {3, 0, 4}};
    scene::Mesh split = joined({shared});
    split.materials = {0, 1, 0, 1};
    const scene::View view = view_from({1, 2, 6}, {0, 0, 0});
    const Truth a = trace(scene_of({shared}), view);
    const Truth b = trace(scene_of({split}), view);
    EXPECT_GT(drawn_px(a), 300U);
    EXPECT_EQ(a.labels, b.labels);
    EXPECT_EQ(a.sampled, b.sampled);
    EXPECT_EQ(a.exact_corner, b.exact_corner);
}

TEST(Law, MirroredInstanceEqualsMirroredMesh) {
    scene::Scene by_instance = crowd();
    scene::Scene by_mesh = crowd();
    for (scene::Instance& instance : by_instance.instances)
        instance.world_from_object = glm::scale(glm::dmat4(1), glm::dvec3(-1, 1, 1));
    for (scene::Mesh& mesh : by_mesh.meshes) {
        for (glm::vec3& p : mesh.positions)
            p.x = -p.x;
    }
    const Truth a = trace(by_instance, crowd_view());
    const Truth b = trace(by_mesh, crowd_view());
    EXPECT_EQ(a.labels, b.labels);
    EXPECT_EQ(a.layers.triangle, b.layers.triangle);
}

TEST(Law, LayersShowWhatStandsThere) {
    const scene::Scene scene = scene_of({box({-1, -1, -1}, {1, 1, 1})});
    const Truth truth = trace(scene, view_from(4));
    // The front face: the box's first two triangles, one patch, 3 units away.
    const auto id = truth.layers.triangle.at(320, 240);
    EXPECT_LE(id, 1U);
    EXPECT_EQ(truth.layers.patch.at(200, 200), truth.layers.patch.at(440, 300));
    EXPECT_FLOAT_EQ(truth.layers.w.at(200, 200), 3);
    EXPECT_NEAR(truth.layers.n_dot_v.at(320, 240), 1, 1e-5);
    const double slope = std::hypot(120.5 / kFocal_px, 40.5 / kFocal_px);
    EXPECT_NEAR(truth.layers.n_dot_v.at(440, 280), 1 / std::sqrt(1 + slope * slope), 1e-6);
    EXPECT_EQ(truth.layers.triangle.at(5, 5), kNoTriangle);
    EXPECT_EQ(truth.layers.patch.at(5, 5), kNoTriangle);
    EXPECT_EQ(truth.layers.n_dot_v.at(5, 5), 0);
    EXPECT_TRUE(std::isinf(truth.layers.w.at(5, 5)));
}

TEST(Law, WithoutLayersTheLinesAreTheSame) {
    const scene::Scene scene = crowd();
    TruthOptions options;
    options.layers = false;
    const Truth bare = trace_truth(scene, crowd_view(), options);
    EXPECT_EQ(bare.labels, trace(scene, crowd_view()).labels);
    EXPECT_TRUE(bare.sampled.is_empty());
    EXPECT_TRUE(bare.exact_corner.is_empty());
    EXPECT_TRUE(bare.layers.triangle.is_empty());
}

TEST(Law, ViewOfNothingIsBlank) {
    const Truth truth = trace(crowd(), view_from({0, 2, 50}, {0, 2, 100}));
    EXPECT_EQ(truth.labels.width_px(), kWidth_px);
    EXPECT_EQ(drawn_px(truth), 0U);
    EXPECT_TRUE(truth.curves.empty());
    scene::View empty = crowd_view();
    empty.width_px = empty.height_px = 0;
    EXPECT_TRUE(trace(crowd(), empty).labels.is_empty());
}

TEST(Law, FarFromTheOriginNothingMoves) {
    // 2^20 is a power of two: positions and differences stay exact in float and double.
    const glm::vec3 shift{1048576, 0, 0};
    scene::Scene scene = scene_of({box({-1, -1, -1}, {1, 1, 1})});
    const Truth near_by = trace(scene, view_from({2, 3, 6}, {0, 0, 0}));
    for (glm::vec3& p : scene.meshes[0].positions)
        p += shift;
    const Truth far_off =
        trace(scene, view_from(glm::dvec3(2, 3, 6) + glm::dvec3(shift), glm::dvec3(shift)));
    EXPECT_EQ(near_by.labels, far_off.labels);
}

TEST(Sampled, AgreesWithTheLabels) {
    EXPECT_GT(sampled_f(trace(crowd(), crowd_view())), 0.97);
}

TEST(Sampled, HiddenFeaturesAreNotDrawn) {
    // A box half sunk into a floor: the rim of the floor is seen and the line round the box, the
    // box's bottom is not.
    const scene::Mesh floor = quad({-90, 0, 90}, {90, 0, 90}, {90, 0, -90}, {-90, 0, -90});
    const scene::Scene scene = scene_of({floor, box({-1, -0.5F, -1}, {1, 1, 1})});
    const scene::View view = view_from({2, 6, 8}, {0, 0, 0});
    const Truth truth = trace(scene, view);
    EXPECT_EQ(seen_length(scene, truth, {-1, -0.5F, 1}, {1, -0.5F, 1}), 0);
    // The middle of the hidden edge on the image and that of the line above it.
    const auto column_at = [&](const glm::dvec3& p, int reach) {
        const glm::dvec3 at = scene::Projection(view).to_clip(p);
        const int x = static_cast<int>(at.x / at.z), y = static_cast<int>(at.y / at.z);
        int drawn = 0;
        for (int dy = -reach; dy <= reach; ++dy)
            drawn += truth.sampled.at(x, y + dy) != 0;
        return drawn;
    };
    EXPECT_EQ(column_at({0, -0.5, 1}, 3), 0);
    EXPECT_GE(column_at({0, 0, 1}, 1), 1);
    EXPECT_GT(sampled_f(truth), 0.97);
}

TEST(Sampled, BarsThatNoSampleHitsAreMarkedWhereIdsDiffer) {
    // Two panels of one object in brick bond, which share no vertices along y = 0, and a bar of
    // .08 px over their border: the centres see the panels on both sides, a walk joins them, but
    // their ids differ.
    const float y = 0.2F / 100, half = 0.0004F;
    scene::Mesh mesh;
    add_quad(mesh, {-2, -1, 0}, {0.5F, -1, 0}, {0.5F, y, 0}, {-2, y, 0});
    add_quad(mesh, {0.5F, -1, 0}, {2, -1, 0}, {2, y, 0}, {0.5F, y, 0});
    add_quad(mesh, {-2, y, 0}, {0, y, 0}, {0, 1, 0}, {-2, 1, 0});
    add_quad(mesh, {0, y, 0}, {2, y, 0}, {2, 1, 0}, {0, 1, 0});
    const scene::Mesh bar = quad({-1.9F, y - half, 1e-3F},
                                 {1.9F, y - half, 1e-3F},
                                 {1.9F, y + half, 1e-3F},
                                 {-1.9F, y + half, 1e-3F});
    const Truth truth = trace(scene_of({mesh, bar}), view_from(6));
    // y = 0.2 px above the middle between rows 239 and 240.
    int drawn = 0;
    for (int column = 140; column < 500; ++column)
        drawn += truth.sampled.at(column, 239) != 0 || truth.sampled.at(column, 240) != 0;
    EXPECT_EQ(drawn, 360);
    EXPECT_GT(sampled_f(truth), 0.97);
}

TEST(Sampled, CracksNarrowerThanAnyViewShowsAreNotMarked) {
    // The same border with shared corners and a gap of 1e-7: ids weld it, and so does the truth.
    scene::Mesh mesh;
    add_quad(mesh, {-2, -1, 0}, {2, -1, 0}, {2, -1e-7F, 0}, {-2, -1e-7F, 0});
    add_quad(mesh, {-2, 0, 0}, {2, 0, 0}, {2, 1, 0}, {-2, 1, 0});
    const Truth truth = trace(scene_of({mesh}), view_from(6));
    for (int column = 140; column < 500; ++column) {
        ASSERT_EQ(truth.sampled.at(column, 239), 0) << column;
        ASSERT_EQ(truth.sampled.at(column, 240), 0) << column;
    }
}

}  // namespace
}  // namespace ink::truth
