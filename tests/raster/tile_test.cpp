#include <gtest/gtest.h>

#include <algorithm>
#include <map>
#include <mutex>
#include <random>
#include <set>

#include "tests/raster/gather_sink.h"

namespace ink::raster {
namespace {

constexpr int kWidth_px = 193;  // the last tile is one pixel wide: narrower than the halo
constexpr int kHeight_px = 150;

/// Random overlapping triangles at random distances, large and small, some beyond the frame.
TestMesh random_soup(unsigned seed, int interpolants) {
    std::mt19937 random(seed);
    std::uniform_real_distribution<double> x(-40, kWidth_px + 40);
    std::uniform_real_distribution<double> y(-40, kHeight_px + 40);
    std::uniform_real_distribution<double> w(0.2, 20);
    std::uniform_real_distribution<double> small(-9, 9);
    std::uniform_real_distribution<float> value(-100, 400);
    TestMesh mesh;
    for (int t = 0; t < 300; ++t) {
        const glm::dvec3 a(x(random), y(random), w(random));
        if (t % 20 == 0) {
            mesh.add_triangle(a, {x(random), y(random), w(random)}, {x(random), y(random), 30});
        } else {
            const auto near_a = [&] { return a + glm::dvec3(small(random), small(random), 0); };
            mesh.add_triangle(a, near_a(), near_a());
        }
    }
    for (std::size_t i = 0; i < mesh.p_clip.size() * static_cast<std::size_t>(interpolants); ++i)
        mesh.values.push_back(value(random));
    return mesh;
}

/// Compares every halo pixel with the whole image put together from tiles' own pixels.
class HaloSink : public TileSink {
  public:
    explicit HaloSink(const GatherSink<std::uint8_t>& whole) : whole_(whole) {}

    void finish(const Tile& tile) override {
        for (int y = -tile.halo_px; y < tile.height_px + tile.halo_px; ++y) {
            for (int x = -tile.halo_px; x < tile.width_px + tile.halo_px; ++x) {
                const int nearest_x = std::clamp(tile.x0_px + x, 0, kWidth_px - 1);
                const int nearest_y = std::clamp(tile.y0_px + y, 0, kHeight_px - 1);
                ++compared;
                different +=
                    tile.row<std::uint8_t>(0, y)[x] != whole_.planes[0].at(nearest_x, nearest_y);
                different +=
                    tile.row<std::uint8_t>(1, y)[x] != whole_.planes[1].at(nearest_x, nearest_y);
                different += tile.depth_row<float>(y)[x] != whole_.depth.at(nearest_x, nearest_y);
            }
        }
    }

    int compared = 0;
    int different = 0;

  private:
    const GatherSink<std::uint8_t>& whole_;
};

PassFormat two_bytes(int halo_px) {
    return {.interpolants = 2, .store = Store::u8, .halo_px = halo_px};
}

TEST(Tiles, HalosHoldTheNeighboursPixelsAndTheFramesNearestOnes) {
    const TestMesh mesh = random_soup(1, 2);
    const auto whole = gathered<std::uint8_t>(two_bytes(0), mesh.input(), kWidth_px, kHeight_px);
    for (const int halo_px : {1, 2}) {
        HaloSink sink(whole);
        draw_pass(two_bytes(halo_px), mesh.input(), kWidth_px, kHeight_px, 1, sink);
        EXPECT_EQ(sink.different, 0) << "halo " << halo_px;
        EXPECT_GT(sink.compared, kWidth_px * kHeight_px);
    }
}

/// Where tiles lie, for an image of the given size.
class PlacesSink : public TileSink {
  public:
    void finish(const Tile& tile) override {
        const std::lock_guard lock(mutex_);
        places.insert({tile.x0_px, tile.y0_px, tile.width_px, tile.height_px});
        ++calls;
    }
    std::set<std::array<int, 4>> places;
    int calls = 0;

