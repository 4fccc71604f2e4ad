#include <gtest/gtest.h>

#include <algorithm>
#include <string>
#include <vector>

#include "methods/method_configs.h"
#include "studies/axis.h"
#include "studies/axis_rows.h"

// experiments/notes/stress.md says why methods fail on an axis. Each reason is held here by
// something that would come out otherwise if it were wrong: another axis, another setting, another
// method.

namespace ink::studies {
namespace {

constexpr CaseSize kSize{240, 135};

/// E = 1 - F of all cases of a place on an axis, pooled; `settings` as `--set` takes them.
double error_of(const std::string& axis,
                double value,
                const std::string& method,
                const std::vector<std::string>& settings = {},
                const CaseSize& size = kSize) {
    const auto configs = methods::make_configs(method == "sampled" ? "ids" : method, settings);
    score::CurveCount all;
    const Axis& along = find_stress_axis(axis);
    for (const Case& one : along.cases(value, size)) {
        for (const AxisRow& row : axis_rows(one, configs, {})) {
            if (row.row.method != method) continue;
            // Far away a case may have no line that can be told from another.
            if (axis == "zoom" && row.row.status.starts_with("crowded")) continue;
            EXPECT_EQ(row.row.status, "ok") << axis << " " << value << " " << method;
            all += score::CurveCount{row.row.k_2px, row.row.n_pred, row.row.n_truth};
        }
    }
    EXPECT_GT(all.n_truth, 0) << axis << " " << value;
    return 1 - all.f();
}

// Differences of E that count as none, and as some.
constexpr double kSame = 0.01;
constexpr double kWorse = 0.03;

const std::vector<std::string> kNoDepth = {"range_depth=0"};

TEST(StressReasons, LinesLoseTheirDepthTestToZ24NearTheFarPlane) {
    for (const char* method : {"back_faces", "polygon_offset"}) {
        const double near_by = error_of("near_far", 10, method, {"depth_format=z24"});
        EXPECT_GT(error_of("near_far", 1e8, method, {"depth_format=z24"}), near_by + kWorse);
        EXPECT_NEAR(error_of("near_far", 1e8, method, {"depth_format=q32"}), near_by, kSame)
            << method << ": a float of 1/w keeps its bits at any distance";
    }
}

TEST(StressReasons, PackedCodesHaveNoDepthLeftBetweenNearAndFar) {
    EXPECT_NEAR(
        error_of("near_far", 10, "mote4", kNoDepth), error_of("near_far", 10, "mote4"), kSame);
}

TEST(StressReasons, AGrazedFloorCancelsInOneSumAndNotInTwo) {
    const double one_sum = error_of("grazing", 10, "mote4");
    EXPECT_GT(one_sum, error_of("grazing", 10, "two_sums") + kWorse);
    EXPECT_GT(one_sum, error_of("grazing", 10, "decaudin") + kWorse) << "nor in four channels";
    EXPECT_GT(one_sum, error_of("grazing", 0.5, "mote4") + kWorse) << "nor in another direction";
}

TEST(StressReasons, MethodsOfEdgesDrawNoIntersectionsOnAFloor) {
    EXPECT_LT(error_of("grazing", 10, "ids"), 0.02) << "all lines can be had from surface ids";
    EXPECT_GT(error_of("grazing", 10, "edge_hash"), 0.1);
}

TEST(StressReasons, TheGuardAgainstSlopesKeepsAGrazedFloorWhite) {
    EXPECT_LT(error_of("grazing", 0.5, "roberts"), 0.05);
    EXPECT_GT(error_of("grazing", 0.5, "roberts", {"guard=none"}), 0.5);
    EXPECT_NEAR(error_of("grazing_linear", 0.5, "sobel"), error_of("grazing", 0.5, "sobel"), kSame)
        << "a threshold relative to the scene's whole depth needs none";
}

TEST(StressReasons, VerticesRoundedFarFromTheOriginAreLostToAllMethodsAlike) {
    for (const char* method : {"mote4", "edge_hash"}) {
        const double at_home = error_of("origin", 1, method);
        EXPECT_NEAR(error_of("origin", 1e8, method), at_home, kSame) << "positions are double";
        EXPECT_NEAR(error_of("fp32", 1e5, method), at_home, kSame) << "steps of 1/128";
        EXPECT_GT(error_of("fp32", 1e8, method), 0.9) << "steps of 8 units";
    }
}

TEST(StressReasons, LinesCrowdFarAwayAndALargerImagePartsThem) {
    const double small = error_of("zoom", 1.0 / 32, "sampled");
    EXPECT_GT(small, 0.1);
    EXPECT_LT(error_of("zoom", 1.0 / 32, "sampled", {}, {960, 540}), 0.1);
}

TEST(StressReasons, ARollTurnsOneSumBlindAndNotFourChannels) {
    double low = 1, high = 0, low_apart = 1, high_apart = 0;
    for (double roll_deg = 0; roll_deg < 90; roll_deg += 10) {
        const double one_sum = error_of("cube_roll", roll_deg, "mote4");
        low = std::min(low, one_sum);
        high = std::max(high, one_sum);
        const double apart = error_of("cube_roll", roll_deg, "decaudin");
        low_apart = std::min(low_apart, apart);
        high_apart = std::max(high_apart, apart);
    }
    EXPECT_GT(high - low, 0.03);
    EXPECT_LT(high_apart - low_apart, 0.015);
}

TEST(StressReasons, BelowTheThresholdOfAStepDepthSaysNothing) {
    EXPECT_NEAR(error_of("gap", 1e-4, "mote4", kNoDepth), error_of("gap", 1e-4, "mote4"), 0.001);
    EXPECT_GT(error_of("gap", 0.1, "mote4", kNoDepth), error_of("gap", 0.1, "mote4") + kSame);
    EXPECT_LT(error_of("gap", 1e-4, "ids"), 0.05) << "ids need no depth";
}

TEST(StressReasons, EdgeHashWeldsNeedlesAway) {
    const double welded = error_of("sliver", 1e5, "edge_hash");
    const double kept = error_of("sliver", 1e5, "edge_hash", {"epsilon=1e-8"});
    EXPECT_GT(welded, kept + 0.1);
    EXPECT_NEAR(kept, error_of("sliver", 1e5, "edge_list"), kSame)
        << "it welds equal vertices alone";
    EXPECT_GT(error_of("sliver", 1e3, "sampled"), 0.1) << "one sample a pixel misses needles";
}

TEST(StressReasons, FacetsHurtMethodsThatMeasureAngles) {
    for (const char* method : {"mote4", "decaudin"}) {
        const double middle = error_of("facets", 128, method);
        EXPECT_GT(middle, error_of("facets", 32, method) + kWorse) << "steeper than a threshold";
        EXPECT_GT(middle, error_of("facets", 8192, method) + kWorse) << "flatter than one";
    }
    EXPECT_LT(error_of("facets", 128, "edge_hash"), 0.02) << "the mesh knows";
}

TEST(StressReasons, DepthOf16BitsHurtsMethodsThatTestLines) {
    constexpr double kInverseQ32 = 1, kInverseZ16 = 9;
    for (const char* method : {"back_faces", "polygon_offset"})
        EXPECT_GT(error_of("depth", kInverseZ16, method),
                  error_of("depth", kInverseQ32, method) + kWorse);
    EXPECT_NEAR(
        error_of("depth", kInverseZ16, "mote4"), error_of("depth", kInverseQ32, "mote4"), kSame);
}

TEST(StressReasons, FewBitsAreSpecksBelowAThreshold) {
    const double specks = error_of("code_bits", 6, "mote4");
    EXPECT_GT(specks, error_of("code_bits", 7, "mote4") + 0.1);
    EXPECT_LT(error_of("code_bits", 6, "mote4", {"threshold=9"}), specks - 0.1)
        << "a threshold above two rounded units leaves none";
}

TEST(StressReasons, SaturationLosesWhatWrappingKeeps) {
    const double fits = error_of("saturate", 1, "mote4");
    EXPECT_LT(error_of("saturate", 1.41, "mote4"), fits + kSame) << "few pixels are at the end";
    EXPECT_GT(error_of("saturate", 4, "mote4"), fits + 0.1);
    EXPECT_LT(error_of("wrap", 4, "mote4"), fits + kWorse);
    EXPECT_GT(error_of("wrap", 4, "mote2"), error_of("wrap", 4, "mote4") + 0.1)
        << "its one normal channel makes whole turns of its own";
}

TEST(StressReasons, DoubledFacesPairUpAgainOnceAllAreDoubled) {
    EXPECT_GT(error_of("duplicates", 40, "edge_list"), 0.3);
    EXPECT_NEAR(
        error_of("duplicates", 100, "edge_list"), error_of("duplicates", 0, "edge_list"), kSame);
    for (const char* method : {"edge_hash", "ids"})
        EXPECT_NEAR(error_of("duplicates", 40, method), error_of("duplicates", 0, method), kSame);
}

TEST(StressReasons, TJunctionsPartNeighboursAndShowNothing) {
    for (const char* method : {"edge_list", "edge_hash", "ids"})
        EXPECT_GT(error_of("t_junctions", 100, method), 0.4) << method;
    EXPECT_NEAR(
        error_of("t_junctions", 100, "back_faces"), error_of("t_junctions", 0, "back_faces"), kSame)
        << "it knows no neighbours, and sees no change";
}

TEST(StressReasons, CracksPartWhatIsNotWeldedWithATolerance) {
    const double welded = error_of("cracks", 40, "edge_hash");
    EXPECT_LT(welded, 0.02);
    EXPECT_GT(error_of("cracks", 40, "edge_hash", {"epsilon=0"}), 0.3);
    EXPECT_GT(error_of("cracks", 40, "ids", {"weld_epsilon=0"}), 0.3);
    EXPECT_NEAR(
        error_of("cracks", 100, "mote4"), error_of("cracks", 0, "mote4", {"normals=facet"}), 0.001)
        << "patches end at cracks: facets show";
}

TEST(StressReasons, TurnedFacesAgreeAgainOnceAllAreTurned) {
    for (const char* method : {"edge_list", "mote4"}) {
        EXPECT_GT(error_of("orientation", 40, method), 0.2) << method;
        EXPECT_NEAR(
            error_of("orientation", 100, method), error_of("orientation", 0, method), kSame);
    }
    for (const char* method : {"back_faces", "inverted_hull"})
        EXPECT_GT(error_of("orientation", 100, method), 0.5)
            << method << " takes insides for outsides";
}

TEST(StressReasons, LooseTrianglesAreWeldedWhereTheyAreEqual) {
    for (const char* method : {"mote4", "edge_list"})
        EXPECT_NEAR(error_of("soup", 40, method), error_of("soup", 0, method), 1e-9) << method;
    EXPECT_NEAR(
        error_of("soup", 40, "edge_hash", {"epsilon=0"}), error_of("soup", 0, "edge_hash"), 1e-9);
}

}  // namespace
}  // namespace ink::studies
