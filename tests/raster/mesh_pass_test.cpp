#include "raster/mesh/mesh_pass.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numeric>

#include "core/simd.h"
#include "tests/raster/gather_sink.h"
#include "tests/raster/stage.h"

namespace ink::raster {
namespace {

constexpr int kWidth_px = 200;  // not a multiple of a tile
constexpr int kHeight_px = 150;

/// Distance and normal as four numbers, or one code of all.
class TestValues : public CornerValues {
  public:
    explicit TestValues(int planes, double scale) {
        values_.resize(static_cast<std::size_t>(planes));
        for (int k = 0; k < planes; ++k) {
            values_[static_cast<std::size_t>(k)].base = scale * 0.4 + k;
            values_[static_cast<std::size_t>(k)].per_q = scale * 0.3;
            values_[static_cast<std::size_t>(k)].per_normal[k % 3] =
                static_cast<float>(scale * 0.2);
        }
    }
    void compute(const CornerBatch& in, const CornerPlanes& out) const override {
        compute_linear(values_.data(), static_cast<int>(values_.size()), false, in, out);
    }

  private:
    std::vector<LinearValue> values_;
};

struct Evaluation {
    PassFormat format;
    double scale;
    PolygonOffset offset;
    Cull cull = Cull::none;
};

/// Every pair that lanes draw, and some that they do not.
std::vector<Evaluation> evaluations() {
    const auto make = [](Store store, int interpolants, double scale) {
        Evaluation evaluation{{}, scale, {}};
        evaluation.format.store = store;
        evaluation.format.interpolants = interpolants;
        evaluation.format.halo_px = 1;
        return evaluation;
    };
    std::vector<Evaluation> result = {make(Store::none, 0, 0),
                                      make(Store::u8, 1, 250),
                                      make(Store::u8, 2, 250),
                                      make(Store::u16, 1, 60000),
                                      make(Store::f32, 4, 1)};
    result.push_back(make(Store::u8, 1, 500));
    result.back().format.overflow = Overflow::wrap;
    result.push_back(make(Store::u8, 1, 250));
    result.back().format.depth = DepthFormat::z16;
    result.push_back(make(Store::f32, 4, 1));
    result.back().format.depth = DepthFormat::z24;
    result.push_back(make(Store::f32, 4, 1));
    result.back().format.interpolation = Interpolation::perspective;
    for (const DepthFormat depth : {DepthFormat::q32, DepthFormat::z16, DepthFormat::z24}) {
        for (const PolygonOffset offset : {PolygonOffset{}, {-1.5, -1}, {1, 2}}) {
            for (const Cull cull : {Cull::none, Cull::back, Cull::front}) {
                result.push_back(make(Store::none, 0, 0));
                result.back().format.depth = depth;
                result.back().offset = offset;
                result.back().cull = cull;
            }
        }
    }
    for (const Store store : {Store::u8, Store::u32}) {
        for (const DepthFormat depth : {DepthFormat::z24, DepthFormat::q32}) {
            result.push_back(make(store, 0, 0));
            result.back().format.depth = depth;
            result.back().format.constant = true;
        }
    }
    return result;
}

/// All that a pass leaves, word by word.
struct Drawn {
    core::Image<std::uint32_t> depth{kWidth_px, kHeight_px};
    std::vector<core::Image<std::uint32_t>> planes;

    friend bool operator==(const Drawn& a, const Drawn& b) {
        return a.depth == b.depth && a.planes == b.planes;
    }
};

/// Keeps everything.
class KeepSink : public TileSink {
  public:
    KeepSink(const PassFormat& format, Drawn& to) : format_(format), to_(to) {
        to_.planes.assign(static_cast<std::size_t>(format.planes()), to_.depth);
    }
    void finish(const Tile& tile) override {
        for (int y = 0; y < tile.height_px; ++y) {
            for (int x = 0; x < tile.width_px; ++x) {
                const int u = tile.x0_px + x, v = tile.y0_px + y;
                to_.depth.at(u, v) = tile.depth_row<std::uint32_t>(y)[x];
                for (int k = 0; k < format_.planes(); ++k)
                    to_.planes[static_cast<std::size_t>(k)].at(u, v) =
                        word_at(tile, format_.store, k, x, y);
            }
        }
    }

