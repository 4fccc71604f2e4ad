#pragma once

#include "buffers/full_buffers.h"

namespace ink::methods {

/// Saito and Takahashi's edges of G-buffers: a first-order differential whose spread makes
/// profiles, and a second-order one for edges within them.
class Sobel : public method::Method {
  public:
    enum class Order {
        first,   ///< profiles alone
        second,  ///< internal edges alone
        both,    ///< the stronger of the two
    };
    struct Params : buffers::InputParams {
        Order order = Order::second;
        bool uses_normals = true;
        double sky = -1;
        // found: ODS over the training scenes at 1280x720, `inkbench compare`; see the page
        double k_first = 0.02;
        double k_second = 0.02;
        double k_normal = 1;
        int threshold = 57;
    };
    [[nodiscard]] static core::ParamTable<Params> table();

    explicit Sobel(const Params& params);

    void prepare(const scene::Scene& scene) override { buffers_.prepare(scene); }
    void pose(const scene::Scene& scene) override { buffers_.pose(scene); }
    void draw(const method::Frame& frame, edge::EdgeImage& out) override;
    /// `depth` and `normal`, see FullBuffers.
    [[nodiscard]] std::vector<method::Layer> layers(const method::Frame& frame) override {
        return buffers_.layers(frame);
    }
    [[nodiscard]] int bytes_per_px() const override { return buffers_.format().bytes_per_px(); }
    [[nodiscard]] method::Cost cost() const override;
    [[nodiscard]] raster::SkipCounts skip_counts() const override { return skip_counts_; }

  private:
    Params params_;
    buffers::FullBuffers buffers_;
    raster::SkipCounts skip_counts_{};
};

[[nodiscard]] method::MethodInfo sobel();

}  // namespace ink::methods