  private:
    std::mutex mutex_;
};

TEST(Tiles, CoverTheImageOnceEach) {
    PlacesSink sink;
    draw_pass({}, TestMesh().input(), kWidth_px, kHeight_px, 3, sink);
    EXPECT_EQ(sink.calls, 12);
    EXPECT_EQ(sink.places.size(), 12U);
    EXPECT_TRUE(sink.places.contains({192, 128, 1, 22}));
    EXPECT_TRUE(sink.places.contains({64, 0, 64, 64}));
}

TEST(Tiles, AnEmptyImageCallsNobody) {
    for (const auto& [width_px, height_px] : {std::pair{0, 5}, {5, 0}, {0, 0}}) {
        PlacesSink sink;
        const TestMesh mesh = random_soup(1, 0);
        draw_pass({}, mesh.input(), width_px, height_px, 1, sink);
        EXPECT_EQ(sink.calls, 0);
    }
}

/// Every pixel of every tile, halo included.
class WordSink : public TileSink {
  public:
    explicit WordSink(const PassFormat& format) : format_(format) {}

    void finish(const Tile& tile) override {
        std::vector<std::uint32_t> words;
        for (int y = -tile.halo_px; y < tile.height_px + tile.halo_px; ++y)
            for (int x = -tile.halo_px; x < tile.width_px + tile.halo_px; ++x)
                append_words(tile, format_, x, y, words);
        const std::lock_guard lock(mutex_);
        tiles.insert({{tile.x0_px, tile.y0_px}, std::move(words)});
    }

    std::map<std::pair<int, int>, std::vector<std::uint32_t>> tiles;

  private:
    PassFormat format_;
    std::mutex mutex_;
};

struct FormatCase {
    int interpolants;
    Store store;
    Interpolation interpolation;
    DepthFormat depth;
};

class EveryFormat : public testing::TestWithParam<FormatCase> {};

TEST_P(EveryFormat, GivesTheSameBitsOnOneTwoAndFourThreads) {
    const FormatCase& c = GetParam();
    PassFormat format;
    format.interpolants = c.interpolants;
    format.store = c.store;
    format.interpolation = c.interpolation;
    format.depth = c.depth;
    format.constant = c.store == Store::u32;
    format.halo_px = 2;
    TestMesh mesh = random_soup(9, c.interpolants);
    for (int copies = 0; copies < 5; ++copies)  // more triangles than a batch holds
        mesh.triangles.insert(mesh.triangles.end(), mesh.triangles.begin(), mesh.triangles.end());
    PassInput input = mesh.input();
    const std::vector<std::uint32_t> constants(mesh.triangles.size(), 77);
    input.constants = constants;

    WordSink one(format);
    draw_pass(format, input, kWidth_px, kHeight_px, 1, one);
    for (const int threads : {2, 4}) {
        WordSink many(format);
        draw_pass(format, input, kWidth_px, kHeight_px, threads, many);
        EXPECT_TRUE(many.tiles == one.tiles) << threads << " threads";
    }
}

constexpr auto kAffine = Interpolation::affine;
constexpr auto kPerspective = Interpolation::perspective;

INSTANTIATE_TEST_SUITE_P(Raster,
                         EveryFormat,
                         testing::Values(FormatCase{0, Store::none, kAffine, DepthFormat::q32},
                                         FormatCase{0, Store::none, kAffine, DepthFormat::z16},
                                         FormatCase{0, Store::u32, kAffine, DepthFormat::z24},
                                         FormatCase{1, Store::u8, kAffine, DepthFormat::q32},
                                         FormatCase{1, Store::u8, kPerspective, DepthFormat::z24},
                                         FormatCase{1, Store::u16, kAffine, DepthFormat::z16},
                                         FormatCase{1, Store::u16, kPerspective, DepthFormat::q32},
                                         FormatCase{2, Store::u8, kAffine, DepthFormat::q32},
                                         FormatCase{2, Store::u8, kPerspective, DepthFormat::q32},
                                         FormatCase{4, Store::f32, kAffine, DepthFormat::q32},
                                         FormatCase{
                                             4, Store::f32, kPerspective, DepthFormat::z24}));

TEST(Tiles, EmptyTilesHoldTheSky) {
    class SkySink : public TileSink {
      public:
        void finish(const Tile& tile) override {
            EXPECT_TRUE(tile.is_empty);
            EXPECT_EQ(tile.row<std::uint8_t>(0, -2)[-2], 7);
            EXPECT_EQ(tile.row<std::uint8_t>(1, tile.height_px + 1)[tile.width_px + 1], 200);
            EXPECT_EQ(tile.depth_row<float>(0)[0], 0);
        }
    };
    TestMesh mesh;
    PassInput input = mesh.input();
    input.sky_code = {7, 200};
    SkySink sink;
    draw_pass(two_bytes(2), input, 70, 70, 1, sink);
}

}  // namespace
}  // namespace ink::raster
