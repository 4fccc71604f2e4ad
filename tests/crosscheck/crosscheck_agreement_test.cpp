#include <fmt/format.h>

#include "catalogue/catalogue.h"
#include "core/kept_file.h"
#include "crosscheck/dense_sampling.h"
#include "harness/truths/compare_truths.h"
#include "import/import.h"
#include "tests/catalogue_names.h"
#include "tests/models/fetched_model.h"
#include "tests/truth/shapes.h"
#include "truth/model.h"

namespace ink::crosscheck {
namespace {

SamplingOptions two_threads() {
    SamplingOptions options;
    options.threads = 2;
    return options;
}

struct Both {
    const truth::Model* model = nullptr;
    std::vector<truth::Curve> curves;
    SampledLines crosscheck;
};

Both find_both(const truth::Model& model, const scene::View& view) {
    return {&model,
            truth::trace_truth(model, view, {.threads = 2, .layers = false}).curves,
            sample_lines(model.topology, view, two_threads())};
}

/// What is left of the disagreements once the third construction has judged them.
harness::Agreement judged(const Both& both, const scene::View& view) {
    harness::Agreement agreement = harness::compare_truths(both.curves, both.crosscheck, view);
    harness::judge_disagreements(both.model->topology, view, two_threads(), agreement);
    return agreement;
}

/// Expects 99.9 % both ways of every class, and abstentions on less than a share of the lines.
void expect_agreement_within(const Both& both, const scene::View& view, double most_abstained) {
    const harness::Agreement agreement = judged(both, view);
    EXPECT_LT(agreement.abstained_share(), most_abstained);
    for (std::size_t i = 0; i < truth::kLineClasses.size(); ++i) {
        const harness::ClassAgreement& c = agreement.by_class[i];
        EXPECT_TRUE(c.is_agreed()) << truth::name(truth::kLineClasses[i]) << ": " << c.truth_px
                                   << " px seen to " << c.truth_share() << ", " << c.crosscheck_px
                                   << " px traced to " << c.crosscheck_share();
    }
    EXPECT_EQ(both.crosscheck.counts.unexplained, 0U);
}

void expect_agreement(const Both& both, const scene::View& view) {
    expect_agreement_within(both, view, 0.001);
}

class CatalogueAgreement : public testing::TestWithParam<std::string> {};

TEST_P(CatalogueAgreement, TruthAndCrosscheckBothWays) {
    const scene::Scene scene = catalogue::make_catalogue_scene(GetParam());
    const truth::Model model = truth::build_model(scene, {.threads = 2});
    // Bars are .05 px wide at 1280x720. Between the two sides of such a one the third construction
    // may see less than the truth does.
    const bool has_bars = GetParam() == "bars";
    // Hair-thin gaps of a soup show as dots, of which there are fewer where pixels are finer.
    const bool is_fine = has_bars || GetParam() == "soup";
    for (const scene::Camera& camera : scene.cameras) {
        SCOPED_TRACE(camera.name);
        const scene::View view{camera, is_fine ? 1280 : 640, is_fine ? 720 : 360};
        expect_agreement_within(find_both(model, view), view, has_bars ? 0.002 : 0.001);
        if (&camera != &scene.cameras.front()) continue;
        SCOPED_TRACE("parallel");
        scene::View parallel = view;
        parallel.camera = scene::projected(
            scene::ProjectionKind::parallel, camera, scene::bounding_sphere(scene));
        expect_agreement_within(find_both(model, parallel), parallel, has_bars ? 0.002 : 0.001);
    }
}

INSTANTIATE_TEST_SUITE_P(SampledLines,
                         CatalogueAgreement,
                         testing::ValuesIn(light_scene_names_and_scan()),
                         [](const auto& test) { return test.param; });

/// Calls `check` with three views of a model, each traced and looked at.
template <class Check>
void for_views_of(const std::filesystem::path& path, const Check& check) {
    const scene::Scene scene = import::import_scene(path);
    const truth::Model model = truth::build_model(scene, {.threads = 2});
    for (const scene::Camera& camera :
         scene::orbit_cameras(scene::bounding_sphere(scene), 3, 640.0 / 360)) {
        SCOPED_TRACE(camera.name);
        const scene::View view{camera, 640, 360};
        check(find_both(model, view), view);
    }
}

std::string stem_of(const testing::TestParamInfo<const char*>& test) {
    const std::string file = test.param;
    return file.substr(0, file.find('.'));
}

class ModelAgreement : public testing::TestWithParam<const char*> {};

TEST_P(ModelAgreement, TruthAndCrosscheckBothWays) {
    const auto path = fetched_model(GetParam());
    INK_SKIP_WITHOUT(path);
    for_views_of(path, expect_agreement);
}

INSTANTIATE_TEST_SUITE_P(
    SampledLines,
    ModelAgreement,
    testing::Values("bunny_coarse.obj", "dragon_coarse.ply", "duck.glb", "spider.stl", "wuson.obj"),
    stem_of);

/// Models with surfaces that coincide but for rounding, folded slivers, faces nearly edge-on: the
/// truth has lines there that lie closer to each other than the cross-check's samples.
class ModelWithStrips : public testing::TestWithParam<const char*> {};

/// Expects 99.9 % both ways of all lines, and 98 % of every class, once the strips are taken out of
/// what the cross-check lacks. Where an edge lies in a face to within the last digits of its
/// floats, each has a bound of its own on what these may have done, and may call the line by
/// another class.
void expect_agreement_but_for_strips(const Both& both, const scene::View& view) {
    const harness::Agreement agreement = judged(both, view);
    for (std::size_t i = 0; i < truth::kLineClasses.size(); ++i) {
        harness::Agreement of_class = agreement;
        std::erase_if(of_class.disagreements, [&](const harness::Disagreement& d) {
            return d.line_class != truth::kLineClasses[i] || !d.is_confirmed;
        });
        harness::ClassAgreement c = agreement.by_class[i];
        c.truth_covered_px += harness::strip_length_px(both.curves, of_class);
        EXPECT_GE(std::min(c.truth_share(), c.crosscheck_share()), 0.98)
            << truth::name(truth::kLineClasses[i]) << ": " << c.truth_px << " px seen to "
            << c.truth_share() << ", " << c.crosscheck_px << " px traced to "
            << c.crosscheck_share();
    }
    harness::ClassAgreement all = agreement.total();
    all.truth_covered_px += harness::strip_length_px(both.curves, agreement);
    EXPECT_TRUE(all.is_agreed()) << all.truth_share() << ", " << all.crosscheck_share();
}

TEST_P(ModelWithStrips, TruthAndCrosscheckDifferByStripsAlone) {
    const auto path = fetched_model(GetParam());
    INK_SKIP_WITHOUT(path);
    for_views_of(path, expect_agreement_but_for_strips);
}

INSTANTIATE_TEST_SUITE_P(SampledLines,
                         ModelWithStrips,
                         testing::Values("penguin.obj", "gargoyle.obj", "aggressor.obj"),
                         stem_of);

/// A scene with contours, creases and a seam, traced and looked at; each fault is planted in the
/// curves alone.
class PlantedFault : public testing::Test {
  protected:
    void SetUp() override {
        const scene::Scene scene = catalogue::make_catalogue_scene("chess");
        model_ = truth::build_model(scene, {.threads = 2});
        view_ = {scene.cameras.front(), 640, 360};
        both_ = find_both(model_, view_);
        ASSERT_TRUE(judged(both_, view_).is_agreed());
    }
    [[nodiscard]] harness::ClassAgreement of(truth::LineClass c) const {
        const harness::Agreement agreement = judged(both_, view_);
        EXPECT_FALSE(agreement.is_agreed());
        const auto found = std::find(truth::kLineClasses.begin(), truth::kLineClasses.end(), c);
        return agreement.by_class[found - truth::kLineClasses.begin()];
    }

