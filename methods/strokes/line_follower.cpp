#include "methods/strokes/line_follower.h"

#include <cmath>
#include <glm/geometric.hpp>

namespace ink::methods {
namespace {

glm::ivec2 cell_beyond(const glm::ivec2& cell, int side) {
    static constexpr std::array<glm::ivec2, 4> kSteps = {{{0, -1}, {1, 0}, {0, 1}, {-1, 0}}};
    return cell + kSteps[static_cast<std::size_t>(side)];
}

}  // namespace

void LineFollower::draw(
    LineKind kind, const glm::dvec2& a, double qa, const glm::dvec2& b, double qb) {
    const Piece piece{a, b, frame_.widths.half_px(kind, qa), frame_.widths.half_px(kind, qb)};
    if (piece.half_a_px > 0 || piece.half_b_px > 0) pieces_.push_back(piece);
}

void LineFollower::go_on(const Line& line, glm::ivec2 at, LineEnd end, int most_cells) {
    const glm::dvec2 way = line.segment.b - line.segment.a;
    const double length = glm::length(way);
    if (!(length > 0)) return;
    for (int step = 0; step < most_cells; ++step) {
        at = cell_beyond(at, end.side);
        const auto part = clip_to_cell(line.segment, at);
        if (!frame_.sides.is_cell(at.x, at.y) || !part) return;
        const Cell cell = frame_.cell(at);
        const double t_end = glm::dot(end.at - line.segment.a, way) / (length * length);
        const bool is_up = std::abs(part->to - t_end) > std::abs(part->from - t_end);
        const double t = is_up ? part->to : part->from;
        if (std::abs(t - t_end) * length < 1e-6) return;
        const LineEnd next = end_in_cell(line, cell, t);
        const bool is_known = next.is_vertex() || next.is_confirmed || next.is_at_corner;
        if (!is_known && !is_seen(frame_, cell, next, line)) {
            // Half of the cell in which something hides it.
            return draw(line.kind, end.at, end.q, 0.5 * (end.at + next.at), next.q);
        }
        draw(line.kind, end.at, end.q, next.at, next.q);
        if (next.is_vertex() && line.is_edge()) {
            (void)follow_from({line.vertices[is_up ? 1 : 0], line.face, line.name},
                              cell,
                              {},
                              most_cells - step - 1);
        }
        if (is_known) return;
        end = next;
    }
}

bool LineFollower::follow_from(Stand at,
                               const Cell& cell,
                               std::span<const CellLine> known,
                               int most_cells) {
    const std::size_t before = pieces_.size();
    const auto give_up = [&] {
        pieces_.resize(before);
        return false;
    };
    for (int step = 0; step < kMostEdges; ++step) {
        const auto way = only_way(at);
        if (!way) return give_up();
        Line line{.name = edge_name(at.vertex, way->to),
                  .kind = way->kind,
                  .face = way->face,
                  .vertices = {at.vertex, way->to}};
        const auto is_this = [&](const CellLine& other) { return other.line.name == line.name; };
        if (std::any_of(known.begin(), known.end(), is_this)) return true;
        const auto segment = edge_segment(frame_.screen, at.vertex, way->to);
        if (!segment) return give_up();
        line.segment = *segment;
        const auto part = clip_to_cell(line.segment, cell.at);
        if (!part) return give_up();
        const LineEnd end = end_in_cell(line, cell, part->to);
        draw(line.kind, line.segment.a, line.segment.qa, end.at, end.q);
        if (end.is_vertex()) {
            const auto is_met = [&](const CellLine& other) {
                return (other.dangles[0] && other.line.vertices[0] == way->to) ||
                       (other.dangles[1] && other.line.vertices[1] == way->to);
            };
            if (std::any_of(known.begin(), known.end(), is_met)) return true;
            at = {way->to, way->face, line.name};
            continue;
        }
        if (end.is_confirmed || end.is_at_corner) return true;
        if (!is_seen(frame_, cell, end, line)) return give_up();
        go_on(line, cell.at, end, most_cells);
        return true;
    }
    return give_up();
}

/// Calls visit(face, i) for the faces round a vertex, which is corner i of each, both ways from the
/// first to where an edge has not two faces.
template <class Visit>
void LineFollower::each_face_round(const Stand& at, const Visit& visit) const {
    for (const bool turns_back : {false, true}) {
        std::uint32_t f = at.face;
        for (int step = 0; step < kMostFaces; ++step) {
            const LookupFace& face = frame_.face(f);
            std::size_t i = 0;
            while (i < 3 && face.vertices[i] != at.vertex)
                ++i;
            if (i == 3) break;  // over a crack, the other side of which has vertices of its own
            visit(f, i);
            const Twin twin = face.twins[turns_back ? (i + 2) % 3 : i];
            if (twin.is_nothing() || twin.is_many()) break;
            f = twin.face();
            if (f == at.face) return;
        }
    }
}

/// The line that leaves a vertex beside that by which it was come to, if there is just one.
std::optional<LineFollower::Way> LineFollower::only_way(const Stand& at) const {
    if (at.face == kNoNeighbour) return std::nullopt;
    std::optional<Way> found;
    bool is_one = true;
    each_face_round(at, [&](std::uint32_t f, std::size_t i) {
        const auto& v = frame_.face(f).vertices;
        for (const std::size_t edge : {i, (i + 2) % 3}) {
            const std::uint32_t to = edge == i ? v[(i + 1) % 3] : v[edge];
            if (edge_name(at.vertex, to) == at.came_by || (found && found->to == to)) continue;
            const LineKind kind = kind_of(f, edge);
            if (kind == LineKind::none) continue;
            is_one = !found;
            if (!is_one) return;
            found = Way{to, f, kind};
        }
    });
    return is_one ? found : std::nullopt;
}

/// What an edge is from here, whether or not it is hidden.
LineKind LineFollower::kind_of(std::uint32_t face, std::size_t edge) const {
    const LookupFace& of = frame_.face(face);
    const Twin twin = of.twins[edge];
    if (twin.is_nothing()) return LineKind::boundary;
    if (twin.is_many()) return kind_of_many(face, edge);
    const auto facing = frame_.screen.facing();
    const int mine = facing[face], theirs = facing[twin.face()];
    if (twin.is_open(mine, theirs)) return of.kinds[edge];
    const bool is_edge_on = mine == 0 && theirs == 0;
    return is_edge_on ? LineKind::none : LineKind::contour;
}

/// An edge of more than two faces is a crease if any of them bends away from this one.
LineKind LineFollower::kind_of_many(std::uint32_t face, std::size_t edge) const {
    const LookupMesh& mesh = frame_.screen.mesh();
    const auto& v = mesh.faces[face].vertices;
    const auto [low, high] = std::minmax(v[edge], v[(edge + 1) % 3]);
    const double least = std::cos(frame_.screen.crease_rad());
    for (auto at = std::lower_bound(mesh.many.begin(), mesh.many.end(), ManyFaces{low, high, 0});
         at != mesh.many.end() && at->a == low && at->b == high;
         ++at) {
        if (std::abs(glm::dot(mesh.normal(face), mesh.normal(at->face))) <= least)
            return LineKind::crease;
    }
    return LineKind::none;
}

}  // namespace ink::methods
