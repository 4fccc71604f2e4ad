#include "linear_code/cancellation.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <glm/trigonometric.hpp>
#include <limits>
#include <map>
#include <numbers>
#include <utility>

#include "core/parallel.h"
#include "edge/bit_mask.h"
#include "edge/edge_image.h"
#include "edge/laplacian.h"
#include "edge/thin.h"
#include "harness/cells/cell.h"
#include "harness/truths/truth_code.h"
#include "score/attribution.h"
#include "score/drawing.h"
#include "truth/label_image.h"

namespace ink::linear_code {
namespace {

using CancellationTable = harness::SideTable<CancellationRow>;

void add_kind(CancellationTable& table) {
    const auto kind = table.part(&CancellationRow::kind);
    kind.add_derived({"class", "", "of line: contour, boundary, crease, intersection, seam"},
                     [](const LineKind& of) { return truth::name(of.line_class); });
    kind.add(
        {"dihedral_low_deg", "deg", "dihedral deviation of the two faces at which the bin begins"},
        &LineKind::dihedral_low_deg);
    kind.add_derived({"dihedral_high_deg", "deg", "at which the bin ends"}, [](const LineKind& of) {
        const auto low = of.dihedral_low_deg;
        return low ? std::optional(*low + kDihedralBin_deg) : std::nullopt;
    });
}

/// Right angles of turned boxes come out a little under 90 as often as over it.
constexpr double kRounding_deg = 0.01;

int bin_low_deg(double deviation_rad) {
    constexpr int kLast_deg = 180 - kDihedralBin_deg;
    const double deviation_deg = deviation_rad * 180 / std::numbers::pi;
    const int low =
        static_cast<int>((deviation_deg + kRounding_deg) / kDihedralBin_deg) * kDihedralBin_deg;
    return std::clamp(low, 0, kLast_deg);
}

LineKind kind_of(const truth::Curve& curve) {
    if (curve.line_class == truth::LineClass::boundary) return {curve.line_class, std::nullopt};
    return {curve.line_class, bin_low_deg(curve.deviation_rad)};
}

}  // namespace

const CancellationTable& cancellation_table() {
    static const CancellationTable kTable = [] {
        CancellationTable table("cancellation.csv",
                                "A line per cell of a method with a declared code, class of line "
                                "and dihedral: how much "
                                "is lost because changes of channels cancel, as predicted and as "
                                "measured, within 2 px.");
        table.add({"silent_deg", "deg", "the dihedral up to which the code is silent"},
                  &CancellationRow::silent_deg);
        add_kind(table);
        using C = CancellationCount;
        const auto count = table.part(&CancellationRow::count);
        count.add({"n_truth", "px", "true pixels of the kind"}, &C::n_truth);
        count.add({"predicted_missed", "px", "of them without a match, as predicted"},
                  &C::predicted_missed);
        count.add({"measured_missed", "px", "of them without a match"}, &C::measured_missed);
        count.add(
            {"predicted_false_negatives", "px", "of them with nothing in reach, as predicted"},
            &C::predicted_false_negatives);
        count.add({"measured_false_negatives", "px", "of them with nothing drawn in reach"},
                  &C::measured_false_negatives);
        count.add({"both_false_negatives", "px", "of them both"}, &C::both_false_negatives);
        return table;
    }();
    return kTable;
}

namespace {

/// The codes of a view's pixels, each worked out once: stencils along a line share most of theirs.
class CodePlane {
  public:
    CodePlane(const harness::TruthCode& code, const core::Image<std::uint32_t>& triangle)
        : code_(code),
          triangle_(triangle),
          codes_(triangle.width_px(), triangle.height_px(), kUnknown) {}

    /// 4 codes(x, y) - its four neighbours, which lie on the image.
    [[nodiscard]] int laplacian(int x, int y) {
        return 4 * at(x, y) - at(x - 1, y) - at(x + 1, y) - at(x, y - 1) - at(x, y + 1);
    }

  private:
    static constexpr int kUnknown = std::numeric_limits<int>::min();

