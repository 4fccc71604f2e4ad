#include "studies/motion_study.h"
#include "methods/antialias.h"
#include "methods/method_configs.h"

#include <gmock/gmock.h>

#include <stdexcept>

#include "catalogue/catalogue.h"
#include "harness/rows/row_table.h"

namespace ink::studies {
namespace {

using testing::HasSubstr;

/// Draws a line in every other frame; fails in the second if told so.
class Puppet final : public method::Method {
  public:
    explicit Puppet(bool fails) : fails_(fails) {}
    void prepare(const scene::PreparedScene&) override {}
    void pose(const scene::PreparedScene&) override {}
    void draw(const method::Frame&, edge::EdgeImage& out) override {
        if (fails_ && drawings_ > 0) throw std::runtime_error("out of ink");
        out.fill(0);
        // Far from the torus, outside the band.
        for (int y = 8; y < 20 && drawings_ % 2 == 0; ++y)
            out.at(9, y) = 255;
        ++drawings_;
    }
    int bytes_per_px() const override { return 1; }

  private:
    bool fails_;
    int drawings_ = 0;
};

method::MethodInfo puppet(const std::string& name, bool fails) {
    method::MethodInfo info;
    info.name = name;
    info.make = [fails](const core::ParamValues&) { return std::make_unique<Puppet>(fails); };
    info.complete = [](const core::ParamValues&) {
        return core::ParamValues{{"threshold", "100"}};
    };
    return info;
}

Sequence torus(int frames) {
    Sequence sequence;
    sequence.scene = catalogue::make_catalogue_scene("torus");
    const scene::View view{sequence.scene.cameras.front(), 160, 90};
    sequence.path =
        scene::make_path(scene::PathKind::orbit, view, scene::bounding_sphere(sequence.scene), 0.5);
    sequence.path.frame_count = frames;
    sequence.step_px = 0.5;
    return sequence;
}

TEST(StudySequence, ScoresEveryConfigAndTheBaselines) {
    const method::MethodInfo good = puppet("good", false);
    Sequence sequence = torus(5);
    const auto rows = study_sequence({{&good, {}}}, sequence, {});
    ASSERT_EQ(rows.size(), 4U);
    EXPECT_EQ(rows[0].method, "good");
    EXPECT_EQ(rows[0].params, "threshold=100");
    EXPECT_EQ(rows[0].scene, "torus");
    EXPECT_EQ(rows[0].view, "orbit");
    EXPECT_EQ(rows[0].frames, 5);
    // Twelve pixels, less what thinning takes, come and go in each of four steps: all of them.
    EXPECT_EQ(rows[0].flicker.share(), 1.0);
    EXPECT_EQ(rows[0].lives, (std::vector<std::int64_t>{3}));
    EXPECT_EQ(rows[0].lives_cut, 2);
    EXPECT_EQ(rows[1].method, "sampled");
    EXPECT_EQ(rows[2].method, "exact_corner");
    EXPECT_EQ(rows[3].method, "oracle");
    EXPECT_GT(rows[3].flicker.n_counted, 0);
    EXPECT_GT(rows[3].pops.steps, 0);
    EXPECT_TRUE(motion_faults(rows).empty());
}

TEST(StudySequence, AMethodThatFailsSaysSoAndTheOthersGoOn) {
    const method::MethodInfo bad = puppet("bad", true);
    const method::MethodInfo good = puppet("good", false);
    Sequence sequence = torus(3);
    const auto rows = study_sequence({{&bad, {}}, {&good, {}}}, sequence, {});
    ASSERT_EQ(rows.size(), 5U);
    EXPECT_THAT(rows[0].status, HasSubstr("out of ink"));
    EXPECT_TRUE(rows[1].is_ok());
}

TEST(StudySequence, ATruthThatIsTooLargeIsTheStatusOfAll) {
    const method::MethodInfo good = puppet("good", false);
    Sequence sequence = torus(3);
    harness::CellOptions options;
    options.trace.truth.limits.samples = 10;
    for (const MotionRow& row : study_sequence({{&good, {}}}, sequence, options))
        EXPECT_THAT(row.status, HasSubstr("too_large"));
}

TEST(StudySequence, PosesTheSceneForMethodsAndTruth) {
    const auto configs = methods::make_configs("mote4", {});
    Sequence still = torus(4);
    still.path.kind = scene::PathKind::still;
    Sequence moving = torus(4);
    moving.path.kind = scene::PathKind::still;
    moving.pose = [](scene::Scene& scene, double time_s) {
        scene.instances.front().world_from_object[3].x = 15 * time_s;  // 13 px a frame
    };
    const auto at_rest = study_sequence(configs, still, {});
    const auto moved = study_sequence(configs, moving, {});
    EXPECT_NE(moved[0].image_hash, at_rest[0].image_hash);
    EXPECT_NE(moved.back().image_hash, at_rest.back().image_hash) << "the oracle";
    EXPECT_EQ(at_rest[0].flicker.share(), 0.0);
    // Excused is what comes and goes with the truth: nothing would be if one of the two stood
    // still.
    EXPECT_GT(moved[0].flicker.excused, moved[0].flicker.n_counted / 5);
    EXPECT_TRUE(motion_faults(moved).empty());
}

TEST(StudySequence, InkChangesBesideThatOfTheTruth) {
    const auto configs = methods::at_each_antialias(
        methods::make_configs("strokes,surface_lookup", {}), {methods::Antialias::none}, 1);
    harness::CellOptions options;
    options.line_width_px = 1;  // as `strokes` draws them
    Sequence turning = torus(3);
    const auto rows = study_sequence(configs, turning, options);
    EXPECT_GT(rows[1].ink->beyond_px, rows[1].ink->true_px);
    EXPECT_LT(rows[0].ink->beyond_px, 0.5 * rows[0].ink->true_px) << "even of triangles of a pixel";
    EXPECT_GT(rows[0].soft->f().value(), rows[1].soft->f().value());
    const MotionRow& oracle = rows.back();
    EXPECT_GT(oracle.ink->true_px, 0);
    EXPECT_EQ(oracle.ink->beyond_px, 0);
    EXPECT_EQ(oracle.soft->f(), 1);
    Sequence still = torus(3);
    still.path.kind = scene::PathKind::still;
    for (const MotionRow& row : study_sequence(configs, still, options))
        EXPECT_EQ(row.ink, score::InkChange{}) << row.method;
    EXPECT_FALSE(study_sequence(configs, still, {}).front().ink);
}

TEST(StudySequences, ASceneGoesAlongAnyPath) {
    const Sequence bars = sequence_along(scene::PathKind::pan, "bars", {64, 36, 5, 0.125});
    EXPECT_EQ(bars.scene.name, "bars");
    EXPECT_EQ(bars.path.frame_count, 5);
    EXPECT_EQ(bars.step_px, 0.125);
    const Sequence study = study_sequences({64, 36, 5}).front();
    const Sequence along = sequence_along(study.path.kind, study.scene.name, {64, 36, 5});
    EXPECT_EQ(along.path.turn_rad, study.path.turn_rad);
}

TEST(StudySequences, TheGearsTurnBeforeACameraThatStands) {
    std::vector<Sequence> sequences = study_sequences({320, 180, 6});
    Sequence& gears = sequences.back();
    EXPECT_EQ(gears.scene.name, "gear");
    EXPECT_EQ(gears.path.kind, scene::PathKind::still);
    ASSERT_TRUE(gears.pose);
    const auto configs = methods::make_configs("mote4,edge_hash,polygon_offset,sobel", {});
    const auto turning = study_sequence(configs, gears, {});
    EXPECT_TRUE(motion_faults(turning).empty());
    // The same camera before gears that stand: nothing comes, nothing goes.
    std::vector<Sequence> again = study_sequences({320, 180, 6});
    again.back().pose = {};
    const auto standing = study_sequence(configs, again.back(), {});
    ASSERT_EQ(turning.size(), standing.size());
    for (std::size_t i = 0; i < turning.size(); ++i) {
        SCOPED_TRACE(turning[i].method);
        EXPECT_NE(turning[i].image_hash, standing[i].image_hash);
        EXPECT_EQ(standing[i].flicker.share(), 0.0);
        EXPECT_EQ(standing[i].flicker.excused, 0);
    }
    const MotionRow& oracle = turning.back();
    EXPECT_EQ(oracle.method, "oracle");
    EXPECT_EQ(oracle.flicker.share(), 0.0);
    EXPECT_EQ(oracle.pops.pops, 0);
    EXPECT_GT(oracle.pops.steps, 0);
    EXPECT_TRUE(oracle.lives.empty());
}

TEST(StudySequences, TheTruthIsPerfectOnAllAndThreadsChangeNothing) {
    harness::CellOptions options;
    const auto configs = methods::make_configs("mote4", {});
    for (Sequence& sequence : study_sequences({160, 90, 3})) {
        SCOPED_TRACE(sequence.scene.name);
        options.measure.threads = 1;
        std::vector<MotionRow> rows = study_sequence(configs, sequence, options);
        EXPECT_TRUE(motion_faults(rows).empty());
        options.measure.threads = 3;
        std::vector<MotionRow> again = study_sequence(configs, sequence, options);
        for (MotionRow& row : again)
            row.threads = 1;
        ASSERT_EQ(again.size(), rows.size());
        for (std::size_t i = 0; i < rows.size(); ++i) {
            EXPECT_EQ(motion_table().line(1, again[i]), motion_table().line(1, rows[i]));
            EXPECT_EQ(life_lines(1, again[i]), life_lines(1, rows[i]));
            EXPECT_EQ(harness::row_line(1, harness::Study::motion, again[i]),
                      harness::row_line(1, harness::Study::motion, rows[i]));
        }
    }
}

}  // namespace
}  // namespace ink::studies
