// All lines between two samples: as line_between() decides which one there is, but walks go on over
// lines behind which the surface goes on, and each keeps those that it met.

#include <algorithm>
#include <cmath>

#include "methods/mesh_lookup/screen_mesh.h"
#include "methods/mesh_lookup/screen_walk.h"

namespace ink::methods {
namespace {

/// Lines of both walks that are so near are one.
constexpr double kTouching = 1e-6;

Crossing seen_back(Crossing crossing) {
    crossing.s = 1 - crossing.s;
    return crossing;
}

Crossing as_seam(Crossing crossing) {
    crossing.kind = LineKind::seam;
    return crossing;
}

}  // namespace

/// The two walks of a side, and what they come to.
class ScreenMesh::SideSearch {
  public:
    SideSearch(const ScreenMesh& screen, const SampleSide& side, SideLines& lines)
        : screen_(screen),
          side_(side),
          there_(screen, side, false, Walk::Ends::at_borders),
          lines_(lines) {}

    void run() {
        if (there_.end() == End::arrived) return add_first(kAll);
        const Walk back(screen_, side_, true, Walk::Ends::at_borders);
        back_ = &back;
        if (back.end() == End::arrived) return add_second(kAll);
        if (side_.first == kNoNeighbour || side_.second == kNoNeighbour) return look_at_sky();
        if (!is_lost_in_one_patch()) look_at_surfaces();
    }

  private:
    using End = Walk::End;
    struct Range {
        double from, to;
    };
    static constexpr Range kAll{-1, 2};

    void add_first(const Range& range) {
        for (const Crossing& line : there_.lines())
            if (line.s >= range.from && line.s <= range.to) lines_.add(line);
    }
    void add_second(const Range& range) {
        const auto lines = back_->lines();
        for (std::size_t i = lines.size(); i-- > 0;) {
            const Crossing line = seen_back(lines[i]);
            if (line.s >= range.from && line.s <= range.to) lines_.add(line);
        }
    }

    /// One of the samples is sky: what the other one's walk met.
    void look_at_sky() {
        const bool is_back = side_.first == kNoNeighbour;
        const End end = is_back ? back_->end() : there_.end();
        // A walk that comes past the sky has looked at it through a crack.
        if (end == End::cut || end == End::beyond) return;
        if (end != End::line) return lines_.add({.kind = LineKind::contour});
        is_back ? add_second(kAll) : add_first(kAll);
    }

    [[nodiscard]] bool is_lost_in_one_patch() const {
        if (there_.end() != End::lost && back_->end() != End::lost) return false;
        const auto& faces = screen_.mesh_->faces;
        return faces[side_.first].patch == faces[side_.second].patch;
    }

    void look_at_surfaces() {
        const bool goes_there = screen_.goes_on(side_, there_, *back_, true);
        const bool goes_back = screen_.goes_on(side_, *back_, there_, false);
        if (goes_there && goes_back) return;
        const bool has_first = there_.end() == End::line, has_second = back_->end() == End::line;
        if (goes_there || goes_back) {
            // Of two objects, the border of the one is a seam.
            const bool is_seam =
                (goes_there ? has_second : has_first) && objects_differ(side_.first, side_.second);
            if (!is_seam) return;
            return lines_.add(
                as_seam(goes_there ? seen_back(back_->lines().back()) : there_.lines().back()));
        }
        if (has_first && has_second) {
            if (screen_.is_crack(there_, *back_)) {
                if (objects_differ(there_.face(), back_->face()))
                    lines_.add(as_seam(there_.lines().back()));
                return;
            }
            // Something narrow lies between both.
            if (there_.s() <= 1 - back_->s() + kTouching) {
                add_first(kAll);
                return add_second(kAll);
            }
        }
        add_nearer(has_first && there_.is_in_front_of(*back_),
                   has_second && back_->is_in_front_of(there_));
    }
    [[nodiscard]] bool objects_differ(std::uint32_t face, std::uint32_t other) const {
        return screen_.mesh_->objects[face] != screen_.mesh_->objects[other];
    }

    /// The nearer surface keeps all of its lines, the other those beyond the nearer one's end.
    void add_nearer(bool is_first, bool is_second) {
        if (is_first && (!is_second || there_.q() >= back_->q())) {
            add_first(kAll);
            add_second({there_.s() + kTouching, 2});
        } else if (is_second) {
            add_first({-1, 1 - back_->s() - kTouching});
            add_second(kAll);
        } else if (there_.end() != End::cut && back_->end() != End::cut) {
            add_intersection();
        }
    }

    /// Neither ends in front: they meet where both are equally far.
    void add_intersection() {
        Crossing meeting{.face = there_.face_at(0.5),
                         .other = back_->face_at(0.5),
                         .edge = Crossing::kIntersection,
                         .kind = LineKind::intersection};
        const auto q0 = there_.q_at(0), q1 = there_.q_at(1);
        const auto other0 = back_->q_at(1), other1 = back_->q_at(0);
        if (q0) meeting.q = static_cast<float>(*q0);
        if (q0 && q1 && other0 && other1) {
            const double before = *q0 - *other0, after = *q1 - *other1;
            const double least = kSameDepth * *q0;
            if (std::abs(before) <= least && std::abs(after) <= least) return;
            const double s =
                before != after ? std::clamp(before / (before - after), 0.0, 1.0) : 0.5;
            meeting.face = there_.face_at(s);
            meeting.other = back_->face_at(1 - s);
            meeting.s = static_cast<float>(s);
            if (const auto q = there_.q_at(s)) meeting.q = static_cast<float>(*q);
        }
        add_first({-1, meeting.s});
        lines_.add(meeting);
        add_second({meeting.s, 2});
    }

    const ScreenMesh& screen_;
    const SampleSide& side_;
    Walk there_;
    const Walk* back_ = nullptr;  ///< while it is looked at
    SideLines& lines_;
};

void ScreenMesh::lines_between(const SampleSide& side, SideLines& lines) const {
    lines.count = 0;
    if (!glimpse_lines(side, lines)) SideSearch(*this, side, lines).run();
}

}  // namespace ink::methods
