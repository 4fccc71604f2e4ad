#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include "harness/evaluations.h"
#include "harness/view_images.h"

namespace ink::experiment {

/// What the methods drew of a view, and have inside if that is kept.
struct DrawnMethods {
    std::vector<harness::Evaluation> evaluations = {};
    std::vector<harness::MethodLayers> layers = {};
};

/// A view that all methods are to draw.
struct AskedView {
    const scene::View* view = nullptr;
    int threads = 1;
    bool keeps_layers = false;
    friend bool operator==(const AskedView&, const AskedView&) = default;
};

/// Views of one scene that will be asked for, and what was drawn of them before they were.
///
/// Methods of a large mesh are made ready a few at a time. Where several views are to come, it is
/// done once for all of them.
class DrawnAhead {
  public:
    /// A view that is sure to be asked for, later than those expected before.
    void expect(const AskedView& asked) { expected_.push_back({asked, std::nullopt}); }
    /// What was drawn of a view; nothing if it was not. The view is no longer expected.
    [[nodiscard]] std::optional<DrawnMethods> take(const AskedView& asked);
    /// Expected views of which nothing is drawn, of the size of `asked`; at most so many.
    [[nodiscard]] std::vector<AskedView> to_draw(const AskedView& asked, std::size_t most) const;
    /// Keeps what was drawn of an expected view.
    void keep(const AskedView& asked, DrawnMethods drawn);

  private:
    struct Expected {
        AskedView asked;
        std::optional<DrawnMethods> drawn;
    };
    std::vector<Expected> expected_;
};

}  // namespace ink::experiment
