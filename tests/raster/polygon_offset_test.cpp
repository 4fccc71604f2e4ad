#include "raster/depth/polygon_offset.h"

#include <gtest/gtest.h>

#include <cmath>

#include "raster/depth/depth_image.h"
#include "raster/mesh/mesh_pass.h"

namespace ink::raster {
namespace {

constexpr int kSize_px = 96;
constexpr double kNear = 2;
constexpr double kFar = 10;

/// A plane all over the image: q = 0.2 + gx (x - 48) + gy (y - 48) in px from the top left.
struct Plane48 {
    double gx;
    double gy;
    [[nodiscard]] double q(double x_px, double y_px) const {
        return 0.2 + gx * (x_px - 48) + gy * (y_px - 48);
    }
};

scene::View test_view() {
    scene::View view;
    view.camera.eye_world = {0, 0, 0};
    view.camera.near = kNear;
    view.camera.far = kFar;
    view.width_px = view.height_px = kSize_px;
    return view;
}

/// Squares of two triangles each, which cover the image and reach beyond it.
struct Squares {
    int margin_px;  ///< beyond it
    int count;      ///< each way
};
constexpr Squares kLarge = {16, 1};  ///< drawn one by one
constexpr Squares kMedium = {2, 1};  ///< in vector lanes, as all below
constexpr Squares kSmall = {2, 10};

scene::Surface make_plane(const Plane48& plane, const Squares& squares) {
    const scene::Projection projection(test_view());
    scene::Surface surface;
    const int side_px = (kSize_px + 2 * squares.margin_px) / squares.count;
    const auto corners = static_cast<std::uint32_t>(squares.count + 1);
    for (int row = 0; row <= squares.count; ++row) {
        for (int column = 0; column <= squares.count; ++column) {
            const int x = column * side_px - squares.margin_px;
            const int y = row * side_px - squares.margin_px;
            surface.p_world.push_back(projection.ray_world(x, y) / plane.q(x, y));
        }
    }
    for (std::uint32_t row = 0; row + 1 < corners; ++row) {
        for (std::uint32_t column = 0; column + 1 < corners; ++column) {
            const std::uint32_t a = row * corners + column;
            surface.triangles.push_back({a, a + corners + 1, a + 1});
            surface.triangles.push_back({a, a + corners, a + corners + 1});
        }
    }
    surface.object.assign(surface.triangles.size(), 0);
    return surface;
}

DepthImage draw_plane(const Plane48& plane,
                      const Squares& squares,
                      DepthFormat depth,
                      const PolygonOffset& offset) {
    const scene::Surface surface = make_plane(plane, squares);
    const LaneMesh mesh(surface);
    PassFormat format;
    format.depth = depth;
    MeshInput input;
    input.mesh = &mesh;
    input.view = test_view();
    input.offset = offset;
    DepthImage image;
    image.start(depth, kNear, kFar, kSize_px, kSize_px);
    DepthSink sink(image);
    MeshPass pass;
    (void)pass.draw(format, input, sink);
    return image;
}

const std::vector<Plane48> kPlanes = {{0, 0}, {0.0004, -0.0001}, {-0.0002, 0.0005}};
const std::vector<PolygonOffset> kOffsets = {{0, 0}, {-1.5, -1}, {0, -7}, {2, 3}, {-4, 0}};

/// Window depth grows away from the eye from 0 at near to 1 at far, and is stored as whole steps
/// counted from far: so many for plane and offset, at every pixel, but for rounding: half a step,
/// and `lanes` more as vector lanes interpolate the corners' steps as floats.
void expect_steps(DepthFormat format, double most, const Squares& squares, double lanes) {
    const double per_q = 1 / (1 / kNear - 1 / kFar);
    for (const Plane48& plane : kPlanes) {
        const double slope = per_q * std::max(std::abs(plane.gx), std::abs(plane.gy));
        for (const PolygonOffset& offset : kOffsets) {
            const DepthImage image = draw_plane(plane, squares, format, offset);
            for (int y = 0; y < kSize_px; y += 5) {
                for (int x = 0; x < kSize_px; x += 5) {
                    const double z = (1 / kNear - plane.q(x + 0.5, y + 0.5)) * per_q +
                                     offset.factor * slope + offset.units / most;
                    EXPECT_NEAR(image.bits().at(x, y), most * (1 - z), 0.51 + lanes)
                        << offset.factor << ' ' << offset.units << " at " << x << ' ' << y;
                }
            }
        }
    }
}

TEST(PolygonOffset, MovesAPlaneByFactorAndUnitsInZ24) {
    expect_steps(DepthFormat::z24, 16777215, kLarge, 0);
    expect_steps(DepthFormat::z24, 16777215, kMedium, 1);
    // A corner is off by half a step: a slope over 10 px, that counts four times, by 0.4.
    expect_steps(DepthFormat::z24, 16777215, kSmall, 1.4);
}

TEST(PolygonOffset, MovesAPlaneByFactorAndUnitsInZ16) {
    expect_steps(DepthFormat::z16, 65535, kLarge, 0);
    expect_steps(DepthFormat::z16, 65535, kMedium, 1);
    expect_steps(DepthFormat::z16, 65535, kSmall, 1);
}

/// q of these planes is between 0.125 and 0.25, where floats are 2^-26 apart. Lanes interpolate
/// floats, too.
TEST(PolygonOffset, MovesAPlaneByFactorAndUnitsInQ32) {
    for (const Plane48& plane : kPlanes) {
        const double slope = std::max(std::abs(plane.gx), std::abs(plane.gy));
        double q_most = 0;
        for (const double x : {-16, 112}) {
            for (const double y : {-16, 112})
                q_most = std::max(q_most, plane.q(x, y));
        }
        ASSERT_NEAR(q_most, 0.2, 0.049) << "both triangles have corners between 0.125 and 0.25";
        const double step = std::ldexp(1, -26);
        for (const PolygonOffset& offset : kOffsets) {
            for (const auto& [squares, lanes] :
                 {std::pair{kLarge, 0.0}, {kMedium, 1.5}, {kSmall, 1.5}}) {
                const DepthImage image = draw_plane(plane, squares, DepthFormat::q32, offset);
                for (int at = 0; at < kSize_px; at += 5) {
                    const double expected =
                        plane.q(at + 0.5, 40.5) - offset.factor * slope - offset.units * step;
                    EXPECT_NEAR(std::bit_cast<float>(image.bits().at(at, 40)),
                                expected,
                                (0.51 + lanes) * step)
                        << squares.count << " each way, factor " << offset.factor;
                }
            }
        }
    }
}

/// Beyond near and far nothing is stored but the formats' ends.
TEST(PolygonOffset, StopsAtTheEndsOfTheFormat) {
    const DepthImage near = draw_plane({0, 0}, kMedium, DepthFormat::z16, {0, -70000});
    const DepthImage far = draw_plane({0, 0}, kMedium, DepthFormat::z16, {0, 70000});
    EXPECT_EQ(near.bits().at(10, 10), 65535U);
    EXPECT_EQ(far.bits().at(10, 10), 1U) << "0 is sky";
}

}  // namespace
}  // namespace ink::raster
