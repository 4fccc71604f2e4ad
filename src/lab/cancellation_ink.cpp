#include "lab/cancellation_ink.h"

#include <cassert>
#include <limits>

#include "edge/laplacian.h"

namespace ink::lab {
namespace {

/// The codes of a view's pixels, each worked out once: stencils along a line share most of theirs.
class CodePlane {
  public:
    CodePlane(const TruthCode& code, const core::Image<std::uint32_t>& triangle)
        : code_(code),
          triangle_(triangle),
          codes_(triangle.width_px(), triangle.height_px(), kUnknown) {}

    /// 4 codes(x, y) - its four neighbours, which lie on the picture.
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

    const TruthCode& code_;
    const core::Image<std::uint32_t>& triangle_;
    core::Image<int> codes_;
};

}  // namespace

edge::Mask predicted_ink(const TruthCode& code,
                         const ViewTruth& truth,
                         const Declaration& declared) {
    assert(declared.code);
    const score::TruthStencils stencils = stencils_of(truth);
    CodePlane codes(code, stencils.triangle);
    const int width = stencils.triangle.width_px(), height = stencils.triangle.height_px();
    edge::Mask ink(width, height);
    for (int y = 1; y + 1 < height; ++y) {
        for (int x = 1; x + 1 < width; ++x) {
            if (!score::sees_line(stencils, {x, y})) continue;
            const int strength = edge::respond(codes.laplacian(x, y), declared.code->response);
            ink.at(x, y) = strength >= declared.threshold ? 1 : 0;
        }
    }
    return ink;
}

}  // namespace ink::lab
