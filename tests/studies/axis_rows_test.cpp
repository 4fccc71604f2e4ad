#include "studies/axis_rows.h"
#include "methods/method_configs.h"

#include <gmock/gmock.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <memory>

#include "studies/axis.h"
#include "tests/harness/made_up_method.h"

namespace ink::studies {
namespace {

constexpr CaseSize kSmall{112, 63};

std::vector<AxisRow> rows_of(const std::string& axis,
                             double value,
                             const std::vector<method::MethodConfig>& configs,
                             const CaseSize& size = kSmall) {
    std::vector<AxisRow> rows;
    for (const Case& one : find_stress_axis(axis).cases(value, size)) {
        for (AxisRow& row : axis_rows(one, configs, {}))
            rows.push_back(std::move(row));
    }
    return rows;
}

/// The hash of one method's image by scene.
std::map<std::string, std::string> hashes(const std::vector<AxisRow>& rows,
                                          const std::string& method) {
    std::map<std::string, std::string> result;
    for (const AxisRow& row : rows) {
        if (row.row.method == method) result[row.row.scene] = row.row.image_hash;
    }
    return result;
}

TEST(StressRows, NoExtremeLosesACellOrANumber) {
    const auto configs = methods::make_configs("mote4,roberts", {});
    for (const Axis& axis : stress_axes()) {
        const double last = axis.name == "facets" ? 32768 : axis.values.back();  // for time
        for (const double value : {axis.values.front(), last}) {
            const auto rows = rows_of(axis.name, value, configs);
            EXPECT_EQ(rows.size() % 6, 0U) << axis.name;  // four baselines, two methods
            for (const AxisRow& row : rows) {
                EXPECT_EQ(row.row.status, "ok") << axis.name << " " << value;
                EXPECT_EQ(row.faults.lost, 0);
                EXPECT_EQ(row.faults.non_finite, 0)
                    << axis.name << " " << value << " " << row.row.scene;
                EXPECT_EQ(row.faults.overflow, 0)
                    << axis.name << " " << value << " " << row.row.scene;
                if (row.row.method == "oracle") {
                    EXPECT_EQ(row.row.f_2px, 1);
                }
            }
        }
    }
}

TEST(StressRows, ACaseWithoutATruePixelHasNoScore) {
    const auto configs = methods::make_configs("mote4", {});
    int crowded = 0;
    for (const AxisRow& row : rows_of("zoom", 1.0 / 32, configs, {960, 540})) {
        EXPECT_EQ(row.faults.lost, 0) << "lines too dense to score are there";
        const bool has_truth = row.row.n_truth > 0;
        EXPECT_EQ(row.row.is_scored(), has_truth) << row.row.status;
        crowded += has_truth ? 0 : 1;
    }
    EXPECT_GT(crowded, 0);
    Case away = find_stress_axis("zoom").cases(1, kSmall).front();
    const scene::Sphere bounds = scene::bounding_sphere(away.scene_views.scene);
    const glm::dvec3 eye_world = bounds.center_world + glm::dvec3(0, 0, 3 * bounds.radius);
    scene::Camera camera =
        scene::look_at(eye_world, eye_world + glm::dvec3(0, 0, 1), {0, 1, 0}, 0.7);
    scene::fit_clip_range(camera, bounds);
    away.scene_views.views.front().camera = camera;
    for (const AxisRow& row : axis_rows(away, configs, {})) {
        EXPECT_THAT(row.row.status, testing::StartsWith("empty: ")) << row.row.method;
        EXPECT_EQ(row.faults.lost, 1) << "a difficulty takes no line out of the image";
    }
}

TEST(StressRows, HoldNoTimesAndTellTheirPlace) {
    const auto rows = rows_of("zoom", 0.25, methods::make_configs("mote2", {}));
    ASSERT_EQ(rows.size(), 20U);
    EXPECT_EQ(rows[0].row.axis, "zoom");
    EXPECT_EQ(rows[0].row.value, 0.25);
    EXPECT_EQ(rows[0].row.method, "mote2");
    EXPECT_EQ(rows[0].row.scene, "blocks");
    EXPECT_EQ(rows[0].row.view, "zoom=0.25");
    EXPECT_FALSE(rows[0].row.draw_ns);
    EXPECT_FALSE(rows[0].row.prepare_ns);
    EXPECT_EQ(rows[0].row.draw_n, 0);
    EXPECT_EQ(faults_table().line(7, rows[0]), "7,0,0,0,0\n");
}

TEST(StressRows, AMethodThatThrowsIsLost) {
    harness::Script script;
    script.failure = "no ink left";
    const method::MethodInfo info = harness::made_up_info(script);
    const auto rows = rows_of("zoom", 1, {{&info, {}}});
    ASSERT_EQ(rows.size(), 20U);
    EXPECT_EQ(rows[0].row.status, "failed: no ink left");
    EXPECT_EQ(rows[0].faults.lost, 1);
    EXPECT_EQ(rows[4].row.method, "oracle");
    EXPECT_EQ(rows[4].faults.lost, 0) << "the oracle goes on";
    CaseFaults total;
    for (const AxisRow& row : rows)
        total.add(row.faults);
    EXPECT_EQ(total.lost, 4);
    EXPECT_FALSE(total.is_clean());
}

/// Draws an image of a size that nobody asked for.
class Misfit final : public method::Method {
  public:
    void prepare(const scene::PreparedScene&) override {}
    void pose(const scene::PreparedScene&) override {}
    void draw(const method::Frame&, edge::EdgeImage& out) override { out = edge::EdgeImage(3, 5); }
    int bytes_per_px() const override { return 1; }
};

TEST(StressRows, AnImageOfAnotherSizeIsLost) {
    method::MethodInfo info;
    info.name = "misfit";
    info.make = [](const core::ParamValues&) { return std::make_unique<Misfit>(); };
    info.complete = [](const core::ParamValues&) { return core::ParamValues{{"threshold", "9"}}; };
    const auto rows = rows_of("cube_roll", 20, {{&info, {}}});
    ASSERT_EQ(rows.size(), 15U);
    EXPECT_EQ(rows[0].row.status, "failed: an image of 3 x 5 px");
    EXPECT_EQ(rows[0].faults.lost, 1);
}

TEST(StressDifferences, AreToldWhereAnAxisAllowsNone) {
    AxisRow first;
    first.row.method = "mote4";
    first.row.scene = "torus";
    first.row.image_hash = "aa";
    first.row.value = 1;
    AxisRow other = first;
    other.row.image_hash = "bb";
    AxisRow elsewhere = other;
    elsewhere.row.scene = "gear";
    std::vector<AxisRow> rows = {first, other, first, elsewhere};
    note_differences(find_stress_axis("zoom"), rows);
    EXPECT_EQ(rows[1].faults.differing, 0) << "images of a zoom differ by intent";
    note_differences(find_stress_axis("threads"), rows);
    EXPECT_EQ(rows[0].faults.differing, 0);
    EXPECT_EQ(rows[1].faults.differing, 1);
    EXPECT_EQ(rows[1].row.status, "differs: the image is another than at threads 1");
    EXPECT_EQ(rows[2].faults.differing, 0);
    EXPECT_EQ(rows[3].faults.differing, 0);
}

TEST(StressScaleAxis, AMillionthAndABillionTimesTheSizeAreTheSameImage) {
    const auto configs = methods::make_configs("decaudin,polygon_offset", {});
    const auto small = rows_of("scale", std::ldexp(1, -30), configs);
    const auto large = rows_of("scale", std::ldexp(1, 30), configs);
    for (const char* method : {"oracle", "sampled", "exact_corner"})
        EXPECT_EQ(hashes(small, method), hashes(large, method)) << method;
}

TEST(StressOrigin, ExactlyMovedScenesKeepTheirTruth) {
    const auto near = rows_of("origin", 1, {});
    const auto far = rows_of("origin", 1e6, {});
    EXPECT_EQ(hashes(near, "oracle"), hashes(far, "oracle"));
}

TEST(StressFp32, RoundsWhatMethodsAreGivenAndNotTheTruth) {
    const auto configs = methods::make_configs("ids", {});
    const auto exact = rows_of("origin", 1e6, configs);
    const auto rounded = rows_of("fp32", 1e6, configs);
    EXPECT_EQ(hashes(exact, "oracle"), hashes(rounded, "oracle"));
    for (const auto& [scene, hash] : hashes(exact, "ids"))
        EXPECT_NE(hashes(rounded, "ids").at(scene), hash) << scene;
}

/// A method whose declared code fits a byte (or not), and whose pixels are sums of 250, 255, 256,
/// 300.
class Overflowing final : public method::Method {
  public:
    Overflowing(bool wraps, double offset) : wraps_(wraps), offset_(offset) {}
    void prepare(const scene::PreparedScene&) override {}
    void pose(const scene::PreparedScene&) override {}
    void draw(const method::Frame&, edge::EdgeImage&) override {}
    std::vector<method::Layer> layers(const method::Frame&) override {
        core::Image<glm::u8vec3> packed(4, 1);
        int x = 0;
        for (const int sum : {250, 255, 256, 300}) {
            const int code = wraps_ ? sum % 256 : std::min(sum, 255);
            packed.at(x++, 0) = glm::u8vec3(static_cast<std::uint8_t>(code));
        }
        return {{"packed", packed}};
    }
    int bytes_per_px() const override { return 1; }
    std::optional<method::LinearCode> code() const override {
        method::LinearCode code;
        code.offset = offset_;
        code.depth_weight = 255;
        return code;
    }

