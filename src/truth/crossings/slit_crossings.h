#pragma once

#include <vector>

#include "scene/topology.h"
#include "truth/continuation.h"
#include "truth/crossings/pierce.h"

namespace ink::truth {

/// Marks the crossings that are defects as a boundary is one (section 5 of the design) where the
/// image is too coarse to show them: two faces of one object that overlap by no more than its weld
/// tolerance where both have a border, as the pieces of a cracked surface do, and lie to different
/// sides of it, flatter than a crease. All of such a crossing lies within two tolerances of one
/// border of either face: `slit_world` is how far from the farther one. One that only ends at
/// borders runs through the faces and is left as it is.
void mark_slit_crossings(const scene::Topology& topology,
                         const ContinuationOptions& options,
                         std::vector<Crossing>& crossings);

}  // namespace ink::truth
