// What the parameters of packed buffers do to an image, on walls whose codes are known.

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "tests/methods/small_scenes.h"

namespace ink::buffers {
namespace {

/// With facet normals the wall is one code: depth 1/2 of the camera's range, nx = ny = 1/2, nz = 1.
struct Wall : methods::Wall {
    Wall() {
        view.camera.near = 2;
        view.camera.far = 6;
    }

    /// The edge response of the pixels on either side of the wall's left border.
    [[nodiscard]] std::pair<int, int> border(const std::string& method,
                                             core::ParamValues values) const {
        values.emplace("normals", "facet");
        values.emplace("depth_range", "camera");
        values.emplace("depth_encoding", "linear");
        values.emplace("clip_bits", "0");
        const auto image = methods::drawn(method, values, scene, {view, 1});
        return {image.at(39, 80), image.at(40, 80)};
    }
};

using Both = std::pair<int, int>;

TEST(Overflow, AByteBeyondItsRangeSaturatesOrWrapsAsTold) {
    // 200 / 2 + 200 / 2 + 200 / 2 + 200 = 500: 255, or 500 - 256 = 244.
    const core::ParamValues wide = {
        {"range_depth", "200"}, {"range_nx", "200"}, {"range_ny", "200"}, {"range_nz", "200"}};
    const auto border = [&](const std::string& overflow, const std::string& packing, int sky) {
        core::ParamValues values = wide;
        values["overflow"] = overflow;
        values["packing"] = packing;
        values["sky"] = std::to_string(sky);
        return Wall().border("mote4", values);
    };
    for (const std::string packing : {"vertex", "pixel"}) {
        EXPECT_EQ(border("saturate", packing, 255), Both(0, 0)) << packing;
        EXPECT_EQ(border("saturate", packing, 244), Both(11, 11)) << packing;
        EXPECT_EQ(border("wrap", packing, 244), Both(0, 0)) << packing;
        EXPECT_EQ(border("wrap", packing, 255), Both(11, 11)) << packing;
        // Modulo 256, 250 and 4 are 10 apart: the short way round.
        EXPECT_EQ(border("wrap", packing, 254), Both(10, 10)) << packing;
    }
}

TEST(Overflow, SixteenBitsBeyondTheirRangeSaturateOrWrapAsTold) {
    // 60000 / 2 * 3 + 60000 = 150000: 65535, or 150000 - 2 * 65536 = 18928.
    const auto border = [](const std::string& overflow, const std::string& packing, int sky) {
        return Wall().border("mote16",
                             {{"range_depth", "60000"},
                              {"range_nx", "60000"},
                              {"range_ny", "60000"},
                              {"range_nz", "60000"},
                              {"overflow", overflow},
                              {"packing", packing},
                              {"scale_bits", "0"},
                              {"sky", std::to_string(sky)}});
    };
    for (const std::string packing : {"vertex", "pixel"}) {
        EXPECT_EQ(border("saturate", packing, 65535), Both(0, 0)) << packing;
        EXPECT_EQ(border("saturate", packing, 65500), Both(35, 35)) << packing;
        EXPECT_EQ(border("wrap", packing, 18928), Both(0, 0)) << packing;
        EXPECT_EQ(border("wrap", packing, 18900), Both(28, 28)) << packing;
    }
}

TEST(Response, IsBothSidesOneOrTheLiteralByte) {
    // 63 / 2 + 63 / 2 + 63 / 2 + 63 = 157.5, rounded up: 158 above a sky of 100.
    const auto border = [](const std::string& response) {
        return Wall().border("mote4", {{"sky", "100"}, {"response", response}});
    };
    EXPECT_EQ(border("absolute"), Both(58, 58));
    EXPECT_EQ(border("positive"), Both(0, 58));
    EXPECT_EQ(border("wrap"), Both(256 - 58, 58));
}

TEST(Fatten, BlursCodesByABinomialBeforeTheFilter) {
    // Across a step of 64 the blur 1 2 1 leaves 0 16 48 64: L is -16, -16, 16, 16.
    const auto border = [](const std::string& fatten) {
        return Wall().border("mote4",
                             {{"range_nx", "0"},
                              {"range_ny", "0"},
                              {"range_nz", "64"},
                              {"range_depth", "0"},
                              {"fatten", fatten}});
    };
    EXPECT_EQ(border("false"), Both(64, 64));
    EXPECT_EQ(border("true"), Both(16, 16));
}

TEST(Layout, EachFieldOfSixteenBitsIsFilteredByItself) {
    // Depth 1/2 and a normal sum of 1/2 + 1/2 + 1 thirds; scale_bits brings b bits to 16.
    const auto border = [](const std::string& layout) {
        return Wall().border("mote16",
                             {{"layout", layout}, {"packing", "pixel"}, {"scale_bits", "-8"}});
    };
    // 8 + 8: 128 of depth, 170 of the normal, as they are.
    EXPECT_EQ(border("8+8"), Both(170, 170));
    // 10 + 6: 512 over 4, 42 times 4.
    EXPECT_EQ(border("10+6"), Both(168, 168));
    // 4 x 4: 8, 8, 8 and 15, times 16.
    EXPECT_EQ(border("4x4"), Both(240, 240));
    // One sum of 16383: 40958 of 65535, over 256.
    EXPECT_EQ(border("sum"), Both(159, 159));
}

/// A wall beside one that is tilted back about the horizontal axis so that its nz is 1/2, and moved
/// so that in the middle row its depth makes up for that in the sum.
scene::Scene cancelling_walls() {
    scene::Mesh mesh;
    const double near_z = 1;  // distance 3: depth 3/4 of 2..6, against 1/2 at distance 4
    const double tilt_z = std::sqrt(3.0);
    for (const auto& [x0, x1, z, slope] :
         {std::tuple{-1.5, 0.0, 0.0, 0.0}, std::tuple{0.0, 1.5, near_z, tilt_z}}) {
        const auto first = static_cast<std::uint32_t>(mesh.positions.size());
        for (const auto& [x, y] : {std::pair{x0, -1.0}, {x1, -1.0}, {x1, 1.0}, {x0, 1.0}}) {
            mesh.positions.emplace_back(x, y * 0.2, z - slope * y * 0.2);
        }
        mesh.triangles.push_back({first, first + 1, first + 2});
        mesh.triangles.push_back({first, first + 2, first + 3});
    }
    return methods::scene_of({mesh});
}

TEST(Combine, SeparateSeesWhatCancelsInTheSum) {
    const scene::Scene scene = cancelling_walls();
    scene::View view = Wall().view;
    view.height_px = 161;  // row 80 looks straight ahead
    const auto edge_response = [&](const std::string& combine) {
        const auto image = methods::drawn("mote2",
                                          {{"combine", combine},
                                           {"normals", "facet"},
                                           {"packing", "pixel"},
                                           {"depth_range", "camera"},
                                           {"depth_encoding", "linear"}},
                                          scene,
                                          {view, 1});
        return static_cast<int>(std::max(image.at(79, 80), image.at(80, 80)));
    };
    // Depth 127 / 4 more, nz 127 / 4 less.
    EXPECT_LE(edge_response("sum"), 4);
    EXPECT_GE(edge_response("separate"), 28);
}

}  // namespace
}  // namespace ink::buffers
