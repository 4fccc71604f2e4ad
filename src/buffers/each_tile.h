#pragma once

#include <utility>

#include "raster/pass/pass.h"

namespace ink::buffers {

/// A sink that calls a function with each finished tile, from several threads.
template <class Finish>
class EachTile : public raster::TileSink {
  public:
    explicit EachTile(Finish finish) : finish_(std::move(finish)) {}
    void finish(const raster::Tile& tile) override { finish_(tile); }

  private:
    Finish finish_;
};

}  // namespace ink::buffers
