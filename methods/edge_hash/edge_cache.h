#pragma once

#include <cstdint>
#include <memory>
#include <unordered_map>
#include <vector>

#include "methods/edge_hash/soup_edges.h"

namespace ink::methods {

/// What the cache did since it was made.
struct EdgeCacheCounts {
    std::uint64_t built = 0;    ///< frames whose edges were looked for
    std::uint64_t found = 0;    ///< frames that were there already
    std::uint64_t dropped = 0;  ///< frames thrown out for room
};

/// Edges by model, frame and edge, kept from frame to frame: TechnicalQuake's three levels.
///
/// A frame of a model is known by its vertices' positions, so it is found again whenever the
/// animation comes back to it, whatever its number.
class EdgeCache {
  public:
    /// Keeps at most `most_frames` (>= 1) of each model; the one that was not asked for the longest
    /// goes first.
    EdgeCache(double epsilon, std::size_t most_frames)
        : epsilon_(epsilon), most_frames_(most_frames) {}

    /// Forgets everything; there will be so many models.
    void reset(std::size_t models);

    /// The edges of what a model is now, built if this frame of it is not there.
    [[nodiscard]] std::shared_ptr<const SoupEdges> edges_of(std::size_t model, const Soup& soup);

    [[nodiscard]] const EdgeCacheCounts& counts() const { return counts_; }

  private:
    struct Frame {
        std::shared_ptr<const SoupEdges> edges;
        std::uint64_t last_asked = 0;
    };
    using Model = std::unordered_map<std::uint64_t, Frame>;  ///< by the hash of its positions

    void make_room(Model& model);

    double epsilon_;
    std::size_t most_frames_;
    std::vector<Model> models_;
    std::uint64_t asked_ = 0;
    EdgeCacheCounts counts_;
};

}  // namespace ink::methods
