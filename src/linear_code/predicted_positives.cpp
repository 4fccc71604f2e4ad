#include "linear_code/predicted_positives.h"

#include <cassert>
#include <limits>

#include "edge/laplacian.h"

namespace ink::linear_code {
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

}  // namespace

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

}  // namespace ink::linear_code