    scene::View view_;
    truth::Model model_;
    Both both_;
};

TEST(StripLength, CountsWhatRunsAlongsideAndNotWhatGoesOn) {
    const auto line = [](double x0, double x1, double y) {
        truth::Curve curve;
        curve.line_class = truth::LineClass::crease;
        curve.begin = {x0, y, 1};
        curve.end = {x1, y, 1};
        return curve;
    };
    // The second goes on from the first, the third runs beside the end of the second, the fourth is
    // twice too far off.
    const std::vector<truth::Curve> curves = {
        line(0, 10, 5), line(10, 20, 5), line(15, 30, 5 + 1.0 / 64), line(0, 10, 5 + 1.0 / 16)};
    const harness::Agreement nothing_seen =
        harness::compare_truths(curves, {}, truth::view_from(6));
    EXPECT_NEAR(harness::strip_length_px(curves, nothing_seen), 5 + 5, 0.25);
}

TEST_F(PlantedFault, EveryFiftiethContourEdgeDropped) {
    std::map<std::uint32_t, int> order;
    std::erase_if(both_.curves, [&](const truth::Curve& curve) {
        if (curve.line_class != truth::LineClass::contour) return false;
        const auto [edge, is_new] = order.try_emplace(curve.edge, static_cast<int>(order.size()));
        return edge->second % 50 == 49;
    });
    const harness::ClassAgreement contour = of(truth::LineClass::contour);
    EXPECT_LT(contour.crosscheck_share(), 0.999);
    EXPECT_GE(contour.truth_share(), 0.999);
    EXPECT_TRUE(of(truth::LineClass::crease).is_agreed());
}

TEST_F(PlantedFault, AllLinesMovedByHalfAPixel) {
    for (truth::Curve& curve : both_.curves) {
        curve.begin.x_px += 0.5;
        curve.end.x_px += 0.5;
    }
    for (const truth::LineClass c : {truth::LineClass::contour, truth::LineClass::crease}) {
        EXPECT_LT(of(c).crosscheck_share(), 0.999) << truth::name(c);
        EXPECT_LT(of(c).truth_share(), 0.999) << truth::name(c);
    }
}

TEST(Agreement, CountsWhatOneHasAndTheOtherNot) {
    // Two level lines of 8 px: one that the cross-check sees to its middle, one that it does not
    // see.
    truth::Curve seen, unseen;
    seen.line_class = unseen.line_class = truth::LineClass::crease;
    seen.begin = {10, 20.5, 1};
    seen.end = {18, 20.5, 1};
    unseen.begin = {10, 40.5, 1};
    unseen.end = {18, 40.5, 1};
    SampledLines crosscheck;
    for (int i = 0; i < 32; ++i)
        crosscheck.points.push_back({10 + (i + 0.5) / 8, 20.6, truth::LineClass::crease, 0.125});
    // And one of another class on the same line: no crease, and no curve.
    crosscheck.points.push_back({17, 20.5, truth::LineClass::seam, 0.125});
    const std::vector<truth::Curve> curves{seen, unseen};
    const harness::Agreement agreement =
        harness::compare_truths(curves, crosscheck, truth::view_from(6));
    const harness::ClassAgreement crease = agreement.by_class[2], seam = agreement.by_class[4];
    EXPECT_DOUBLE_EQ(crease.truth_px, 16);
    // Samples lie at 1/16, 3/16 ...; the last point at 13.9375 reaches 0.229 px on: one sample.
    EXPECT_DOUBLE_EQ(crease.truth_covered_px, 4.125);
    EXPECT_DOUBLE_EQ(crease.crosscheck_px, 4);
    EXPECT_DOUBLE_EQ(crease.crosscheck_share(), 1);
    EXPECT_DOUBLE_EQ(seam.crosscheck_share(), 0);
    EXPECT_DOUBLE_EQ(agreement.disagreement_rate(), (11.875 + 0.125) / (16 + 4.125));
    EXPECT_FALSE(crease.is_agreed());
    EXPECT_TRUE(seam.is_agreed()) << "a single crossing is no evidence";
}

TEST(Agreement, LeavesOutLinesOnTheFrame) {
    truth::Curve on_frame;
    on_frame.line_class = truth::LineClass::boundary;
    on_frame.begin = {0.25, 10, 1};
    on_frame.end = {0.25, 20, 1};
    SampledLines crosscheck;
    crosscheck.points.push_back({100, 0.25, truth::LineClass::crease, 0.125});
    const harness::Agreement agreement =
        harness::compare_truths(std::vector{on_frame}, crosscheck, truth::view_from(6));
    EXPECT_EQ(agreement.total().truth_px, 0);
    EXPECT_EQ(agreement.total().crosscheck_px, 0);
    EXPECT_TRUE(agreement.disagreements.empty());
}

TEST(Agreement, TheThirdConstructionDecidesWhoIsRight) {
    // A quad: one of its borders is missing from the curves, another from the cross-check, and
    // each has a line that is not there.
    scene::Mesh mesh;
    truth::add_quad(mesh, {-1, -1, 0}, {1, -1, 0}, {1, 1, 0}, {-1, 1, 0});
    const scene::Topology topology = scene::weld(truth::scene_of({mesh}));
    const scene::View view = truth::view_from(6);
    const auto line = [](glm::dvec2 a, glm::dvec2 b) {
        truth::Curve curve;
        curve.line_class = truth::LineClass::boundary;
        curve.begin = {a.x, a.y, 6};
        curve.end = {b.x, b.y, 6};
        return curve;
    };
    // 100 px a unit round (320, 240): left border and one that is not there.
    const std::vector curves{line({220, 140}, {220, 340}), line({300, 200}, {310, 200})};
    SampledLines crosscheck;
    for (int i = 0; i < 400; ++i)  // right border
        crosscheck.points.push_back({420, 140.25 + i * 0.5, truth::LineClass::boundary, 0.5});
    crosscheck.points.push_back({350, 200, truth::LineClass::boundary, 0.5});
    harness::Agreement agreement = harness::compare_truths(curves, crosscheck, view);
    EXPECT_DOUBLE_EQ(agreement.disagreement_rate(), 1);
    harness::judge_disagreements(topology, view, two_threads(), agreement);
    const harness::ClassAgreement boundary = agreement.by_class[1];
    EXPECT_NEAR(boundary.truth_abstained_px, 200, 0.5) << "the left border";
    EXPECT_DOUBLE_EQ(boundary.crosscheck_abstained_px, 0.5) << "its own invention";
    EXPECT_NEAR(agreement.disagreement_rate(), (10 + 200) / (210 + 200.5), 0.001);
    EXPECT_NEAR(agreement.abstained_share(), 200.5 / 410.5, 0.002);
    EXPECT_FALSE(agreement.is_agreed());
}

/// A fold, seen from within its plane of symmetry, and before one half of it a sheet whose border
/// lies right before the crease.
class CoincidentLines : public testing::Test {
  protected:
    void SetUp() override {
        scene::Mesh fold, sheet;
        truth::add_quad(fold, {-1, -1, -1}, {0, -1, 0}, {0, 1, 0}, {-1, 1, -1});
        truth::add_quad(fold, {0, -1, 0}, {1, -1, -1}, {1, 1, -1}, {0, 1, 0});
        truth::add_quad(sheet, {-2, -2, 1}, {0, -2, 1}, {0, 2, 1}, {-2, 2, 1});
        topology_ = scene::weld(truth::scene_of({fold, sheet}));
        for (std::uint32_t e = 0; e < topology_.edges.size(); ++e) {
            const auto& a = topology_.p_world[topology_.edges[e].a];
            const auto& b = topology_.p_world[topology_.edges[e].b];
            if (a.x != 0 || b.x != 0) continue;
            (a.z == 0 ? crease_ : border_) = e;
        }
        for (int i = 0; i < 80; ++i)
            seen_.points.push_back({320, 200.25 + i, truth::LineClass::boundary, 1});
        for (int i = 0; i < 320; ++i)
            seen_.points.push_back({320, 200.125 + i / 4.0, truth::LineClass::boundary, 0});
    }
    [[nodiscard]] truth::Curve line(truth::LineClass line_class, std::uint32_t edge) const {
        truth::Curve curve;
        curve.line_class = line_class;
        curve.edge = edge;
        curve.begin = {320, 200, 6};
        curve.end = {320, 280, 6};
        return curve;
    }
    [[nodiscard]] harness::Agreement judged(const std::vector<truth::Curve>& curves) const {
        const scene::View view = truth::view_from(6);
        harness::Agreement agreement = harness::compare_truths(curves, seen_, view);
        harness::judge_disagreements(topology_, view, two_threads(), agreement);
        return agreement;
    }

