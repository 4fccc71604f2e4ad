#include "raster/mesh/mesh_pass.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numeric>

#include "catalogue/catalogue.h"
#include "core/simd.h"
#include "gather_sink.h"
#include "raster/pass/view_transform.h"
#include "scene/predicates.h"

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
        for (const PolygonOffset offset : {PolygonOffset{-1.5, -1}, {1, 2}}) {
            result.push_back(make(Store::none, 0, 0));
            result.back().format.depth = depth;
            result.back().offset = offset;
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

/// All that a pass leaves, as bytes in images.
struct Drawn {
    std::vector<core::Image<float>> numbers;
    std::vector<core::Image<std::uint16_t>> codes;
    core::Image<float> depth;
    core::Image<std::uint32_t> steps;
    core::Image<std::uint32_t> constants;
    MeshResult result;
    friend bool operator==(const Drawn& a, const Drawn& b) {
        return a.numbers == b.numbers && a.codes == b.codes && a.depth == b.depth &&
               a.steps == b.steps && a.constants == b.constants;
    }
};

/// Keeps everything.
class KeepSink : public TileSink {
  public:
    KeepSink(const PassFormat& format, Drawn& to) : format_(format), to_(to) {
        const auto planes = static_cast<std::size_t>(format.planes());
        if (format.store == Store::u32) {
            to_.constants = core::Image<std::uint32_t>(kWidth_px, kHeight_px);
        } else if (format.store == Store::f32) {
            to_.numbers.assign(planes, core::Image<float>(kWidth_px, kHeight_px));
        } else {
            to_.codes.assign(planes, core::Image<std::uint16_t>(kWidth_px, kHeight_px));
        }
        if (format.depth == DepthFormat::q32) {
            to_.depth = core::Image<float>(kWidth_px, kHeight_px);
        } else {
            to_.steps = core::Image<std::uint32_t>(kWidth_px, kHeight_px);
        }
    }
    void finish(const Tile& tile) override {
        for (int y = 0; y < tile.height_px; ++y) {
            for (int x = 0; x < tile.width_px; ++x)
                keep(tile, x, y);
        }
    }

  private:
    void keep(const Tile& tile, int x, int y) {
        const int u = tile.x0_px + x;
        const int v = tile.y0_px + y;
        if (format_.depth == DepthFormat::q32) {
            to_.depth.at(u, v) = tile.depth_row<float>(y)[x];
        } else {
            to_.steps.at(u, v) = tile.depth_row<std::uint32_t>(y)[x];
        }
        for (int k = 0; k < format_.planes(); ++k) {
            const auto at = static_cast<std::size_t>(k);
            if (format_.store == Store::u32)
                to_.constants.at(u, v) = tile.row<std::uint32_t>(k, y)[x];
            if (format_.store == Store::f32) to_.numbers[at].at(u, v) = tile.row<float>(k, y)[x];
            if (format_.store == Store::u8)
                to_.codes[at].at(u, v) = tile.row<std::uint8_t>(k, y)[x];
            if (format_.store == Store::u16)
                to_.codes[at].at(u, v) = tile.row<std::uint16_t>(k, y)[x];
        }
    }

    const PassFormat& format_;
    Drawn& to_;
};

/// A scene of the catalogue, laid out, and its first view at the test's size.
struct Stage {
    scene::Surface surface;
    LaneMesh mesh;
    std::vector<std::uint32_t> ids;   ///< 1 + index of each triangle: its constant
    std::vector<std::uint8_t> bytes;  ///< the same in the order of clusters, if not empty
    scene::View view;

    explicit Stage(const std::string& name, double nearer = 1) {
        const scene::Scene made = catalogue::make_catalogue_scene(name);
        surface = scene::flatten(made, scene::NormalSource::patch, 0.7);
        mesh = LaneMesh(surface);
        ids.resize(surface.triangles.size());
        std::iota(ids.begin(), ids.end(), 1U);
        view.camera = made.cameras.front();
        const scene::Sphere bounds = scene::bounding_sphere(made);
        view.camera.eye_world =
            bounds.center_world + (view.camera.eye_world - bounds.center_world) * nearer;
        scene::fit_clip_range(view.camera, bounds);
        view.width_px = kWidth_px;
        view.height_px = kHeight_px;
    }

    [[nodiscard]] Drawn draw(const Evaluation& evaluation,
                             int threads,
                             const SkipSet& skips) const {
        const TestValues values(evaluation.format.interpolants, evaluation.scale);
        MeshInput input;
        input.mesh = &mesh;
        input.values = &values;
        if (evaluation.format.constant) {
            input.constants = ids;
            input.constants_in_clusters = bytes;
        }
        input.view = view;
        input.threads = threads;
        input.skips = skips;
        input.offset = evaluation.offset;
        Drawn drawn;
        KeepSink sink(evaluation.format, drawn);
        MeshPass pass;
        drawn.result = pass.draw(evaluation.format, input, sink);
        return drawn;
    }
};

const std::vector<std::string> kScenes = {"sphere", "tree", "staircase", "soup", "room"};

TEST(MeshPass, EverySimdTargetAndThreadCountGivesTheSameBits) {
    for (const std::string& name : kScenes) {
        for (const double nearer : {1.0, 0.05}) {
            const Stage stage(name, nearer);
            for (const Evaluation& evaluation : evaluations()) {
                const Drawn best = stage.draw(evaluation, 1, {});
                for (const core::SimdTarget& target : core::simd_targets()) {
                    const core::ForcedSimdTarget forced(target);
                    for (const int threads : {1, 2, 5}) {
                        EXPECT_TRUE(stage.draw(evaluation, threads, {}) == best)
                            << name << " on " << target.name << ", threads " << threads;
                    }
                }
            }
        }
    }
}

TEST(MeshPass, SkipsNeverChangeABit) {
    for (const std::string& name : kScenes) {
        for (const double nearer : {1.0, 0.05}) {
            const Stage stage(name, nearer);
            for (const Evaluation& evaluation : evaluations()) {
                const Drawn all = stage.draw(evaluation, 1, {});
                EXPECT_TRUE(stage.draw(evaluation, 1, SkipSet::none()) == all) << name;
                for (const SkipInfo& info : skip_infos()) {
                    SkipSet skips;
                    skips.set(info.skip, false);
                    EXPECT_TRUE(stage.draw(evaluation, 1, skips) == all)
                        << name << ' ' << info.name;
                }
            }
        }
    }
}

TEST(MeshPass, DrawsATriangleThatGainsAnAreaWhenItMoves) {
    Stage stage("cube");
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
Drawn draw_plainly(const Stage& stage, const PassFormat& format) {
    const ViewTransform transform(stage.view);
    std::vector<glm::dvec3> p_clip;
    for (const glm::dvec3& p : stage.surface.p_world)
        p_clip.push_back(transform.to_clip(p));
    PassInput input;
    input.p_clip = p_clip;
    input.triangles = stage.surface.triangles;
    if (format.constant) input.constants = stage.ids;
    input.near = stage.view.camera.near;
    input.far = stage.view.camera.far;
    Drawn drawn;
    KeepSink sink(format, drawn);
    draw_pass(format, input, kWidth_px, kHeight_px, 1, sink);
    return drawn;
}

TEST(MeshPass, CoversThePixelsThatThePlainPassCoversAtTheSameDepth) {
    for (const std::string& name : kScenes) {
        const Stage stage(name);
        const Drawn lanes = stage.draw(evaluations().front(), 1, {});
        const Drawn plain = draw_plainly(stage, evaluations().front().format);
        int covered_px = 0;
        int unlike_px = 0;
        for (int y = 0; y < kHeight_px; ++y) {
            for (int x = 0; x < kWidth_px; ++x) {
                const float q = lanes.depth.at(x, y);
                const float expected = plain.depth.at(x, y);
                EXPECT_EQ(q > 0, expected > 0) << name << ' ' << x << ' ' << y;
                covered_px += expected > 0 ? 1 : 0;
                // At a contour of a solid the plain pass may show a face turned away.
                if (std::abs(q - expected) > 2e-6F * expected) ++unlike_px;
            }
        }
        EXPECT_GT(covered_px, 1000) << name;
        EXPECT_LE(unlike_px, covered_px / 500) << name;
    }
}

TEST(MeshPass, ConstantsAreThoseOfTheTrianglesThatThePlainPassSees) {
    for (const std::string& name : kScenes) {
        for (const double nearer : {1.0, 0.05}) {  // from within: triangles are cut
            const Stage stage(name, nearer);
            const Evaluation evaluation = evaluations().back();
            const Drawn ours = stage.draw(evaluation, 1, {});
            const Drawn plain = draw_plainly(stage, evaluation.format);
            int covered_px = 0;
            int unlike_px = 0;
            for (std::size_t i = 0; i < plain.constants.size(); ++i) {
                covered_px += plain.constants.data()[i] != 0 ? 1 : 0;
                unlike_px += ours.constants.data()[i] != plain.constants.data()[i] ? 1 : 0;
            }
            EXPECT_GT(covered_px, 1000) << name;
            // Faces of equal depth and faces turned away are told apart by order alone.
            EXPECT_LE(unlike_px, covered_px / 100) << name << ' ' << nearer;
        }
    }
}

TEST(MeshPass, NarrowConstantsAreTheLowBitsOfWideOnes) {
    for (const std::string& name : kScenes) {
        const Stage stage(name, 0.05);
        Evaluation evaluation = evaluations().back();
        const Drawn lanes = stage.draw(evaluation, 1, {});
        const Drawn plain = draw_plainly(stage, evaluation.format);
        evaluation.format.store = Store::u8;
        const Drawn narrow_lanes = stage.draw(evaluation, 1, {});
        const Drawn narrow_plain = draw_plainly(stage, evaluation.format);
        for (std::size_t i = 0; i < lanes.constants.size(); ++i) {
            ASSERT_EQ(narrow_lanes.codes[0].data()[i], lanes.constants.data()[i] & 0xffU);
            ASSERT_EQ(narrow_plain.codes[0].data()[i], plain.constants.data()[i] & 0xffU);
        }
    }
}

TEST(MeshPass, ConstantsInTheOrderOfClustersAreTheSame) {
    for (const std::string& name : kScenes) {
        Stage stage(name);
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
/// pixel that shows in the last bits of z24.
TEST(MeshPass, StepsAreThoseOfThePlainPassButForTheLastBits) {
    for (const std::string& name : kScenes) {
        const Stage stage(name);
        for (const DepthFormat depth : {DepthFormat::z24, DepthFormat::z16}) {
            Evaluation evaluation = evaluations().front();
            evaluation.format.depth = depth;
            const Drawn lanes = stage.draw(evaluation, 1, {});
            const Drawn plain = draw_plainly(stage, evaluation.format);
            const int few = depth == DepthFormat::z24 ? 4 : 1;
            const int many = depth == DepthFormat::z24 ? 64 : 1;
            int covered_px = 0;
            int beyond_few_px = 0;
            int beyond_many_px = 0;
            for (int y = 0; y < kHeight_px; ++y) {
                for (int x = 0; x < kWidth_px; ++x) {
                    const auto step = static_cast<int>(lanes.steps.at(x, y));
                    const auto expected = static_cast<int>(plain.steps.at(x, y));
                    EXPECT_EQ(step > 0, expected > 0) << name << ' ' << x << ' ' << y;
                    EXPECT_LE(step, depth == DepthFormat::z24 ? 0xffffff : 0xffff);
                    covered_px += expected > 0 ? 1 : 0;
                    beyond_few_px += std::abs(step - expected) > few ? 1 : 0;
                    beyond_many_px += std::abs(step - expected) > many ? 1 : 0;
                }
            }
            EXPECT_GT(covered_px, 1000) << name;
            EXPECT_LE(beyond_few_px, covered_px / 80) << name;
            EXPECT_LE(beyond_many_px, covered_px / 500) << name;
        }
    }
}

}  // namespace
}  // namespace ink::raster
