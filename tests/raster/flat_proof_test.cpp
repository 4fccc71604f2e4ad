#include "raster/pass/flat_proof.h"

#include <gtest/gtest.h>

#include <cstdlib>
#include <random>

#include "raster/pass/drawn_rows.h"
#include "raster/pass/tile_fill.h"

namespace ink::raster {
namespace {

constexpr int kSize_px = 180;  // tiles of 64, 64 and 52 px
constexpr TileGrid kGrid{kSize_px, kSize_px, 1};

/// Triangles in pixels, w and one value a corner.
struct Input {
    std::vector<glm::dvec3> p_clip;
    std::vector<scene::Triangle> triangles;
    std::vector<float> values;

    void add(const glm::dvec3& corner, double value) {
        p_clip.emplace_back(corner.x * corner.z, corner.y * corner.z, corner.z);
        values.push_back(static_cast<float>(value));
        const auto count = static_cast<std::uint32_t>(p_clip.size());
        if (count % 3 == 0) triangles.push_back({count - 3, count - 2, count - 1});
    }
    [[nodiscard]] PassInput pass() const {
        PassInput input;
        input.p_clip = p_clip;
        input.triangles = triangles;
        input.values = values;
        input.near = 0.5;
        input.far = 20;
        return input;
    }
};

PassFormat one_code() {
    PassFormat format;
    format.store = Store::u8;
    format.interpolants = 1;
    format.halo_px = 1;
    return format;
}

/// The stencils that a proof about one tile finds needed; none: it does not pay.
struct Found {
    bool pays = false;
    NeededRows needed;
    Tile tile;  ///< drawn by the plain loop, all of it
};

class Bench {
  public:
    explicit Bench(const Input& scene)
        : input_(scene.pass()), batches_(1), buffer_(format_, input_, kGrid) {
        set_up_more(format_, input_, {0, 0, kSize_px, kSize_px}, batches_.front());
    }
    Found find(int tile) {
        FlatProof proof(format_);
        proof.start();
        buffer_.start(tile);
        buffer_.touch();
        const FillJob job{format_, input_, batches_};
        for (std::uint32_t i = 0; i < batches_.front().triangles.size(); ++i) {
            proof.add(batches_.front(), i);
            const BinEntry entry{0, i};
            fill_function(format_)(job, {&entry, 1}, buffer_);
        }
        Found found;
        found.pays = proof.find_needed(buffer_, 1, found.needed);
        buffer_.finish();
        buffer_.extend_frame();
        found.tile = buffer_.view(false);
        return found;
    }