    [[nodiscard]] int at(int x, int y) {
        int& code = codes_.at(x, y);
        if (code == kUnknown) code = code_.at(x, y, triangle_.at(x, y)).code;
        return code;
    }

    const harness::TruthCode& code_;
    const core::Image<std::uint32_t>& triangle_;
    core::Image<int> codes_;
};

/// The pixels round which a four-neighbour stencil sees a true line (score::sees_line) and that
/// have four neighbours, row by row: the same for every code.
std::vector<score::Pixel> line_stencils(const score::TruthStencils& stencils) {
    const truth::Cracks& cracks = stencils.cracks;
    std::vector<score::Pixel> seeing;
    for (int y = 1; y + 1 < stencils.triangle.height_px(); ++y) {
        const std::uint8_t* right = cracks.right.row(y);
        const std::uint8_t* above = cracks.below.row(y - 1);
        const std::uint8_t* below = cracks.below.row(y);
        for (int x = 1; x + 1 < stencils.triangle.width_px(); ++x) {
            // Most pixels have no crack round them, which is soon told.
            if ((right[x - 1] | right[x] | above[x] | below[x]) == 0) continue;
            if (score::sees_line(stencils, {x, y})) seeing.push_back({x, y});
        }
    }
    return seeing;
}

/// Which pixels a declared code draws along the true lines of a view: 1 where the four-neighbour
/// stencil round a pixel sees a line (score::sees_line) and the filter's response to it reaches the
/// threshold; not thinned, of the view's size.
///
/// From the truth's geometry and the declared code alone, never from a method's image. What each
/// pixel centre sees is the truth's. So a crease has what it has on a real image: one to three
/// neighbours on its other side, the kink that 1/w has there instead of a jump, and codes that are
/// rounded. Stencils that the frame cuts, and those that no line crosses, draw nothing.
///
/// `triangle` is the truth's layer, `seeing` its line_stencils(); `declared` has a code: the one
/// that `code` was made of.
edge::Mask predicted_positives(const harness::TruthCode& code,
                               const core::Image<std::uint32_t>& triangle,
                               const std::vector<score::Pixel>& seeing,
                               const harness::Declaration& declared) {
    assert(declared.code);
    CodePlane codes(code, triangle);
    edge::Mask positives(triangle.width_px(), triangle.height_px());
    for (const auto& [x, y] : seeing) {
        const int edge_response = edge::respond(codes.laplacian(x, y), declared.code->response);
        positives.at(x, y) = edge_response >= declared.threshold ? 1 : 0;
    }
    return positives;
}

/// An evaluation with a code, the code worked out from the truth, and what came of both.
struct CancellationOf {
    std::size_t place;
    const harness::Evaluation& evaluation;
    harness::Declaration declared;
    harness::TruthCode code;
    std::vector<CancellationRow> rows = {};
};

/// What all evaluations of a view are counted against.
struct CountedTruth {
    std::vector<score::Pixel> seeing;  ///< line_stencils()
    std::vector<KindPixels> kinds;
    score::TruthLists lists;
};

void fill_rows(const harness::ViewTruth& truth,
               const CountedTruth& counted,
               CancellationOf& study) {
    const harness::Evaluation& evaluation = study.evaluation;
    const auto ink_of = [&](const edge::Mask& drawn) {
        edge::BitMask thinned(drawn);
        edge::thin(thinned);
        return CountedInk(score::counted_pixels(std::move(thinned), counted.lists),
                          counted.lists.disk);
    };
    CountedInk predicted = ink_of(predicted_positives(
        study.code, truth.traced.layers.triangle, counted.seeing, study.declared));
    CountedInk measured = ink_of(edge::threshold(evaluation.image, evaluation.threshold));
    const double silent_deg =
        glm::degrees(silent_deviation_rad(*study.declared.code, study.declared.threshold));
    for (const auto& [kind, pixels] : counted.kinds) {
        study.rows.push_back(
            {study.place, silent_deg, kind, count_cancellation(pixels, predicted, measured)});
    }
}

}  // namespace

std::vector<CancellationRow> study_cancellation(
    const harness::ViewTruth& truth,
    const scene::View& view,
    harness::MissPredictor& predictor,
    const std::vector<harness::Evaluation>& evaluations) {
    std::vector<CancellationOf> studies;
    studies.reserve(evaluations.size());
    for (std::size_t i = 0; i < evaluations.size(); ++i) {
        const harness::Evaluation& evaluation = evaluations[i];
        if (!evaluation.row.is_ok() || !evaluation.code) continue;
        studies.push_back({i,
                           evaluation,
                           {evaluation.code, evaluation.threshold},
                           predictor.code_of(*evaluation.code, view)});
    }
    if (studies.empty()) return {};
    const CountedTruth counted{line_stencils(harness::stencils_of(truth)),
                               sort_by_kind(truth.traced, truth.scoring),
                               score::list_truth(truth.scoring, harness::score_options(255))};
    core::parallel_for(studies.size(), core::hardware_threads(), [&](std::size_t i) {
        fill_rows(truth, counted, studies[i]);
    });
    std::vector<CancellationRow> rows;
    for (CancellationOf& study : studies)
        rows.insert(rows.end(), study.rows.begin(), study.rows.end());
    return rows;
}

std::optional<int> threshold_in_codes(const edge::LaplacianResponse& response, int edge_response) {
    for (int laplacian = 0; laplacian <= 4 * 65535; ++laplacian) {
        if (edge::respond(laplacian, response) >= edge_response) return laplacian;
        if (edge::respond(-laplacian, response) >= edge_response) return laplacian;
    }
    return std::nullopt;
}

double silent_deviation_rad(const method::LinearCode& code, int threshold) {
    double square = 0;
    for (const double weight : code.normal_weight)
        square += weight * weight;
    const auto least = threshold_in_codes(code.response, threshold);
    const double seen_twice = 2 * std::sqrt(square);
    if (!least || *least >= seen_twice) return std::numbers::pi;
    return 2 * std::asin(*least / seen_twice);
}

std::vector<KindPixels> sort_by_kind(const truth::Truth& traced,
                                     const score::ScoringTruth& scoring) {
    const int width = scoring.labels.width_px(), height = scoring.labels.height_px();
    const auto curve_at = truth::draw_curve_map(traced.curves, width, height);
    std::map<LineKind, std::vector<score::Pixel>> kinds;
    for (int y = 0; y < height; ++y) {
        for (int x = 0; x < width; ++x) {
            if (scoring.labels.at(x, y) == 0 || curve_at.at(x, y) == truth::kNoCurve) continue;
            kinds[kind_of(traced.curves[curve_at.at(x, y)])].push_back({x, y});
        }
    }
    std::vector<KindPixels> sorted;
    core::Image<std::uint8_t> mask(width, height);
    for (const auto& [kind, pixels] : kinds) {
        for (const auto& [x, y] : pixels)
            mask.at(x, y) = 1;
        sorted.push_back({kind, score::PixelList(mask)});
        for (const auto& [x, y] : pixels)
            mask.at(x, y) = 0;
    }
    return sorted;
}

CancellationCount count_cancellation(const score::PixelList& kind,
                                     CountedInk& predicted,
                                     CountedInk& measured) {
    CancellationCount count;
    count.n_truth = static_cast<std::int64_t>(kind.size());
    count.predicted_missed = count.n_truth - predicted.match(kind);
    count.measured_missed = count.n_truth - measured.match(kind);
    kind.visit([&](int x, int y) {
        const bool is_predicted = predicted.is_near(x, y);
        const bool is_measured = measured.is_near(x, y);
        count.predicted_false_negatives += is_predicted ? 0 : 1;
        count.measured_false_negatives += is_measured ? 0 : 1;
        count.both_false_negatives += is_predicted || is_measured ? 0 : 1;
    });
    return count;
}

}  // namespace ink::linear_code
