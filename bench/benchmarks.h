#pragma once

/// One function per room: it registers the room's benchmarks under the names that scripts look for.
///
/// Explicit, like the registry of methods; main.cpp calls them in the order in which tables show
/// them. Every benchmark checks its result before it is timed where there is something to check it
/// against, and carries a hash of it as its label: a run whose repetitions differ there fails.
namespace ink::bench {

void add_filter_benchmarks();
/// Passes and frames are run exactly `draws` times a repetition; 0 lets the library choose.
void add_raster_benchmarks(int draws);
void add_frame_benchmarks(int draws);
/// Builders of edge lists, and what a cache of edges saves.
void add_edge_benchmarks();
void add_embree_benchmarks();
void add_truth_benchmarks();
void add_score_benchmarks();

}  // namespace ink::bench
