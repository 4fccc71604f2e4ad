#pragma once

#include <cstdint>
#include <glm/vec3.hpp>
#include <memory>
#include <span>
#include <unordered_map>
#include <vector>

#include "buffers/hidden_lines.h"
#include "scene/mesh.h"
#include "scene/prepared_scene.h"

namespace ink::methods {

/// A face at an edge.
struct EdgeFace {
    std::uint32_t face = 0;
    std::uint32_t opposite = 0;  ///< the place of the face that is not on the edge
    std::int8_t direction = 0;   ///< 1 if the face runs from a to b, -1 from b to a
};

/// An edge between two places, a < b.
struct SoupEdge {
    std::uint32_t a = 0;
    std::uint32_t b = 0;
    std::uint32_t first = 0;  ///< into SoupEdges::faces_at
    std::uint32_t count = 0;  ///< faces: 1 boundary, 2, or more
};

/// The adjacency of one frame of a model, rebuilt from loose polygons: TechnicalQuake's edge hash.
struct SoupEdges {
    std::vector<std::uint32_t> vertex_of;  ///< per place the vertex that says where it is
    std::vector<scene::Triangle> faces;    ///< over places
    std::vector<SoupEdge> edges;
    std::vector<EdgeFace> faces_at;  ///< grouped by edge

    [[nodiscard]] std::span<const EdgeFace> faces_of(const SoupEdge& edge) const {
        return {faces_at.data() + edge.first, edge.count};
    }
};

/// Loose polygons: what a frame of a model is. Borrowed.
struct Soup {
    std::span<const glm::dvec3> points;  ///< per vertex
    std::span<const scene::Triangle> triangles;
};

/// Welds the vertices that lie within `epsilon` diagonals of their box of each other, drops faces
/// without an area and faces that are there twice, and enters every side of the rest into a hash of
/// edges. Epsilon 0 welds equal positions. O(n) expected; no triangles give no edges.
[[nodiscard]] SoupEdges find_edges(const Soup& soup, double epsilon);

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

    /// The edges of what a model of `scene` is now, built if this frame of it is not there.
    [[nodiscard]] std::shared_ptr<const SoupEdges> edges_of(std::size_t model,
                                                            const Soup& soup,
                                                            const scene::PreparedScene& scene);

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

/// What is looked up together: the key's first level.
enum class ModelScope {
    object,  ///< each mesh is a model
    scene,   ///< the whole scene is one, as it stands
};

/// The edges of a scene's models in their frames, where they are, and what each is from an eye.
///
/// Which side of an edge a face is on is asked for each face by itself, exactly, so that mixed
/// orientation does no harm. An edge is a contour if its faces are all on one side; a crease if the
/// two that are seen, the nearest on each side, bend by at least `crease_rad`.
class SoupModels {
  public:
    struct Options {
        ModelScope scope = ModelScope::object;
        double epsilon = 0;           ///< of the weld, diagonals of the model's box
        std::size_t most_frames = 1;  ///< kept of each model
        double crease_rad = 0;
    };
    explicit SoupModels(const Options& options)
        : options_(options), cache_(options.epsilon, options.most_frames) {}

    /// Empties the cache and makes a place in it for each model; edges come with the first frame.
    void prepare(const scene::Scene& scene);
    /// Finds each model's frame, or builds it; world positions, creases.
    void pose(const scene::PreparedScene& scene);

    /// The edges that are a line for an eye at `eye`, in no order that matters.
    [[nodiscard]] std::vector<buffers::KnownEdge> lines(const scene::Viewpoint& eye) const;

    [[nodiscard]] const EdgeCacheCounts& cache_counts() const { return cache_.counts(); }

  private:
    /// A model where one of its objects stands.
    struct Placed {
        std::shared_ptr<const SoupEdges> soup;
        std::vector<glm::dvec3> p_world;
        std::vector<std::uint8_t> is_crease;  ///< per edge of two faces; 0 for the others
    };

    void pose_objects(const scene::PreparedScene& scene);
    void find_creases(Placed& placed) const;
    [[nodiscard]] bool bends(const Placed& placed,
                             const SoupEdge& edge,
                             const EdgeFace& face0,
                             const EdgeFace& face1) const;
    [[nodiscard]] buffers::EdgeKind kind_of(const Placed& placed,
                                            std::size_t edge,
                                            const std::vector<std::int8_t>& facings,
                                            const scene::Viewpoint& eye) const;

    Options options_;
    EdgeCache cache_;
    std::vector<Placed> placed_;
};

}  // namespace ink::methods
