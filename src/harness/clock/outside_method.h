#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <optional>

#include "harness/clock/timing.h"
#include "method/method.h"

namespace ink::harness {

/// An image that was drawn elsewhere, and how long that took.
struct OutsideImage {
    edge::EdgeImage image;
    std::optional<std::int64_t> draw_ns = {};  ///< by its own clock
    std::optional<core::Spent> process = {};   ///< of the program that drew it, from start to end
};

/// Gives the image of a view; throws core::Error where there is none, or not the right one.
using OutsideSource = std::function<OutsideImage(const scene::Scene&, const scene::View&)>;

/// A method whose images come from outside: from a folder, or from another program.
///
/// It is drawn once a view: its time is what it says itself, else that of its process. A source may
/// be called for the same view again.
class OutsideMethod : public method::Method {
  public:
    explicit OutsideMethod(OutsideSource source) : source_(std::move(source)) {}

    void prepare(const scene::PreparedScene& scene) override { pose(scene); }
    void pose(const scene::PreparedScene& scene) override {
        const scene::Scene& of = scene;
        scene_ = &of;
    }
    /// Throws core::Error as the source does.
    void draw(const method::Frame& frame, edge::EdgeImage& out) override {
        OutsideImage drawn = source_(*scene_, frame.view);
        out = std::move(drawn.image);
        times_ = {};
        if (drawn.draw_ns) {
            times_.clock = kOwnClock;
            times_.draws = {{*drawn.draw_ns, 0}};
        } else if (drawn.process) {
            times_.clock = kChildrenClock;
            times_.draws = {*drawn.process};
        }
    }
    [[nodiscard]] int bytes_per_px() const override { return 0; }
    /// What the last draw took; without draws where nobody says.
    [[nodiscard]] const DrawTimes& times() const { return times_; }

  private:
    OutsideSource source_;
    const scene::Scene* scene_ = nullptr;
    DrawTimes times_;
};

}  // namespace ink::harness
