#include <gtest/gtest.h>

#include <limits>

#include "catalogue/catalogue.h"
#include "truth/eye_scene.h"
#include "truth/eye_view.h"
#include "truth/model.h"
#include "truth/truth.h"

namespace ink::truth {
namespace {

/// Sixteen rays at a time see what each of them sees alone, bit for bit, on every built-in scene.
TEST(Layers, PacketsSeeWhatSingleRaysSee) {
    // A frame whose sides four does not divide would leave rays out.
    constexpr int kWide_px = 161, kHigh_px = 91;
    std::size_t hits = 0;
    for (const catalogue::CatalogueEntry& entry : catalogue::catalogue()) {
        SCOPED_TRACE(entry.name);
        const scene::Scene scene = entry.make();
        const scene::View view{scene.cameras.front(), kWide_px, kHigh_px};
        const scene::Topology topology = scene::weld(scene);
        const scene::Projection projection(view);
        const EyeScene tree(topology, view.camera, 1);
        const auto sight_at = [&](double x_px, double y_px) {
            return scene::SightLine{projection.ray_begin_world(x_px, y_px),
                                    projection.ray_world(x_px, y_px)};
        };
        const double far = std::numeric_limits<double>::infinity();
        for (int y = 0; y < kHigh_px; y += 4) {
            for (int x = 0; x < kWide_px; x += 4) {
                std::array<scene::SightLine, 16> lines;
                for (int i = 0; i < 16; ++i)
                    lines[static_cast<std::size_t>(i)] = sight_at(x + i % 4 + 0.5, y + i / 4 + 0.5);
                const auto together =
                    tree.first_of_sixteen(lines, {view.camera.near, far}, 0x7fffU);
                EXPECT_FALSE(together[15].has_value()) << "it was not cast";
                for (std::size_t i = 0; i < 15; ++i) {
                    const auto alone = tree.first({lines[i], view.camera.near, far},
                                                  [](std::uint32_t) { return true; });
                    ASSERT_EQ(together[i].has_value(), alone.has_value());
                    if (!alone) continue;
                    ASSERT_EQ(together[i]->face, alone->face);
                    ++hits;
                }
            }
        }
    }
    EXPECT_GT(hits, 50000U);
}

}  // namespace
}  // namespace ink::truth
