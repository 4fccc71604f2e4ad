#pragma once

#include <vector>

#include "buffers/id_pass.h"

namespace ink::buffers {

/// A method that draws its lines from ids: all but what it makes of them.
///
/// The shell of ids, ids_depth, jump_flood and blurred_silhouette.
class IdMethod : public method::Method {
  public:
    void prepare(const scene::Scene& scene) override { pass_.prepare(scene); }
    [[nodiscard]] bool prepare_like(const method::Method& other,
                                    const scene::Scene& scene) override {
        const auto* same = dynamic_cast<const IdMethod*>(&other);
        return same != nullptr && pass_.prepare_like(same->pass_, scene);
    }
    void pose(const scene::Scene& scene) override { pass_.pose(scene); }
    void draw(const method::Frame& frame, edge::EdgeImage& out) override {
        skip_counts_ = {};
        if (pass_.is_empty() || out.is_empty()) return out.fill(0);
        skip_counts_ = draw_lines(frame, out);
    }
    /// `ids`, see IdPass.
    [[nodiscard]] std::vector<method::Layer> layers(const method::Frame& frame) override {
        return {pass_.layer(frame)};
    }
    [[nodiscard]] int bytes_per_px() const override { return pass_.format().bytes_per_px(); }
    [[nodiscard]] raster::SkipCounts skip_counts() const override { return skip_counts_; }

  protected:
    /// Tiles have `halo_px` pixels beyond their own.
    IdMethod(const IdParams& params, int halo_px) : pass_(params, halo_px) {}

    /// Draws a frame and returns what was skipped. Neither scene nor image is empty.
    virtual raster::SkipCounts draw_lines(const method::Frame& frame, edge::EdgeImage& out) = 0;

    [[nodiscard]] IdPass& pass() { return pass_; }
    [[nodiscard]] const IdPass& pass() const { return pass_; }

  private:
    IdPass pass_;
    raster::SkipCounts skip_counts_{};
};

}  // namespace ink::buffers