  private:
    PassFormat format_ = one_code();
    PassInput input_;
    std::vector<Batch> batches_;
    TileBuffer buffer_;
};

int laplacian(const Tile& tile, int x, int y) {
    const auto at = [&](int u, int v) { return int{tile.row<std::uint8_t>(0, v)[u]}; };
    return 4 * at(x, y) - at(x - 1, y) - at(x + 1, y) - at(x, y - 1) - at(x, y + 1);
}

TEST(FlatProof, LeavesOutOnlyStencilsOfALaplacianOfAtMostTwo) {
    std::mt19937 random(4);
    const auto number = [&](double low, double high) {
        return std::uniform_real_distribution<double>(low, high)(random);
    };
    int spared_px = 0;
    int paying = 0;
    for (int round = 0; round < 300; ++round) {
        Input scene;
        for (int corner = 0; corner < 3 * (1 + round % 3); ++corner) {
            const double reach = round % 5 == 0 ? 2000 : 300;
            // Codes beyond the store here and there.
            scene.add({number(-reach, reach), number(-reach, reach), number(1, 9)},
                      number(-20, 290));
        }
        Bench bench(scene);
        for (int tile = 0; tile < kGrid.count(); ++tile) {
            const Found found = bench.find(tile);
            if (!found.pays) continue;
            ++paying;
            for (int y = 0; y < found.tile.height_px; ++y) {
                for (int x = 0; x < found.tile.width_px; ++x) {
                    const RowRun& run = found.needed.of[static_cast<std::size_t>(x / 16)];
                    if (y >= run.begin && y < run.end) continue;
                    ++spared_px;
                    ASSERT_LE(std::abs(laplacian(found.tile, x, y)), 2)
                        << "round " << round << " tile " << tile << " at " << x << ' ' << y;
                }
            }
        }
    }
    EXPECT_GT(paying, 500);
    EXPECT_GT(spared_px, 1'000'000);
}

/// Two walls that meet along a level line.
Input walls(double y_px) {
    Input scene;
    scene.add({-900, y_px, 2}, 100);
    scene.add({1100, y_px, 2}, 100);
    scene.add({100, -900, 2}, 100);
    scene.add({-900, y_px, 2}, 100);
    scene.add({1100, y_px, 2}, 100);
    scene.add({100, 1100, 2}, 200);
    return scene;
}

TEST(FlatProof, NeedsTheRowsBesideALineOnly) {
    const Input scene = walls(100.2);  // between the centres of rows 99 and 100: 35, 36 of the tile
    const Found found = Bench(scene).find(4);
    ASSERT_TRUE(found.pays);
    for (const RowRun& run : found.needed.of) {
        EXPECT_EQ(run.begin, 35);
        EXPECT_EQ(run.end, 37);
    }
    EXPECT_EQ(found.needed.hull().begin, 35);
    EXPECT_EQ(found.needed.hull().end, 37);
}

TEST(FlatProof, NeedsAllColumnsThatReachBeyondTheImage) {
    const Input scene = walls(100.2);
    const Found left = Bench(scene).find(3);
    ASSERT_TRUE(left.pays);
    EXPECT_EQ(left.needed.of[0].count(), 64);
    EXPECT_EQ(left.needed.of[1].count(), 2);
    const Found right = Bench(scene).find(5);  // 52 px wide: its last column is cut
    ASSERT_TRUE(right.pays);
    EXPECT_EQ(right.needed.of[2].count(), 2);
    EXPECT_EQ(right.needed.of[3].count(), 64);
}

TEST(FlatProof, LeavesOutTheSky) {
    Input scene;
    scene.add({-900, 100.2, 2}, 100);
    scene.add({1100, 100.2, 2}, 100);
    scene.add({100, 1100, 2}, 200);
    const Found found = Bench(scene).find(4);
    ASSERT_TRUE(found.pays);
    EXPECT_EQ(found.needed.hull().begin, 35);
    EXPECT_EQ(found.needed.hull().end, 37);
}

TEST(FlatProof, LooksBehindNothing) {
    Input scene;  // one wall before another, both over the whole image
    for (const double w : {3.0, 2.0}) {
        scene.add({-900, -900, w}, 100);
        scene.add({2900, -900, w}, 100);
        scene.add({-900, 2900, w}, 150);
    }
    const Found found = Bench(scene).find(4);
    ASSERT_TRUE(found.pays);
    EXPECT_TRUE(found.needed.hull().is_empty());
}

TEST(FlatProof, DoesNotPayWhereALineRunsDownEveryColumn) {
    Input scene;
    for (const double x : {70.0, 90.0, 110.0}) {  // slivers from top to bottom
        scene.add({x, -900, 2}, 100);
        scene.add({x + 12, -900, 2}, 100);
        scene.add({x + 6, 1100, 2}, 200);
    }
    EXPECT_FALSE(Bench(scene).find(4).pays);
}

TEST(DrawnRows, AreThoseThatNeededStencilsRead) {
    PassInput input;
    const PassFormat format = one_code();
    TileBuffer buffer(format, input, kGrid);
    buffer.start(4);
    NeededRows needed;
    needed.of = {{{10, 20}, {}, {}, {30, 64}}};
    const DrawnRows rows = DrawnRows::under(needed, buffer, 1);
    const int y0 = 64;
    const std::array<RowRun, 5> expected = {
        {{y0 + 9, y0 + 21}, {y0 + 9, y0 + 21}, {}, {y0 + 29, y0 + 65}, {y0 + 29, y0 + 65}}};
    for (std::size_t i = 0; i < expected.size(); ++i) {
        EXPECT_EQ(rows.of[i].begin, expected[i].begin) << i;
        EXPECT_EQ(rows.of[i].end, expected[i].end) << i;
    }
    const PixelRect hull = rows.hull(buffer);
    EXPECT_EQ(hull.x0, 63);
    EXPECT_EQ(hull.x1, 129);
    EXPECT_EQ(hull.y0, y0 + 9);
    EXPECT_EQ(hull.y1, y0 + 65);
}

}  // namespace
}  // namespace ink::raster
