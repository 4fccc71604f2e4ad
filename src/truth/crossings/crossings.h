#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "scene/topology.h"
#include "truth/crossings/pierce.h"

namespace ink::truth {

/// Where the triangles of a scene meet other than at the edges and vertices they share.
struct Crossings {
    std::vector<Crossing> segments;      ///< sorted by (face0, face1)
    std::vector<Contact> contacts;       ///< sorted by edge, then t_begin, then face
    std::vector<CoplanarPair> coplanar;  ///< sorted by (face, lower_face)
    std::size_t pairs_tested = 0;        ///< pairs of triangles whose boxes touch
    bool is_too_many = false;            ///< the search was given up; then the lists are empty and
                                         ///< pairs_tested is the budget

    /// The contacts of one mesh edge.
    [[nodiscard]] std::span<const Contact> contacts_of(std::uint32_t edge) const;
    /// The coplanar pairs in which a face is the higher.
    [[nodiscard]] std::span<const CoplanarPair> coplanar_with(std::uint32_t face) const;
};

/// When to give the search up, and how to run it. Real scenes stay far below both budgets (the
/// worst model at hand has 3 million pairs and 40 thousand segments); a heap of long needles, in
/// which everything crosses everything, does not.
struct CrossingOptions {
    int threads = 1;
    std::size_t most_pairs = 200'000'000;  ///< of touching boxes: half a minute's work
    std::size_t most_found = 8'000'000;    ///< segments and contacts: a gigabyte
};

/// Finds every segment in which two triangles cross, every contact of an edge with a face it does
/// not belong to, and every pair of triangles that overlap in one plane.
///
/// A tree over the triangles' boxes (pair_tree.h) offers pairs; the planes and sides of both, in
/// double with a bound on its error, drop nearly all of them, and what is left is decided exactly
/// (pierce.h). The same for every thread count; says nothing about any eye.
///
/// O(n log n) plus the pairs whose boxes touch.
[[nodiscard]] Crossings find_crossings(const scene::Topology& topology,
                                       const CrossingOptions& options);

struct Continuation;

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
