#include "harness/scores/miss_prediction.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "edge/laplacian.h"
#include "harness/cells/cell.h"

namespace ink::harness {
namespace {

/// What the filter would make of one stencil.
struct Response {
    bool of_sum = false;      ///< the code itself reaches the threshold
    bool of_channel = false;  ///< one channel alone would
};

class Filter {
  public:
    Filter(const TruthCode& code, const truth::Layers& layers, const Declaration& declared)
        : code_(code),
          layers_(layers),
          response_(declared.code->response),
          threshold_(declared.threshold) {}

    [[nodiscard]] Response at(score::Pixel p) const {
        const PixelCode middle = code_at(p.x_px, p.y_px);
        std::array<double, 4> channels{};
        for (std::size_t k = 0; k < channels.size(); ++k)
            channels[k] = 4 * middle.channels[k];
        int sum = 4 * middle.code;
        for (const auto& [x, y] : {std::pair(p.x_px - 1, p.y_px),
                                   {p.x_px + 1, p.y_px},
                                   {p.x_px, p.y_px - 1},
                                   {p.x_px, p.y_px + 1}}) {
            const PixelCode neighbour = code_at(x, y);
            sum -= neighbour.code;
            for (std::size_t k = 0; k < channels.size(); ++k)
                channels[k] -= neighbour.channels[k];
        }
        const bool of_channel = std::any_of(channels.begin(), channels.end(), [&](double change) {
            return fires(static_cast<int>(std::lround(std::clamp(change, -kMost, kMost))));
        });
        return {fires(sum), of_channel};
    }

  private:
    static constexpr double kMost = 4 * 65535;  // what respond() takes

    [[nodiscard]] PixelCode code_at(int x, int y) const {
        return code_.at(x, y, layers_.triangle.at(x, y));
    }
    [[nodiscard]] bool fires(int laplacian) const {
        return edge::respond(laplacian, response_) >= threshold_;
    }

    const TruthCode& code_;
    const truth::Layers& layers_;
    edge::LaplacianResponse response_;
    int threshold_;
};

score::Cause cause_at(const std::vector<score::Pixel>& seeing,
                      const core::Image<std::uint32_t>& triangle,
                      const Filter& filter) {
    bool has_channel = false;
    for (const score::Pixel p : seeing) {
        const bool is_cut = p.x_px == 0 || p.y_px == 0 || p.x_px == triangle.width_px() - 1 ||
                            p.y_px == triangle.height_px() - 1;
        if (is_cut) continue;
        const Response response = filter.at(p);
        if (response.of_sum) return score::Cause::unexplained;
        has_channel = has_channel || response.of_channel;
    }
    return has_channel ? score::Cause::cancelled : score::Cause::below_threshold;
}

}  // namespace

score::TruthStencils stencils_of(const ViewTruth& truth) {
    return {.triangle = truth.traced.layers.triangle,
            .patch = truth.traced.layers.patch,
            .cracks = truth.cracks,
            .labels = truth.traced.labels};
}

TruthCode MissPredictor::code_of(const method::LinearCode& code, const scene::View& view) {
    const scene::PreparedScene scene = scene_.shared();
    const auto surface = scene.surface(code.inputs.normals, code.inputs.crease_rad);
    return {*surface, scene.bounds(), view, code};
}

std::vector<score::Cause> MissPredictor::predict(const std::vector<score::Pixel>& false_negatives,
                                                 const ViewTruth& truth,
                                                 const scene::View& view,
                                                 const Declaration& declared) {
    if (false_negatives.empty() || !declared.code) return {};
    const TruthCode code = code_of(*declared.code, view);
    const Filter filter(code, truth.traced.layers, declared);
    const score::TruthStencils stencils = stencils_of(truth);
    std::vector<score::Cause> causes;
    causes.reserve(false_negatives.size());
    for (const score::Pixel pixel : false_negatives) {
        causes.push_back(cause_at(
            score::seeing_stencils(stencils, pixel), truth.traced.layers.triangle, filter));
    }
    return causes;
}

score::Attribution MissPredictor::attribute(const score::WrongPixels& wrong,
                                            const ViewTruth& truth,
                                            const scene::View& view,
                                            const Declaration& declared) {
    return score::attribute(wrong,
                            stencils_of(truth),
                            predict(wrong.false_negatives, truth, view, declared),
                            score_options(declared.threshold));
}

}  // namespace ink::harness
