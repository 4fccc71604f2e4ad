#include "methods/surface_codes/patch_labels.h"

#include <gtest/gtest.h>

#include <numbers>

#include "catalogue/catalogue.h"

namespace ink::methods {
namespace {

SmoothMesh mesh_of(const std::string& scene) {
    return *make_smooth_mesh(catalogue::make_catalogue_scene(scene),
                             {.crease_rad = 40 * std::numbers::pi / 180, .weld_epsilon = 1e-4});
}

TEST(SeenDifference, IsTheLeastThatAStencilMaySee) {
    EXPECT_EQ(seen_difference(10, 10, 8), 0);
    EXPECT_EQ(seen_difference(10, 15, 8), 5);
    EXPECT_EQ(seen_difference(250, 3, 8), 9) << "the short way round";
    EXPECT_EQ(seen_difference(0, 128, 8), 0) << "twice 128 is a whole turn";
    EXPECT_EQ(seen_difference(0, 85, 8), 1) << "three times 85 is nearly one";
    EXPECT_EQ(seen_difference(0, 32768, 16), 0);
    EXPECT_EQ(seen_difference(7, 60, 8), seen_difference(60, 7, 8));
}

class PatchLabels : public testing::TestWithParam<std::string> {};

TEST_P(PatchLabels, DifferEnoughAcrossEveryBorderThatHasRoom) {
    const SmoothMesh mesh = mesh_of(GetParam());
    for (const int bits : {8, 16}) {
        const std::vector<std::uint32_t> labels =
            patch_labels(mesh, {.bits = bits, .least_difference = 7});
        std::size_t near = 0, parted = 0;
        for (const FacePair& pair : mesh.borders) {
            if (mesh.patch_of[pair.face0] == mesh.patch_of[pair.face1]) continue;
            ++parted;
            near += seen_difference(labels[pair.face0], labels[pair.face1], bits) < 7;
        }
        EXPECT_GT(parted, 0U);
        EXPECT_EQ(near, 0U) << bits << " bits, of " << parted;
    }
}

TEST_P(PatchLabels, AreOneForAPatchAndFitTheirBits) {
    const SmoothMesh mesh = mesh_of(GetParam());
    const std::vector<std::uint32_t> labels = patch_labels(mesh, {.bits = 8});
    std::vector<std::uint32_t> of_patch(mesh.patch_count, 256);
    ASSERT_EQ(labels.size(), mesh.face_count());
    for (std::size_t f = 0; f < labels.size(); ++f) {
        EXPECT_LT(labels[f], 256U);
        std::uint32_t& known = of_patch[mesh.patch_of[f]];
        if (known == 256) known = labels[f];
        EXPECT_EQ(labels[f], known);
    }
}

INSTANTIATE_TEST_SUITE_P(Scenes,
                         PatchLabels,
                         testing::Values("cube", "gem", "gear", "chess", "crystals", "letters"));

}  // namespace
}  // namespace ink::methods
