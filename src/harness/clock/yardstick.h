#pragma once

#include <cstdint>

#include "core/image.h"

namespace ink::harness {

/// A fixed piece of work that is timed between drawings: times of two runs are compared by their
/// ratios to it, whatever the machine, and whatever else it did.
///
/// Sixteen passes of a four-neighbour filter over a plane of 320x180 bytes, as many pixels as a
/// 720p frame has, about 0.1 ms. The plane stays in the core's own cache: over a whole frame the
/// filter felt loads that methods do not feel, which draw tile by tile. It is no method's code, so
/// that nobody who speeds one up changes it.
class Yardstick {
  public:
    Yardstick();
    void work();

  private:
    void filter();

    core::Image<std::uint8_t> from_;
    core::Image<std::uint8_t> to_;
};

}  // namespace ink::harness
