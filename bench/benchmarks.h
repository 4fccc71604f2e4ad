#pragma once

/// One function per room: it registers the room's benchmarks under the names that scripts look for.
///
/// Explicit, like the registry of methods; main.cpp calls them in the order in which tables show
/// them. Every benchmark checks its result before it is timed where there is something to check it
/// against, and carries a hash of it as its label.
namespace ink::bench {

void add_filter_benchmarks();
void add_raster_benchmarks();
void add_frame_benchmarks();
void add_truth_benchmarks();
void add_score_benchmarks();

}  // namespace ink::bench
