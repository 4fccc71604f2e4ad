#pragma once

#include <utility>

#include "method/method.h"

namespace ink::buffers {

/// A method that draws a scene's surface: all but what it makes of that.
///
/// `Pass` is a SurfacePass or what derives from one.
template <class Pass>
class SurfaceMethod : public method::Method {
  public:
    void prepare(const scene::PreparedScene& scene) override { pass_.prepare(scene); }
    void pose(const scene::PreparedScene& scene) override { pass_.pose(scene); }
    void draw(const method::Frame& frame, edge::EdgeImage& out) final {
        skip_counts_ = {};
        if (pass_.is_empty() || out.is_empty()) return out.fill(0);
        skip_counts_ = draw_lines(frame, out);
    }
    [[nodiscard]] int bytes_per_px() const override { return pass_.format().bytes_per_px(); }
    /// That of the pass and of filter_bytes().
    [[nodiscard]] method::Cost cost() const override {
        method::Cost cost = pass_.cost();
        cost.buffer_bytes_per_px = bytes_per_px();
        cost.filter = cost.filter + filter_bytes();
        return cost;
    }
    [[nodiscard]] raster::SkipCounts skip_counts() const final { return skip_counts_; }

  protected:
    template <class... Args>
    explicit SurfaceMethod(Args&&... args) : pass_(std::forward<Args>(args)...) {}

    /// Draws a frame and returns what was skipped. Neither scene nor image is empty.
    virtual raster::SkipCounts draw_lines(const method::Frame& frame, edge::EdgeImage& out) = 0;

    /// What is moved at each pixel of the frame once the pass has drawn it.
    [[nodiscard]] virtual method::PixelBytes filter_bytes() const { return {}; }

    [[nodiscard]] Pass& pass() { return pass_; }
    [[nodiscard]] const Pass& pass() const { return pass_; }

  private:
    Pass pass_;
    raster::SkipCounts skip_counts_{};
};

}  // namespace ink::buffers
