#pragma once

#include <vector>

#include "scene/topology.h"
#include "truth/continuation.h"
#include "truth/pierce.h"

namespace ink::truth {

/// Takes out the crossings that are defects as a boundary is one (section 5 of the design): two
/// faces of one object, flatter than a crease, that overlap by no more than the weld tolerance
/// where both have their borders, as the pieces of a cracked surface do. Either end of such a
/// crossing lies within two tolerances of a border of either face. The others keep their order.
void drop_slit_crossings(const scene::Topology& topology,
                         const ContinuationOptions& options,
                         std::vector<Crossing>& crossings);

}  // namespace ink::truth
