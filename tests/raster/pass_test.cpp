#include "raster/pass/pass.h"

#include <gtest/gtest.h>

#include "tests/raster/gather_sink.h"

namespace ink::raster {
namespace {

void add_square(TestMesh& mesh, double w) {
    mesh.add_triangle({-1, -1, w}, {40, -1, w}, {-1, 40, w});
}

TEST(DrawPass, TheNearestWinsInAnyOrder) {
    TestMesh mesh;
    for (const double w : {5.0, 2.0, 9.0})
        add_square(mesh, w);
    const auto drawn = draw_ids(mesh.input(), 16, 16);
    EXPECT_EQ(drawn.planes[0].at(8, 8), 1U);
    EXPECT_EQ(drawn.depth.at(8, 8), 0.5F);
}

TEST(DrawPass, TheFirstSubmittedWinsATie) {
    TestMesh mesh;
    for (int i = 0; i < 3; ++i)
        add_square(mesh, 4);
    EXPECT_EQ(draw_ids(mesh.input(), 16, 16).planes[0].at(8, 8), 0U);
}

TEST(DrawPass, ATieIsATieOfTheDepthFormat) {
    // One step of z16 near w = 50 is 0.076: 50 and 50.02 share one.
    TestMesh mesh;
    add_square(mesh, 50.02);
    add_square(mesh, 50);
    const std::vector<std::uint32_t> ids{0, 1};
    PassInput input = mesh.input();
    input.constants = ids;
    PassFormat format = id_format();
    EXPECT_EQ(gathered<std::uint32_t>(format, input, 8, 8).planes[0].at(3, 3), 1U);
    format.depth = DepthFormat::z16;
    const auto coarse = gathered<std::uint32_t, std::uint32_t>(format, input, 8, 8);
    EXPECT_EQ(coarse.planes[0].at(3, 3), 0U);
}

TEST(DrawPass, NothingIsClippedAtFar) {
    TestMesh mesh;
    add_square(mesh, 1e6);
    for (const DepthFormat depth : {DepthFormat::q32, DepthFormat::z24, DepthFormat::z16}) {
        PassFormat format;
        format.depth = depth;
        EXPECT_GT((gathered<float, std::uint32_t>(format, mesh.input(), 16, 16).depth.at(8, 8)),
                  0U);
    }
}

TEST(PassFormat, BytesPerPixelAreDepthPlusPlanes) {
    PassFormat format;
    EXPECT_EQ(format.bytes_per_px(), 4);
    format.interpolants = 1;
    format.store = Store::u8;
    EXPECT_EQ(format.bytes_per_px(), 5);
    format.depth = DepthFormat::z16;
    EXPECT_EQ(format.bytes_per_px(), 3);
    format.interpolants = 4;
    format.store = Store::f32;
    format.depth = DepthFormat::z24;
    EXPECT_EQ(format.bytes_per_px(), 19);
    EXPECT_EQ(id_format().bytes_per_px(), 8);
}

}  // namespace
}  // namespace ink::raster
