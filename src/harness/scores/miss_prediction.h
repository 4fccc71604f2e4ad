#pragma once

#include <optional>
#include <vector>

#include "harness/truths/tracing.h"
#include "harness/truths/truth_code.h"
#include "method/method.h"
#include "scene/prepared_scene.h"
#include "score/attribution.h"

namespace ink::harness {

/// The stencils of a view's truth, borrowed from it.
[[nodiscard]] score::TruthStencils stencils_of(const ViewTruth& truth);

/// What a method says of itself: its code, if it declares one, and the edge response from which on
/// a pixel is a line.
struct Declaration {
    std::optional<method::LinearCode> code;
    int threshold = 128;
};

/// Predicts from truth geometry and a declared code alone (never from a method's image) why a
/// line was missed.
///
/// Keeps a scene's surface for each kind of normals that codes ask for. Borrows the scene. Several
/// threads may ask it.
class MissPredictor {
  public:
    explicit MissPredictor(const scene::Scene& scene) : scene_(scene) {}

    /// One cause for each of `false_negatives`: of the stencils that see its line
    /// (score::seeing_stencils),
    /// - `unexplained` if the code, rounded and limited as declared, reaches the threshold in one;
    /// - else `cancelled` if one of its four channels would do so alone;
    /// - else `below_threshold`, also where there is no such stencil.
    ///
    /// Saturation and wrapping count as cancelling. Stencils that the frame cuts are left out.
    ///
    /// Empty if there is no code.
    [[nodiscard]] std::vector<score::Cause> predict(
        const std::vector<score::Pixel>& false_negatives,
        const ViewTruth& truth,
        const scene::View& view,
        const Declaration& declared);

    /// Every wrong pixel of an image of `view` with its cause (score::attribute), misses as
    /// predicted.
    [[nodiscard]] score::Attribution attribute(const score::WrongPixels& wrong,
                                               const ViewTruth& truth,
                                               const scene::View& view,
                                               const Declaration& declared);

    /// `code` worked out from the truth of `view`; borrows `code` and this.
    [[nodiscard]] TruthCode code_of(const method::LinearCode& code, const scene::View& view);

  private:
    scene::PreparedScene scene_;  ///< keeps all surfaces
};

}  // namespace ink::harness
