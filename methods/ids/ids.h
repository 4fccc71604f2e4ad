#pragma once

#include "buffers/id_method.h"

namespace ink::methods {

/// Borders between ids of objects, patches or triangles: a line wherever two neighbours differ, or
/// a pixel's four corners.
class Ids : public buffers::IdMethod {
  public:
    struct Params : buffers::IdParams {
        buffers::BorderSide side = buffers::BorderSide::nearer;
        int threshold = 128;  ///< it draws 0 and 255 alone
    };
    [[nodiscard]] static core::ParamTable<Params> table();

    explicit Ids(const Params& params);

    [[nodiscard]] method::Cost cost() const override;

  private:
    raster::SkipCounts draw_lines(const method::Frame& frame, edge::EdgeImage& out) override;

    Params params_;
};

[[nodiscard]] method::MethodInfo ids();

}  // namespace ink::methods
