#include "buffers/sample_grid.h"

#include <gtest/gtest.h>

#include "scene/camera.h"
#include "tests/methods/small_scenes.h"

namespace ink::buffers {
namespace {

scene::View some_view(int width_px, int height_px) {
    const scene::Scene scene = methods::cube_on_floor();
    return methods::view_from(scene, {3, 4, 5}, {0.3, 0.2, 0}, {width_px, height_px});
}

TEST(CornerView, PixelCentresAreThePixelCornersOfTheView) {
    const scene::View view = some_view(150, 101);
    const scene::View corners = scene::corner_view(view);
    EXPECT_EQ(corners.width_px, 151);
    EXPECT_EQ(corners.height_px, 102);
    const scene::Projection of_view(view);
    const scene::Projection of_corners(corners);
    EXPECT_NEAR(of_corners.focal_px(), of_view.focal_px(), 1e-12 * of_view.focal_px());
    for (int y = 0; y <= view.height_px; ++y) {
        for (int x = 0; x <= view.width_px; ++x) {
            const glm::dvec3 corner = of_view.ray_world(x, y);
            const glm::dvec3 centre = of_corners.ray_world(x + 0.5, y + 0.5);
            for (int i = 0; i < 3; ++i)
                ASSERT_NEAR(corner[i], centre[i], 1e-13) << x << ", " << y;
        }
    }
}

TEST(CornerView, AViewWithoutPixelsHasNoCorners) {
    const scene::View view = some_view(0, 101);
    EXPECT_EQ(scene::corner_view(view).width_px, 0);
    EXPECT_EQ(scene::corner_view(view).height_px, 101);
}

TEST(SampleGrid, TilesOfCornersEndWhereTheImageEnds) {
    // 128 columns of pixels are 129 of corners: the third column of tiles has no pixel.
    raster::Tile tile;
    tile.x0_px = 64;
    tile.y0_px = 64;
    tile.width_px = 64;
    tile.height_px = 38;
    tile.halo_px = 1;
    const raster::Tile inner = output_tile(tile, 128, 101);
    EXPECT_EQ(inner.width_px, 64);
    EXPECT_EQ(inner.height_px, 37);
    EXPECT_EQ(inner.halo_px, 1);
    tile.x0_px = 128;
    tile.width_px = 1;
    EXPECT_EQ(output_tile(tile, 128, 101).width_px, 0);
    EXPECT_EQ(output_tile(tile, 129, 102).width_px, 1) << "samples that are pixels stay";
}

}  // namespace
}  // namespace ink::buffers
