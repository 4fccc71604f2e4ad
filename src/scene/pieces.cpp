#include "scene/pieces.h"

#include <algorithm>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <limits>
#include <numeric>

#include "scene/predicates.h"

namespace ink::scene {
namespace {

class Groups {
  public:
    explicit Groups(std::size_t count) : parent_(count) {
        std::iota(parent_.begin(), parent_.end(), 0U);
    }
    std::uint32_t root(std::uint32_t i) {
        while (parent_[i] != i)
            i = parent_[i] = parent_[parent_[i]];
        return i;
    }
    void join(std::uint32_t a, std::uint32_t b) { parent_[root(b)] = root(a); }

  private:
    std::vector<std::uint32_t> parent_;
};

/// What a piece is judged by.
struct Tally {
    double six_volumes = 0;
    std::size_t edges = 0;
    std::size_t vertices = 0;
    bool is_bent_inwards = false;
};

bool runs_forward(const Face& face, const Edge& edge) {
    for (std::size_t i = 0; i < 3; ++i) {
        if (face.vertices[i] == edge.a && face.vertices[(i + 1) % 3] == edge.b) return true;
    }
    return false;
}

/// Whether the second face of the edge rises before the first.
bool is_concave(const Topology& topology, const Edge& edge) {
    const auto faces = topology.faces_of(edge);
    if (bend_rad(topology, edge, faces[0], faces[1]) < kFlat_rad) return false;
    const Face& face = topology.faces[faces[0]];
    const Face& other = topology.faces[faces[1]];
    const auto& p = topology.p_world;
    for (const std::uint32_t v : other.vertices) {
        if (v == edge.a || v == edge.b) continue;
        return facing(p[face.vertices[0]], p[face.vertices[1]], p[face.vertices[2]], p[v]) > 0;
    }
    return false;
}

/// The piece of each face, numbered in the order of first faces.
std::vector<std::uint32_t> number_faces(const Topology& topology) {
    Groups groups(topology.faces.size());
    for (const Edge& edge : topology.edges) {
        const auto faces = topology.faces_of(edge);
        for (const std::uint32_t face : faces)
            groups.join(faces[0], face);
    }
    constexpr std::uint32_t kNone = std::numeric_limits<std::uint32_t>::max();
    std::vector<std::uint32_t> number(topology.faces.size(), kNone);
    std::vector<std::uint32_t> piece_of(topology.faces.size());
    std::uint32_t next = 0;
    for (std::uint32_t f = 0; f < topology.faces.size(); ++f) {
        std::uint32_t& of_root = number[groups.root(f)];
        if (of_root == kNone) of_root = next++;
        piece_of[f] = of_root;
    }
    return piece_of;
}

void add_face(const Topology& topology, const Face& face, Piece& piece, Tally& tally) {
    for (const std::uint32_t v : face.vertices) {
        piece.low_world = glm::min(piece.low_world, topology.p_world[v]);
        piece.high_world = glm::max(piece.high_world, topology.p_world[v]);
    }
    ++piece.faces;
    // Seen from a point nearby, so that a small piece far from the origin keeps its volume's sign.
    const glm::dvec3 origin = topology.p_world[topology.faces.front().vertices[0]];
    const auto& [a, b, c] = face.vertices;
    tally.six_volumes +=
        glm::dot(topology.p_world[a] - origin,
                 glm::cross(topology.p_world[b] - origin, topology.p_world[c] - origin));
}

/// Widens the ball round a piece whose box is known.
void reach(const Topology& topology, const Face& face, Piece& piece) {
    const glm::dvec3 centre = (piece.low_world + piece.high_world) * 0.5;
    for (const std::uint32_t v : face.vertices)
        piece.radius = std::max(piece.radius, glm::length(topology.p_world[v] - centre));
}

void add_edge(const Topology& topology, const Edge& edge, Piece& piece, Tally& tally) {
    ++tally.edges;
    piece.is_closed = piece.is_closed && edge.face_count == 2;
    if (edge.face_count != 2) return;
    const auto faces = topology.faces_of(edge);
    const bool is_opposite = runs_forward(topology.faces[faces[0]], edge) !=
                             runs_forward(topology.faces[faces[1]], edge);
    piece.is_consistent = piece.is_consistent && is_opposite;
    // One is enough, and the question is the dearest.
    tally.is_bent_inwards = tally.is_bent_inwards || is_concave(topology, edge);
}

/// Each vertex counts for every piece that it belongs to.
void count_vertices(const Topology& topology,
                    const std::vector<std::uint32_t>& piece_of,
                    std::vector<Tally>& tallies) {
    std::vector<std::pair<std::uint32_t, std::uint32_t>> uses;
    uses.reserve(3 * topology.faces.size());
    for (std::size_t f = 0; f < topology.faces.size(); ++f) {
        for (const std::uint32_t v : topology.faces[f].vertices)
            uses.emplace_back(v, piece_of[f]);
    }
    std::sort(uses.begin(), uses.end());
    uses.erase(std::unique(uses.begin(), uses.end()), uses.end());
    for (const auto& [vertex, piece] : uses)
        ++tallies[piece].vertices;
}

bool have_common_room(const Piece& a, const Piece& b) {
    const glm::dvec3 apart = (a.low_world + a.high_world - b.low_world - b.high_world) * 0.5;
    if (glm::length(apart) >= a.radius + b.radius) return false;
    for (int axis = 0; axis < 3; ++axis) {
        const double low = std::max(a.low_world[axis], b.low_world[axis]);
        const double high = std::min(a.high_world[axis], b.high_world[axis]);
        if (low > high) return false;
        if (low < high) continue;
        // Touching is no crossing, unless a flat piece stands within the other.
        const auto stands_within = [&](const Piece& flat, const Piece& other) {
            return flat.low_world[axis] == flat.high_world[axis] && other.low_world[axis] < low &&
                   other.high_world[axis] > high;
        };
        if (!stands_within(a, b) && !stands_within(b, a)) return false;
    }
    return true;
}

}  // namespace

Pieces find_pieces(const Topology& topology) {
    Pieces found{{}, number_faces(topology)};
    const std::vector<std::uint32_t>& piece_of = found.piece_of;
    const std::size_t count =
        piece_of.empty() ? 0 : 1 + *std::max_element(piece_of.begin(), piece_of.end());
    constexpr double kInfinity = std::numeric_limits<double>::infinity();
    const Piece blank{.faces = 0,
                      .low_world = glm::dvec3(kInfinity),
                      .high_world = glm::dvec3(-kInfinity),
                      .is_closed = true,
                      .is_consistent = true};
    std::vector<Piece>& pieces = found.pieces;
    pieces.assign(count, blank);
    std::vector<Tally> tallies(count);
    for (std::size_t f = 0; f < topology.faces.size(); ++f) {
        add_face(topology, topology.faces[f], pieces[piece_of[f]], tallies[piece_of[f]]);
    }
    for (std::size_t f = 0; f < topology.faces.size(); ++f)
        reach(topology, topology.faces[f], pieces[piece_of[f]]);
    for (const Edge& edge : topology.edges) {
        const std::uint32_t piece = piece_of[topology.faces_of(edge)[0]];
        add_edge(topology, edge, pieces[piece], tallies[piece]);
    }
    count_vertices(topology, piece_of, tallies);
    for (std::size_t i = 0; i < count; ++i) {
        Piece& piece = pieces[i];
        const Tally& tally = tallies[i];
        piece.is_sealed = piece.is_closed && piece.is_consistent && tally.six_volumes > 0;
        const bool is_ball = tally.vertices + piece.faces == tally.edges + 2;
        piece.is_convex = piece.is_sealed && is_ball && !tally.is_bent_inwards;
    }
    return found;
}

std::size_t count_overlapping_pieces(const std::vector<Piece>& pieces, std::size_t most) {
    if (pieces.empty()) return 0;
    glm::dvec3 low = pieces.front().low_world, high = pieces.front().high_world;
    std::vector<const Piece*> sorted;
    for (const Piece& piece : pieces) {
        low = glm::min(low, piece.low_world);
        high = glm::max(high, piece.high_world);
        sorted.push_back(&piece);
    }
    // Swept along the longest way, on which the fewest boxes stand side by side.
    const glm::dvec3 size = high - low;
    const int axis = size.x >= size.y && size.x >= size.z ? 0 : (size.y >= size.z ? 1 : 2);
    std::sort(sorted.begin(), sorted.end(), [axis](const Piece* a, const Piece* b) {
        return a->low_world[axis] < b->low_world[axis];
    });
    std::size_t pairs = 0;
    for (std::size_t i = 0; i < sorted.size(); ++i) {
        for (std::size_t j = i + 1; j < sorted.size(); ++j) {
            if (sorted[j]->low_world[axis] > sorted[i]->high_world[axis]) break;
            pairs += have_common_room(*sorted[i], *sorted[j]);
            if (pairs == most) return pairs;
        }
    }
    return pairs;
}

}  // namespace ink::scene
