#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <optional>

#include "method/method.h"

namespace ink::harness {

/// An image that was drawn elsewhere, and how long that took by its own clock.
struct OutsideImage {
    edge::EdgeImage image;
    std::optional<std::int64_t> draw_ns = {};
};

/// Gives the image of a view; throws core::Error where there is none, or not the right one.
using OutsideSource = std::function<OutsideImage(const scene::Scene&, const scene::View&)>;

/// A method whose images come from outside: from a folder, or from another program.
///
/// It is drawn once a view and never timed here: its time is what it says itself. A source may be
/// called for the same view again.
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
        draw_ns_ = drawn.draw_ns;
    }
    [[nodiscard]] int bytes_per_px() const override { return 0; }
    /// What the last draw took by the method's own clock; nothing where it does not say.
    [[nodiscard]] std::optional<std::int64_t> draw_ns() const { return draw_ns_; }

  private:
    OutsideSource source_;
    const scene::Scene* scene_ = nullptr;
    std::optional<std::int64_t> draw_ns_;
};

}  // namespace ink::harness
