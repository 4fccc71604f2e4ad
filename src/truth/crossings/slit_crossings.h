#pragma once

#include <span>
#include <vector>

#include "scene/topology.h"
#include "truth/crossings/continuation.h"
#include "truth/crossings/pierce.h"

namespace ink::truth {

/// Marks the crossings that are defects as a boundary is one (section 5 of the design) where the
/// image is too coarse to show them: two faces of one object cross within two of its weld
/// tolerances of a border of either, beyond which the surface goes on (continuation.h), as the
/// pieces of a cracked surface do that overlap. `slit_world` is how far from that border. A
/// crossing that does so along a part of it, for pieces gape and overlap by more and less, is split
/// there. One that only ends at borders runs through the faces and is left as it is.
///
/// `continuations` are those of the topology; `tolerances` has one entry per object.
void mark_slit_crossings(const scene::Topology& topology,
                         std::span<const Continuation> continuations,
                         std::span<const double> tolerances,
                         std::vector<Crossing>& crossings);

}  // namespace ink::truth