  private:
    bool wraps_;
    double offset_;
};

std::int64_t overflow_of(double offset) {
    method::MethodInfo info;
    info.name = "overflowing";
    info.make = [offset](const core::ParamValues& values) {
        return std::make_unique<Overflowing>(values.at("overflow") == "wrap", offset);
    };
    info.complete = [](const core::ParamValues&) {
        return core::ParamValues{{"overflow", "saturate"}};
    };
    method::MethodConfig config;
    config.info = &info;
    Overflowing method(false, offset);
    return count_overflow(method, config, {}, {});
}

TEST(CaseFaults, SeeTheTwoPixelsAtWhichACodeOverflows) {
    EXPECT_EQ(overflow_of(0), 2) << "256 and 300 do not fit";
    EXPECT_EQ(overflow_of(100), 0) << "ranges beyond a byte overflow by intent";
}

TEST(CaseFaults, NameNumbersThatAreNone) {
    harness::Row row;
    EXPECT_EQ(count_non_finite(row), 0) << "an empty field is no number";
    row.f_2px = std::numeric_limits<double>::quiet_NaN();
    row.precision_2px = 1.5;
    row.recall_2px = 1;
    EXPECT_EQ(count_non_finite(row), 2);
    truth::Truth truth;
    truth.curves.resize(3);
    truth.curves[0].gap = std::numeric_limits<float>::infinity();  // before the sky
    EXPECT_EQ(count_non_finite(truth), 0);
    truth.curves[1].end.x_px = std::numeric_limits<double>::infinity();
    truth.curves[2].deviation_rad = std::numeric_limits<float>::quiet_NaN();
    EXPECT_EQ(count_non_finite(truth), 2);
}

}  // namespace
}  // namespace ink::studies
