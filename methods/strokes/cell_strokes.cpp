#include "methods/strokes/cell_strokes.h"

#include <cmath>
#include <glm/geometric.hpp>

namespace ink::methods {
namespace {

constexpr double kBehind = 1e-4;     ///< relative: of 1/w, what cannot hide
constexpr double kOvershoot = 0.05;  ///< of its length in the cell, by which a line may cut another
constexpr double kSamePlace_px = 0.02;
constexpr double kFarthest_px = 1.5;  ///< ends of one cell are no farther apart

double across(const glm::dvec2& a, const glm::dvec2& b) {
    return a.x * b.y - a.y * b.x;
}

}  // namespace

void CellStrokes::draw(const glm::ivec2& at) {
    cell_ = frame_.cell(at);
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
    auto line = line_of(crossing.crossing, at);
    if (!line) {
        if (unknown_count_ < kMost) unknown_[unknown_count_++] = at;
        return;
    }
    line->name = name;
    const auto part = clip_to_cell(line->segment, cell_.at);
    if (!part || line_count_ == kMost) return;
    CellLine& here = lines_[line_count_++];
    here.line = *line;
    here.ends = {end_in_cell(*line, cell_, part->from), end_in_cell(*line, cell_, part->to)};
    here.dangles = {false, false};
}

std::optional<Line> CellStrokes::line_of(const Crossing& crossing, const glm::dvec2& at) const {
    Line line{.kind = crossing.kind, .face = crossing.face};
    std::optional<Segment> segment;
    if (crossing.edge < Crossing::kIntersection) {
        const auto& v = frame_.face(crossing.face).vertices;
        const auto [a, b] = std::minmax(v[crossing.edge], v[(crossing.edge + 1U) % 3]);
        line.vertices = {a, b};
        segment = edge_segment(frame_.screen, a, b);
    } else if (crossing.edge == Crossing::kIntersection) {
        segment = intersection_segment(frame_.screen, crossing.face, crossing.other, at);
    }
    if (!segment) return std::nullopt;
    line.segment = *segment;
    return line;
}

/// Decides of an end what samples do not tell: whether the line goes on, or is hidden before.
void CellStrokes::settle(CellLine& line, std::size_t i) {
    LineEnd& end = line.ends[i];
    line.dangles[i] = end.is_vertex();
    if (end.is_vertex() || end.is_confirmed || end.is_at_corner) return;
    if (line.line.is_edge() && is_seen(frame_, cell_, end, line.line.face)) {
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
