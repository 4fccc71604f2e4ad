
#include <gtest/gtest.h>

#include <cstdlib>
#include <random>

#include "raster/pass/tile_fill.h"
#include "tests/raster/gather_sink.h"

namespace ink::raster {
namespace {

constexpr int kSize_px = 180;  // tiles of 64, 64 and 52 px
constexpr TileGrid kGrid{kSize_px, kSize_px, 1};

/// Triangles in pixels, w and one value a corner.
struct ValueMesh : TestMesh {
    void add_corner(const glm::dvec3& corner, double value) {
        const std::uint32_t last = add(corner.x, corner.y, corner.z);
        values.push_back(static_cast<float>(value));
        if (last % 3 == 2) triangles.push_back({last - 2, last - 1, last});
    }
};

PassFormat one_code() {
    return {.interpolants = 1, .store = Store::u8, .halo_px = 1};
}

/// What a proof says of one tile.
struct Found {
    bool is_flat = false;
    Tile tile;  ///< drawn by the plain loop, all of it
};

class Bench {
  public:
    explicit Bench(const ValueMesh& scene)
        : input_(scene.input()), batches_(1), buffer_(format_, input_, kGrid) {
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
            fill_tile(job, {&entry, 1}, buffer_);
        }
        Found found;
        found.is_flat = buffer_.is_inner() && proof.is_flat(buffer_.drawn());
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

TEST(FlatProof, HoldsOnlyWhereEveryLaplacianIsAtMostTwo) {
    std::mt19937 random(4);
    const auto number = [&](double low, double high) {
        return std::uniform_real_distribution<double>(low, high)(random);
    };
    int flat = 0;
    for (int round = 0; round < 600; ++round) {
        ValueMesh scene;
        for (int corner = 0; corner < 3 * (1 + round % 3); ++corner) {
            const double reach = round % 5 == 0 ? 300 : 4000;
            // Codes beyond the store here and there.
            scene.add_corner({number(-reach, reach), number(-reach, reach), number(1, 9)},
                             number(-20, 290));
        }
        Bench bench(scene);
        const Found found = bench.find(4);  // the one that the frame does not cut
        if (!found.is_flat) continue;
        ++flat;
        for (int y = 0; y < found.tile.height_px; ++y) {
            for (int x = 0; x < found.tile.width_px; ++x)
                ASSERT_LE(std::abs(laplacian(found.tile, x, y)), 2)
                    << round << ' ' << x << ' ' << y;
        }
    }
    EXPECT_GT(flat, 20);
}

/// A wall over the whole image.
void add_wall(ValueMesh& scene, double w) {
    scene.add_corner({-900, -900, w}, 100);
    scene.add_corner({2900, -900, w}, 100);
    scene.add_corner({-900, 2900, w}, 150);
}

TEST(FlatProof, LooksBehindNothing) {
    ValueMesh scene;
    add_wall(scene, 3);
    add_wall(scene, 2);
    EXPECT_TRUE(Bench(scene).find(4).is_flat);
    EXPECT_FALSE(Bench(scene).find(3).is_flat) << "beyond the frame, pixels are copies";
}

TEST(FlatProof, FailsWhereALineRunsThroughTheTile) {
    ValueMesh scene;
    scene.add_corner({-900, 100.2, 2}, 100);
    scene.add_corner({1100, 100.2, 2}, 100);
    scene.add_corner({100, 1100, 2}, 200);
    EXPECT_FALSE(Bench(scene).find(4).is_flat);
}

}  // namespace
}  // namespace ink::raster
