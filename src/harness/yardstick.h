#pragma once

#include <cstdint>

#include "core/image.h"

namespace ink::harness {

/// A fixed piece of work that is timed between drawings: times of two runs are compared by their
/// ratios to it, whatever the machine, and whatever else it did.
///
/// One pass of a four-neighbour filter over a plane of 1280x720 bytes, about 0.2 ms. It is no
/// method's code, so that nobody who speeds one up changes it.
class Yardstick {
  public:
    Yardstick();
    void work();

  private:
    core::Image<std::uint8_t> from_;
    core::Image<std::uint8_t> to_;
};

}  // namespace ink::harness
