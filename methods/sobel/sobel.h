#pragma once

#include "buffers/full_buffer_method.h"

namespace ink::methods {

/// Saito and Takahashi's edges of G-buffers: a first-order differential whose spread makes
/// profiles, and a second-order one for edges within them.
class Sobel : public buffers::FullBufferMethod {
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
        // found: experiments/thresholds.py, over the training scenes at 1280x720; see the page
        double k_first = 0.02;
        double k_second = 0.02;
        double k_normal = 1;
        int threshold = 57;
    };
    [[nodiscard]] static core::ParamTable<Params> table();

    explicit Sobel(const Params& params);

  private:
    void filter(const buffers::FullBufferFrame& frame,
                const raster::Tile& tile,
                edge::EdgeImage& out) const override;
    [[nodiscard]] method::PixelWork filter_work() const override;
    void add_channel(const raster::Tile& tile,
                     const buffers::TilePlane& plane,
                     double k_first,
                     double k_second,
                     buffers::TileFloats& joined) const;

    Params params_;
};

[[nodiscard]] method::MethodInfo sobel();

}  // namespace ink::methods
