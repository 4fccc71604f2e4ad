#include "score/cracks.h"

#include "edge/set_pixels.h"
#include "score/drawing.h"

namespace ink::score {
namespace {

/// The four neighbours of a pixel, and whether a crack lies between.
class Neighbourhood {
  public:
    Neighbourhood(const truth::Cracks& cracks, const edge::Mask& ignore)
        : cracks_(cracks), ignore_(ignore) {}

    [[nodiscard]] bool has_crack(int x, int y) const {
        return cracks_.right.at(x, y) != 0 || cracks_.below.at(x, y) != 0 ||
               (x > 0 && cracks_.right.at(x - 1, y) != 0) ||
               (y > 0 && cracks_.below.at(x, y - 1) != 0);
    }
    [[nodiscard]] bool touches_ignore(int x, int y) const {
        return is_ignored(x - 1, y) || is_ignored(x + 1, y) || is_ignored(x, y - 1) ||
               is_ignored(x, y + 1);
    }
    [[nodiscard]] bool is_ignored(int x, int y) const {
        return ignore_.contains(x, y) && ignore_.at(x, y) != 0;
    }
    [[nodiscard]] std::uint8_t verdict(int x, int y) const {
        if (is_ignored(x, y)) return CrackTruth::kLeftOut;
        if (has_crack(x, y)) return CrackTruth::kBeside;
        return touches_ignore(x, y) ? CrackTruth::kLeftOut : CrackTruth::kFalse;
    }

  private:
    const truth::Cracks& cracks_;
    const edge::Mask& ignore_;
};

/// The cracks of one direction whose pixels both count; `step` is from the one to the other.
void list_cracks(const core::Image<std::uint8_t>& labels,
                 const edge::Mask& counts,
                 std::uint32_t step,
                 std::vector<CrackTruth::Crack>& out) {
    edge::visit_set_pixels(labels, [&](int x, int y) {
        const auto pixel = static_cast<std::uint32_t>(y * labels.width_px() + x);
        if (counts.data()[pixel] == 0 || counts.data()[pixel + step] == 0) return;
        out.push_back({pixel, pixel + step, labels.at(x, y)});
    });
}

}  // namespace

std::optional<double> CrackScore::precision() const {
    if (n_drawn == 0) return std::nullopt;
    return static_cast<double>(n_beside) / static_cast<double>(n_drawn);
}

std::optional<double> CrackScore::recall() const {
    if (all.n_truth == 0) return std::nullopt;
    return static_cast<double>(all.n_found) / static_cast<double>(all.n_truth);
}

double CrackScore::f() const {
    const auto p = precision(), r = recall();
    if (!p && !r) return 1;
    if (!p || !r || *p + *r == 0) return 0;
    return 2 * *p * *r / (*p + *r);
}

CrackTruth prepare_cracks(const truth::Cracks& cracks,
                          const ScoringTruth& truth,
                          const ScoreOptions& options) {
    check(options);
    check_same_size(cracks.right, truth.labels);
    const int width = truth.labels.width_px(), height = truth.labels.height_px();
    const Neighbourhood neighbourhood(cracks, truth.ignore);
    CrackTruth ready;
    ready.verdict = core::Image<std::uint8_t>(width, height);
    edge::Mask counts(width, height, 1);
    clear_band(counts, options.band_px);
    for (int y = 0; y < height; ++y) {
        for (int x = 0; x < width; ++x) {
            if (counts.at(x, y) != 0) ready.verdict.at(x, y) = neighbourhood.verdict(x, y);
            if (truth.ignore.at(x, y) != 0) counts.at(x, y) = 0;
        }
    }
    list_cracks(cracks.right, counts, 1, ready.cracks);
    list_cracks(cracks.below, counts, static_cast<std::uint32_t>(width), ready.cracks);
    return ready;
}

CrackScore score_cracks(const edge::Mask& drawn, const CrackTruth& truth) {
    check_same_size(drawn, truth.verdict);
    CrackScore score;
    edge::visit_set_pixels(drawn, [&](int x, int y) {
        const std::uint8_t verdict = truth.verdict.at(x, y);
        score.n_drawn += verdict != CrackTruth::kLeftOut;
        score.n_beside += verdict == CrackTruth::kBeside;
    });
    for (const CrackTruth::Crack& crack : truth.cracks) {
        const bool is_found = drawn.data()[crack.pixel] != 0 || drawn.data()[crack.other] != 0;
        CrackCount& of_class = score.classes[crack.label & 7U];
        ++of_class.n_truth;
        of_class.n_found += is_found;
        score.all.n_found += is_found;
    }
    score.all.n_truth = static_cast<std::int64_t>(truth.cracks.size());
    return score;
}

}  // namespace ink::score