  private:
    const PassFormat& format_;
    Drawn& to_;
};

/// A stage whose triangles have constants.
struct PassStage : Stage {
    std::vector<std::uint32_t> ids;   ///< 1 + index of each triangle: its constant
    std::vector<std::uint8_t> bytes;  ///< the same in the order of clusters, if not empty

    explicit PassStage(const std::string& name, double nearer = 1)
        : Stage(name, {kWidth_px, kHeight_px}, nearer) {
        ids.resize(surface.triangles.size());
        std::iota(ids.begin(), ids.end(), 1U);
    }

    [[nodiscard]] Drawn draw(const Evaluation& evaluation,
                             int threads,
                             const SkipSet& skips) const {
        const TestValues values(evaluation.format.interpolants, evaluation.scale);
        MeshInput input = mesh_input(threads, skips);
        input.values = &values;
        if (evaluation.format.constant) {
            input.constants = ids;
            input.constants_in_clusters = bytes;
        }
        input.offset = evaluation.offset;
        input.cull = evaluation.cull;
        Drawn drawn;
        KeepSink sink(evaluation.format, drawn);
        MeshPass pass;
        (void)pass.draw(evaluation.format, input, sink);
        return drawn;
    }
};

const std::vector<std::string> kScenes = {"sphere", "tree", "staircase", "soup", "room"};

TEST(MeshPass, SkipsThreadsAndTargetsNeverChangeABit) {
    for (const std::string& name : kScenes) {
        for (const double nearer : {1.0, 0.05}) {
            const PassStage stage(name, nearer);
            for (const Evaluation& evaluation : evaluations()) {
                const Drawn best = stage.draw(evaluation, 1, {});
                for (const core::SimdTarget& target : core::simd_targets()) {
                    const core::ForcedSimdTarget forced(target);
                    for (const int threads : {1, 2, 5}) {
                        EXPECT_TRUE(stage.draw(evaluation, threads, {}) == best)
                            << name << " on " << target.name << ", threads " << threads;
                    }
                }
                EXPECT_TRUE(stage.draw(evaluation, 1, SkipSet::none()) == best) << name;
                for (const SkipInfo& info : skip_infos()) {
                    const SkipSet skips = SkipSet().set(info.skip, false);
                    EXPECT_TRUE(stage.draw(evaluation, 1, skips) == best)
                        << name << ' ' << info.name;
                }
            }
        }
    }
}

TEST(MeshPass, DrawsATriangleThatGainsAnAreaWhenItMoves) {
    PassStage stage("cube");
    const scene::Surface still = stage.surface;
    for (const std::uint32_t corner : stage.surface.triangles.front())
        stage.surface.p_world[corner] = {0, 0, 0};
    stage.mesh = LaneMesh(stage.surface);
    const Evaluation evaluation = evaluations()[1];
    const Drawn flat = stage.draw(evaluation, 1, {});
    stage.mesh.update(still);
    const Drawn moved = stage.draw(evaluation, 1, {});
    stage.mesh = LaneMesh(still);
    EXPECT_TRUE(moved == stage.draw(evaluation, 1, {}));
    EXPECT_FALSE(moved == flat);
}

/// What draw_pass, the plain pass, makes of a stage's front and back faces.
Drawn draw_plainly(const PassStage& stage, const PassFormat& format) {
    const std::vector<glm::dvec3> p_clip = clip_places(stage.surface, stage.view);
    PassInput input = plain_input(p_clip, stage.view);
    input.triangles = stage.surface.triangles;
    if (format.constant) input.constants = stage.ids;
    Drawn drawn;
    KeepSink sink(format, drawn);
    draw_pass(format, input, kWidth_px, kHeight_px, 1, sink);
    return drawn;
}

TEST(MeshPass, ConstantsAreThoseOfTheTrianglesThatThePlainPassSees) {
    for (const std::string& name : kScenes) {
        for (const double nearer : {1.0, 0.05}) {  // from within: triangles are cut
            const PassStage stage(name, nearer);
            const Evaluation evaluation = evaluations().back();
            const auto ours = stage.draw(evaluation, 1, {}).planes[0];
            const auto plain = draw_plainly(stage, evaluation.format).planes[0];
            int covered_px = 0;
            int unlike_px = 0;
            for (std::size_t i = 0; i < plain.size(); ++i) {
                covered_px += plain.data()[i] != 0 ? 1 : 0;
                unlike_px += ours.data()[i] != plain.data()[i] ? 1 : 0;
            }
            EXPECT_GT(covered_px, 1000) << name;
            // Faces of equal depth and faces turned away are told apart by order alone.
            EXPECT_LE(unlike_px, covered_px / 100) << name << ' ' << nearer;
        }
    }
}

TEST(MeshPass, NarrowConstantsAreTheLowBitsOfWideOnes) {
    for (const std::string& name : kScenes) {
        const PassStage stage(name, 0.05);
        Evaluation evaluation = evaluations().back();
        const auto lanes = stage.draw(evaluation, 1, {}).planes[0];
        const auto plain = draw_plainly(stage, evaluation.format).planes[0];
        evaluation.format.store = Store::u8;
        const auto narrow_lanes = stage.draw(evaluation, 1, {}).planes[0];
        const auto narrow_plain = draw_plainly(stage, evaluation.format).planes[0];
        for (std::size_t i = 0; i < lanes.size(); ++i) {
            ASSERT_EQ(narrow_lanes.data()[i], lanes.data()[i] & 0xffU);
            ASSERT_EQ(narrow_plain.data()[i], plain.data()[i] & 0xffU);
        }
    }
}

TEST(MeshPass, ConstantsInTheOrderOfClustersAreTheSame) {
    for (const std::string& name : kScenes) {
        PassStage stage(name);
        for (std::uint32_t& id : stage.ids)
            id &= 0xffU;
        const Evaluation evaluation = evaluations().back();
        const Drawn looked_up = stage.draw(evaluation, 1, {});
        for (const std::uint32_t id : stage.mesh.clusters().triangle_ids)
            stage.bytes.push_back(static_cast<std::uint8_t>(stage.ids[id]));
        EXPECT_TRUE(stage.draw(evaluation, 1, {}) == looked_up) << name;
    }
}

/// Lanes interpolate steps as floats from corners rounded to 1/65536 px: on a slope of many steps a
/// pixel that shows in the last bits of z24. At a contour of a solid the plain pass may show a face
/// turned away.
TEST(MeshPass, CoversThePixelsOfThePlainPassAtItsDepthButForTheLastBits) {
    struct Last {
        DepthFormat format;
        int few;
        int many;
    };
    for (const std::string& name : kScenes) {
        const PassStage stage(name);
        for (const auto& [format, few, many] : {Last{DepthFormat::q32, 16, 16},
                                                {DepthFormat::z24, 4, 64},
                                                {DepthFormat::z16, 1, 1}}) {
            Evaluation evaluation = evaluations().front();
            evaluation.format.depth = format;
            const Drawn lanes = stage.draw(evaluation, 1, {});
            const Drawn plain = draw_plainly(stage, evaluation.format);
            int covered_px = 0;
            int beyond_few_px = 0;
            int beyond_many_px = 0;
            for (std::size_t i = 0; i < plain.depth.size(); ++i) {
                const auto depth = static_cast<int>(lanes.depth.data()[i]);
                const auto expected = static_cast<int>(plain.depth.data()[i]);
                EXPECT_EQ(depth > 0, expected > 0) << name << " at " << i;
                covered_px += expected > 0 ? 1 : 0;
                beyond_few_px += std::abs(depth - expected) > few ? 1 : 0;
                beyond_many_px += std::abs(depth - expected) > many ? 1 : 0;
            }
            EXPECT_GT(covered_px, 1000) << name;
            EXPECT_LE(beyond_few_px, covered_px / 80) << name;
            EXPECT_LE(beyond_many_px, covered_px / 500) << name;
        }
    }
}

}  // namespace
}  // namespace ink::raster
