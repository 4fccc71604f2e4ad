#pragma once

namespace ink::bench {

/// Gives the calling thread one core and the workers of oneTBB another, so that `threads:1` is
/// timed on one core and `threads:2` on two without `taskset`. Call it first in main.
///
/// Takes the last of the cores that the process was given, and for the workers the last that is not
/// the same core's other hardware thread; threads made later inherit from the one that makes them.
/// Where that cannot be had (one core only, a refusal, not Linux) it says so on stderr and goes on.
void pin_to_cores();

}  // namespace ink::bench
