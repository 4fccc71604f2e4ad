#pragma once

#include <cstdint>

#include "core/image.h"

namespace ink::harness {

/// A fixed piece of work that is timed between drawings: what the machine's speed does to a drawing
/// it does to the yardstick beside it, and times of two runs are compared by their ratios to it.
///
/// Two kinds of work, since a busy neighbour on the same core slows them unequally, and drawings
/// lie between: ten passes of a four-neighbour filter over 320x180 bytes, which fill the core, are
/// slowed most; a chain of numbers each of which waits for the one before is slowed least. Seven
/// tenths and three tenths of about 0.16 ms: with these, times held best (bench/README.md). The
/// plane stays in the core's own cache: over a whole frame the filter felt loads that methods do
/// not feel, which draw tile by tile. It is no method's code, so that nobody who speeds one up
/// changes it.
class Yardstick {
  public:
    Yardstick();
    void work();

  private:
    void filter();
    void chain();

    core::Image<std::uint8_t> from_;
    core::Image<std::uint8_t> to_;
    float link_ = 0.3F;
    std::uint32_t steps_up_ = 0;
};

}  // namespace ink::harness