    scene::Topology topology_;
    std::uint32_t crease_ = 0, border_ = 0;
    SampledLines seen_;
};

TEST_F(CoincidentLines, EitherMayHaveAnyOfThem) {
    const truth::Curve border = line(truth::LineClass::boundary, border_);
    const truth::Curve crease = line(truth::LineClass::crease, crease_);
    EXPECT_TRUE(judged({border}).is_agreed());
    EXPECT_EQ(judged({border}).total().coincident_px, 0);
    const harness::Agreement both = judged({border, crease});
    EXPECT_TRUE(both.is_agreed());
    EXPECT_NEAR(both.by_class[2].coincident_px, 80, 0.5);
    EXPECT_EQ(both.by_class[1].coincident_px, 0);
}

TEST_F(CoincidentLines, FaultsBesideThemAreFaults) {
    const truth::Curve border = line(truth::LineClass::boundary, border_);
    EXPECT_FALSE(judged({}).is_agreed()) << "a line is missing";
    EXPECT_FALSE(judged({border, line(truth::LineClass::seam, crease_)}).is_agreed())
        << "of another class than its edge";
    truth::Curve moved = line(truth::LineClass::crease, crease_);
    moved.begin.x_px += 1.0 / 16;
    moved.end.x_px += 1.0 / 16;
    EXPECT_FALSE(judged({border, moved}).is_agreed()) << "1/16 px beside the other";
    EXPECT_FALSE(judged({line(truth::LineClass::crease, crease_)}).is_agreed())
        << "a crease where a border is seen";
}

TEST(CrosscheckFile, ComesBackWholeOrNotAtAll) {
    harness::Crosscheck check;
    check.agreement.by_class[1] = {10, 9.5, 11, 10.25, 0.25, 0.5};
    check.agreement.disagreements = {
        {1.5, 2.5, 0.125, truth::LineClass::boundary, false, 7, false}};
    check.counts.rays = 123;
    check.look_s = 0.5;
    const std::string bytes = harness::encode_check(check, "key");
    const auto back = harness::decode_check(bytes, "key");
    ASSERT_TRUE(back);
    EXPECT_EQ(back->agreement.by_class[1].crosscheck_covered_px, 10.25);
    EXPECT_EQ(back->agreement.by_class[1].crosscheck_abstained_px, 0.5);
    EXPECT_FALSE(back->agreement.disagreements[0].is_confirmed);
    ASSERT_EQ(back->agreement.disagreements.size(), 1U);
    EXPECT_EQ(back->agreement.disagreements[0].line_class, truth::LineClass::boundary);
    EXPECT_EQ(back->agreement.disagreements[0].curve, 7U);
    EXPECT_EQ(back->counts.rays, 123U);
    EXPECT_EQ(back->look_s, 0.5);
    EXPECT_FALSE(harness::decode_check(bytes, "yek"));
    EXPECT_FALSE(harness::decode_check(bytes.substr(0, bytes.size() - 1), "key"));
    std::string changed = bytes;
    changed.back() = static_cast<char>(changed.back() ^ 1);
    EXPECT_FALSE(harness::decode_check(changed, "key"));
}

TEST(CrosscheckFile, HoldsNoNumberThatIsNoneOfItsKind) {
    const harness::Disagreement sound{1.5, 2.5, 0.125, truth::LineClass::boundary, false, 7, false};
    const auto is_read = [](const harness::Disagreement& disagreement) {
        harness::Crosscheck check;
        check.agreement.disagreements = {disagreement};
        return harness::decode_check(harness::encode_check(check, "key"), "key").has_value();
    };
    EXPECT_TRUE(is_read(sound));
    harness::Disagreement no_class = sound;
    no_class.line_class = static_cast<truth::LineClass>(200);
    EXPECT_FALSE(is_read(no_class));
    // The last byte is `is_confirmed`: neither true nor false.
    harness::Crosscheck check;
    check.agreement.disagreements = {sound};
    const core::KeptKind kind = {'i', 'n', 'k', 'w', 'i', 't', 'n', '4'};
    const std::string bytes = harness::encode_check(check, "key");
    const auto payload = core::unsealed(bytes, kind, "key");
    ASSERT_TRUE(payload);
    std::string changed(reinterpret_cast<const char*>(payload->data()), payload->size());
    changed.back() = 2;
    EXPECT_FALSE(harness::decode_check(core::sealed(kind, "key", changed), "key"));
}

/// Two sheets of one object, flat or bent a little, whose borders lie 3e-5 apart: seven times the
/// weld tolerance, and 0.003 px.
scene::Scene two_sheets(float overlap, float slope) {
    scene::Mesh mesh;
    const float b = 0.5F * overlap;
    truth::add_quad(mesh, {-1, -1, -slope}, {b, -1, slope * b}, {b, 1, slope * b}, {-1, 1, -slope});
    truth::add_quad(mesh, {-b, -1, slope * b}, {1, -1, -slope}, {1, 1, -slope}, {-b, 1, slope * b});
    return truth::scene_of({mesh});
}

TEST(CrosscheckAgreement, SheetsThatGapeByMoreThanTheToleranceHaveBorders) {
    const truth::Model model = truth::build_model(two_sheets(-3e-5F, 0), {.threads = 2});
    const scene::View view = truth::view_from(6);
    const Both both = find_both(model, view);
    double inside_px = 0;
    for (const truth::Curve& curve : both.curves) {
        const bool is_inside =
            std::abs(curve.begin.x_px - 320) < 1 && std::abs(curve.end.x_px - 320) < 1;
        if (is_inside && curve.line_class == truth::LineClass::boundary)
            inside_px += truth::length_px(curve);
    }
    EXPECT_NEAR(inside_px, 400, 0.1) << "both borders of the gap";
    expect_agreement(both, view);
}

TEST(CrosscheckAgreement, SheetsThatOverlapByMoreThanTheToleranceCross) {
    const truth::Model model = truth::build_model(two_sheets(3e-5F, 0.1F), {.threads = 2});
    const scene::View view = truth::view_from(6);
    const Both both = find_both(model, view);
    expect_agreement_within(both, view, 1);
    const harness::Agreement agreement = judged(both, view);
    EXPECT_LT(agreement.disagreement_rate(), 1e-3);
}

}  // namespace
}  // namespace ink::crosscheck
