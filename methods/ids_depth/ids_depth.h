#pragma once

#include "buffers/id_method.h"

namespace ink::methods {

/// Borders between surface ids, and steps of depth within one id: what outline passes of engines
/// and of three.js draw where they have an id buffer.
class IdsDepth : public buffers::IdMethod {
  public:
    struct Params : buffers::IdParams {
        buffers::BorderSide side = buffers::BorderSide::nearer;
        double depth_step = 0.05;  // found: see the page
        int threshold = 128;       ///< it draws 0 and 255 alone
    };
    [[nodiscard]] static core::ParamTable<Params> table();

    explicit IdsDepth(const Params& params);

    [[nodiscard]] method::Cost cost() const override;

  private:
    raster::SkipCounts draw_lines(const method::Frame& frame, edge::EdgeImage& out) override;

    Params params_;
};

[[nodiscard]] method::MethodInfo ids_depth();

}  // namespace ink::methods
