#include "methods/strokes/cell_strokes.h"

#include <bit>
#include <cmath>
#include <glm/geometric.hpp>

namespace ink::methods {
namespace {

glm::ivec2 cell_beyond(const glm::ivec2& cell, int side) {
    static constexpr std::array<glm::ivec2, 4> kSteps = {{{0, -1}, {1, 0}, {0, 1}, {-1, 0}}};
    return cell + kSteps[static_cast<std::size_t>(side)];
}

constexpr double kBehind = 1e-4;     ///< relative: of 1/w, what cannot hide
constexpr double kOvershoot = 0.05;  ///< of its length in the cell, by which a line may cut another
constexpr double kSamePlace_px = 0.02;
constexpr double kFarthest_px = 1.5;  ///< ends of one cell are no farther apart
constexpr double kSamePart = 1e-9;    ///< of an edge's length

double across(const glm::dvec2& a, const glm::dvec2& b) {
    return a.x * b.y - a.y * b.x;
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

void CellStrokes::draw(const glm::ivec2& at) {
    cell_ = frame_.cell(at);
    if (draw_plain()) return;
    line_count_ = unknown_count_ = 0;
    gather();
    for (CellLine& line : lines()) {
        settle(line, 0);
        settle(line, 1);
    }
    for (const CellLine& line : lines()) {
        const auto& [a, b] = line.ends;
        follower_.draw(line.line.kind, a.at, a.q, b.at, b.q);
    }
    join_dangling();
    join_unknown();
}

/// Draws the piece of a cell that is crossed by one edge, and that from side to side, as most are.
bool CellStrokes::draw_plain() {
    const NamedCrossing* first = nullptr;
    unsigned sides = 0;
    for (std::size_t side = 0; side < 4; ++side) {
        const auto crossings = cell_.crossings[side];
        if (crossings.empty()) continue;
        if (first == nullptr) first = crossings.data();
        if (crossings.size() > 1 || crossings[0].name != first->name) return false;
        sides |= 1U << side;
    }
    if (first->name == 0 || first->crossing.edge >= Crossing::kIntersection) return false;
    KnownEdge* const edge = known_edge(*first);
    if (edge == nullptr) return false;
    const Segment& segment = edge->line.segment;
    const auto part = clip_to_cell(segment, cell_.at);
    if (!part || part->from <= 0 || part->to >= 1) return false;
    const glm::dvec2 a = segment.at(part->from), b = segment.at(part->to);
    const auto goes_on = [&](const glm::dvec2& at) {
        const unsigned near = near_sides(cell_, at);
        return (near & sides) != 0 || std::popcount(near) >= 2;
    };
    if (!goes_on(a) || !goes_on(b)) return false;
    const auto half_px = [&](double t) {
        return frame_.widths.half_px(first->crossing.kind, segment.q_at(t));
    };
    draw_part(*edge, *part, {a, b, half_px(part->from), half_px(part->to)});
    return true;
}

/// Makes the last piece of the edge longer, if both are as wide and meet.
void CellStrokes::draw_part(KnownEdge& edge, const Clipped& part, const Piece& piece) {
    if (!(piece.half_a_px > 0 || piece.half_b_px > 0)) return;
    if (edge.part.from <= edge.part.to && piece.half_a_px == piece.half_b_px) {
        Piece& last = pieces_[edge.piece];
        const bool is_as_wide =
            last.half_a_px == piece.half_a_px && last.half_b_px == piece.half_a_px;
        if (is_as_wide && std::abs(edge.part.to - part.from) < kSamePart) {
            last.b = piece.b;
            edge.part.to = part.to;
            return;
        }
        if (is_as_wide && std::abs(edge.part.from - part.to) < kSamePart) {
            last.a = piece.a;
            edge.part.from = part.from;
            return;
        }
    }
    edge.part = part;
    edge.piece = pieces_.size();
    pieces_.push_back(piece);
}

/// The edge that crosses a side; nothing if none of it lies beyond the near plane.
CellStrokes::KnownEdge* CellStrokes::known_edge(const NamedCrossing& crossing) {
    KnownEdge& known = edges_[crossing.name * 0x9e3779b97f4a7c15U >> 58];
    if (known.line.name == crossing.name) return &known;
    const auto& [face, other, edge, kind, s, q] = crossing.crossing;
    const auto& v = frame_.face(face).vertices;
    const auto [a, b] = std::minmax(v[edge], v[(edge + 1U) % 3]);
    const auto segment = edge_segment(frame_.screen, a, b);
    if (!segment) return nullptr;
    known.line = {.name = crossing.name, .segment = *segment, .vertices = {a, b}};
    known.part = {.from = 1, .to = 0};
    return &known;
}

void CellStrokes::gather() {
    for (int i = 0; i < 4; ++i) {
        const CellSide side(cell_.at, i);
        for (const NamedCrossing& line : cell_.crossings[static_cast<std::size_t>(i)])
            add(line, side.at(line.crossing.s));
    }
}

void CellStrokes::add(const NamedCrossing& crossing, const glm::dvec2& at) {
    const LineName name = crossing.name;
    for (const CellLine& known : lines())
        if (name != 0 && known.line.name == name) return;
    const auto line = line_of(crossing, at);
    if (!line) {
        if (unknown_count_ < kMost) unknown_[unknown_count_++] = at;
        return;
    }
    const auto part = clip_to_cell(line->segment, cell_.at);
    if (!part || line_count_ == kMost) return;
    CellLine& here = lines_[line_count_++];
    here.line = *line;
    here.ends = {end_in_cell(*line, cell_, part->from), end_in_cell(*line, cell_, part->to)};
    here.dangles = {false, false};
}

std::optional<Line> CellStrokes::line_of(const NamedCrossing& named, const glm::dvec2& at) {
    const Crossing& crossing = named.crossing;
    Line line{.name = named.name};
    if (crossing.edge < Crossing::kIntersection) {
        const KnownEdge* const edge = known_edge(named);
        if (edge == nullptr) return std::nullopt;
        line = edge->line;
    } else {
        const auto segment =
            crossing.edge == Crossing::kIntersection
                ? intersection_segment(frame_.screen, crossing.face, crossing.other, at)
                : std::nullopt;
        if (!segment) return std::nullopt;
        line.segment = *segment;
    }
    line.kind = crossing.kind;
    line.face = crossing.face;
    return line;
}

/// Decides of an end what samples do not tell: whether the line goes on, or is hidden before.
void CellStrokes::settle(CellLine& line, std::size_t i) {
    LineEnd& end = line.ends[i];
    line.dangles[i] = end.is_vertex();
    if (end.is_vertex() || end.is_confirmed || end.is_at_corner) return;
    if (line.line.is_edge() && is_seen(frame_, cell_, end, line.line)) {
        follower_.go_on(line.line, cell_.at, end);
    } else {
        cut(line, i);
    }
}

/// Cuts a line off where another of the cell, no farther off, crosses it.
void CellStrokes::cut(CellLine& line, std::size_t i) const {
    LineEnd& end = line.ends[i];
    const LineEnd& from = line.ends[1 - i];
    const glm::dvec2 way = end.at - from.at;
    double nearest = 2;
    for (std::size_t k = 0; k < line_count_; ++k) {
        const CellLine& other = lines_[k];
        if (&other == &line) continue;
        const glm::dvec2 begin = other.ends[0].at - from.at;
        const glm::dvec2 other_way = other.ends[1].at - other.ends[0].at;
        const double turn = across(way, other_way);
        if (std::abs(turn) < 1e-12) continue;
        const double t = across(begin, other_way) / turn, u = across(begin, way) / turn;
        if (t < 0 || t > 1 || u < -kOvershoot || u > 1 + kOvershoot) continue;
        const double q_other = other.ends[0].q + u * (other.ends[1].q - other.ends[0].q);
        const double q = from.q + t * (end.q - from.q);
        if (q_other >= q * (1 - kBehind)) nearest = std::min(nearest, t);
    }
    if (nearest > 1) return;
    end.q = from.q + nearest * (end.q - from.q);
    end.at = from.at + nearest * way;
}

/// Lets lines that end at a vertex go on there, or joins them to others that do.
void CellStrokes::join_dangling() {
    std::array<Dangling, 2 * kMost> all;
    std::size_t count = 0;
    for (std::size_t i = 0; i < line_count_; ++i)
        for (const std::size_t end : {0U, 1U})
            if (lines_[i].dangles[end]) all[count++] = {i, end, false};
    const std::span<Dangling> dangling = std::span(all).first(count);
    for (Dangling& a : dangling) {
        a.is_done = std::any_of(dangling.begin(), dangling.end(), [&](const Dangling& b) {
            return a.line != b.line &&
                   (lines_[a.line].line.vertices[a.end] == lines_[b.line].line.vertices[b.end] ||
                    glm::distance(end_of(a).at, end_of(b).at) < kSamePlace_px);
        });
    }
    for (Dangling& a : dangling) {
        if (a.is_done || !lines_[a.line].line.is_edge()) continue;
        a.is_done = follower_.follow(lines_[a.line], a.end, cell_, lines());
    }
    join_nearest(dangling);
}

/// Joins ends that nothing else is known of, two by two.
void CellStrokes::join_nearest(std::span<Dangling> dangling) {
    for (Dangling& a : dangling) {
        if (a.is_done) continue;
        Dangling* best = nullptr;
        double least = kFarthest_px;
        for (Dangling& b : dangling) {
            const double away = glm::distance(end_of(a).at, end_of(b).at);
            if (b.is_done || a.line == b.line || away >= least) continue;
            least = away;
            best = &b;
        }
        if (best == nullptr) continue;
        a.is_done = best->is_done = true;
        const LineEnd &from = end_of(a), &to = end_of(*best);
        follower_.draw(lines_[a.line].line.kind, from.at, from.q, to.at, to.q);
    }
}

/// Joins what is known to cross a side, and no more, to the nearest end, or to another such.
void CellStrokes::join_unknown() {
    for (std::size_t i = 0; i < unknown_count_; ++i) {
        const glm::dvec2 from = unknown_[i];
        glm::dvec2 to = from;
        double least = 2 * kFarthest_px;
        const auto look = [&](const glm::dvec2& at) {
            const double away = glm::distance(at, from);
            if (away < 1e-9 || away >= least) return;
            least = away;
            to = at;
        };
        for (const CellLine& line : lines())
            for (const std::size_t end : {0U, 1U})
                if (line.dangles[end]) look(line.ends[end].at);
        if (to == from) {
            for (std::size_t k = 0; k < unknown_count_; ++k)
                look(unknown_[k]);
        }
        follower_.draw(LineKind::contour, from, 0, to, 0);
    }
}

}  // namespace ink::methods
