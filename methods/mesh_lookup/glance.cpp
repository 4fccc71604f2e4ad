// What a walk in whole numbers tells of a side: nothing of depths and classes is asked, and what it
// cannot tell it leaves to the walk that can (screen_mesh.cpp).

#include "methods/mesh_lookup/screen_mesh.h"

namespace ink::methods {
namespace {

/// Lines found from both ends are of one place unless they meet by less than this.
constexpr double kMeeting = 1e-6;
/// Lines up to half of 1/256 px beyond the far sample are seen from here.
constexpr double kFarthest = 1 + 0.5 / 256;
/// Before the far sample by more than a snapping.
constexpr double kWithin = 1 - 1.0 / 256;

}  // namespace

/// A walk from one face along the line of samples. It ends at the other face over edges that are
/// open; at a line, which is not yet known to lie in front; or nowhere.
class ScreenMesh::Glance {
  public:
    Glance(const ScreenMesh& screen, const SampleSide& side, bool is_back)
        : screen_(screen),
          is_down_(side.is_down),
          sign_(is_back ? -1 : 1),
          x_(256 * (side.x + (is_back && !side.is_down ? 1 : 0)) + 128),
          y_(256 * (side.y + (is_back && side.is_down ? 1 : 0)) + 128),
          at_(is_back ? side.second : side.first) {
        run(is_back ? side.first : side.second);
    }

    [[nodiscard]] bool has_arrived() const { return has_arrived_; }
    [[nodiscard]] bool is_line() const { return is_line_; }
    /// Where that line is, 0..1 from the sample it left.
    [[nodiscard]] double s() const { return s_; }
    [[nodiscard]] Twin twin() const { return screen_.mesh_->faces[at_].twins[exit_]; }
    [[nodiscard]] std::uint32_t face() const { return at_; }
    /// Whether nothing of that surface is seen beyond the line.
    [[nodiscard]] bool is_at_border() const {
        return is_line_ && (twin().is_nothing() || !screen_.is_open(at_, twin()));
    }
    /// Adds that line, as the first sample of the side has it.
    void add_to(SideLines& lines) const {
        if (lines.count == lines.crossings.size()) return;
        const LookupFace& face = screen_.mesh_->faces[at_];
        const LineKind border = twin().is_nothing() ? LineKind::boundary : LineKind::contour;
        const double q_from = screen_.q_[face.vertices[exit_]];
        const double q_to = screen_.q_[face.vertices[(exit_ + 1) % 3]];
        const auto s = static_cast<float>(s_);
        // In place: what is copied right after waits for it.
        Crossing& line = lines.crossings[lines.count++];
        line.face = at_;
        line.other = kNoNeighbour;
        line.edge = static_cast<std::uint8_t>(exit_);
        line.kind = is_at_border() ? border : face.kinds[exit_];
        line.s = sign_ < 0 ? 1 - s : s;
        line.q = static_cast<float>(q_from + t_ * (q_to - q_from));
    }

  private:
    [[nodiscard]] glm::ivec2 place(std::size_t corner) const {
        return screen_.places_[screen_.mesh_->faces[at_].vertices[corner]];
    }
    /// As Walk has it.
    [[nodiscard]] bool is_high(const glm::ivec2& v) const { return is_down_ ? v.x > x_ : v.y > y_; }

    /// Whether a vertex lies past the far sample.
    [[nodiscard]] bool is_beyond(const glm::ivec2& v) const {
        return sign_ * (is_down_ ? v.y - y_ : v.x - x_) > 256;
    }

    void run(std::uint32_t goal) {
        if (!start()) return;
        for (int step = 0; step < screen_.options_.most_steps; ++step) {
            const Twin next = twin();
            if (next.is_closed() || !screen_.is_open(at_, next)) return stop_at_line(next);
            if (is_beyond(place(exit_)) && is_beyond(place((exit_ + 1) % 3))) return;
            at_ = next.face();
            if (at_ == goal) {
                has_arrived_ = true;
                return;
            }
            const glm::ivec2 third = place((next.edge() + 2) % 3);
            if (third.x == kOffScreen) return;
            // Out over the next edge if the third corner lies on the side of the first end.
            const bool is_first_high = is_high(place(next.edge()));
            exit_ = (next.edge() + (is_high(third) == is_first_high ? 1U : 2U)) % 3;
        }
    }

    /// Finds the edge over which the line leaves the first face: that which runs up, or down, in
    /// the face's own order.
    bool start() {
        const glm::ivec2 a = place(0), b = place(1), c = place(2);
        if (a.x == kOffScreen || b.x == kOffScreen || c.x == kOffScreen) return false;
        const std::int64_t area =
            std::int64_t{b.x - a.x} * (c.y - a.y) - std::int64_t{b.y - a.y} * (c.x - a.x);
        if (area == 0) return false;
        const bool is_up = (area > 0) == (is_down_ != (sign_ > 0));
        const std::array<bool, 3> high = {is_high(a), is_high(b), is_high(c)};
        bool is_found = false;
        for (std::size_t i = 0; i < 3; ++i) {
            if (high[i] == is_up || high[(i + 1) % 3] != is_up) continue;
            exit_ = i;
            is_found = true;
        }
        return is_found;
    }

    /// A line, unless the edge is one of many or a crack, or lies beyond the other sample.
    void stop_at_line(Twin twin) {
        if (twin.is_many()) return;
        const bool is_crack = !twin.is_nothing() && twin.is_closed() &&
                              screen_.mesh_->faces[at_].kinds[exit_] == LineKind::none;
        if (is_crack) return;
        const glm::ivec2 p = place(exit_), q = place((exit_ + 1) % 3);
        const std::int64_t height_p = is_down_ ? p.x - x_ : p.y - y_;
        const std::int64_t height_q = is_down_ ? q.x - x_ : q.y - y_;
        if (height_p == height_q) return;
        const std::int64_t along_p = is_down_ ? p.y - y_ : p.x - x_;
        const std::int64_t along_q = is_down_ ? q.y - y_ : q.x - x_;
        s_ = sign_ * static_cast<double>(along_p * height_q - along_q * height_p) /
             (256 * static_cast<double>(height_q - height_p));
        t_ = static_cast<double>(height_p) / static_cast<double>(height_p - height_q);
        is_line_ = s_ < kFarthest;
    }

    const ScreenMesh& screen_;
    bool is_down_;
    int sign_;
    std::int32_t x_, y_;  ///< of the first sample, 1/256 px
    std::uint32_t at_;
    std::size_t exit_ = 0;
    bool has_arrived_ = false;
    bool is_line_ = false;
    double s_ = 0;
    double t_ = 0;  ///< of the edge, from its first end
};

ScreenMesh::Glimpse ScreenMesh::glimpse(const SampleSide& side) const {
    if (side.first == kNoNeighbour || side.second == kNoNeighbour) {
        const Glance from_face(*this, side, side.first == kNoNeighbour);
        return from_face.is_line() ? Glimpse::line : Glimpse::unknown;
    }
    const Glance there(*this, side, false);
    if (there.has_arrived()) return Glimpse::none;
    const Glance back(*this, side, true);
    if (back.has_arrived()) return Glimpse::none;
    if (!there.is_line() || !back.is_line()) return Glimpse::unknown;
    const Twin twin = there.twin(), other = back.twin();
    const bool is_one_edge = !twin.is_nothing() && !other.is_nothing() &&
                             twin.face() == back.face() && other.face() == there.face();
    if (is_one_edge) return Glimpse::line;
    if (there.s() + back.s() >= 1 - kMeeting) return Glimpse::unknown;
    // Two boundaries may be the sides of a crack.
    return twin.is_nothing() && other.is_nothing() ? Glimpse::unknown : Glimpse::line;
}

/// Finds the lines of a side that is plain: one edge that both samples' faces come to, or borders
/// that leave a gap.
bool ScreenMesh::glimpse_lines(const SampleSide& side, SideLines& lines) const {
    if (side.first == kNoNeighbour || side.second == kNoNeighbour) {
        const bool is_back = side.first == kNoNeighbour;
        const Glance from_face(*this, side, is_back);
        if (!from_face.is_at_border()) return false;
        from_face.add_to(lines);
        return true;
    }
    const Glance there(*this, side, false);
    if (there.has_arrived()) return true;
    // The edge at which the other sample's face begins is where a walk from there would stop.
    if (there.is_line() && there.s() >= 0 && there.s() < kWithin && !there.twin().is_nothing() &&
        there.twin().face() == side.second) {
        there.add_to(lines);
        return true;
    }
    const Glance back(*this, side, true);
    if (back.has_arrived()) return true;
    if (!there.is_line() || !back.is_line()) return false;
    const Twin twin = there.twin(), other = back.twin();
    const bool is_one_edge = !twin.is_nothing() && !other.is_nothing() &&
                             twin.face() == back.face() && other.face() == there.face();
    if (is_one_edge) {
        there.add_to(lines);
        return true;
    }
    const bool has_gap = there.is_at_border() && back.is_at_border() &&
                         there.s() + back.s() < 1 - kMeeting &&
                         !(twin.is_nothing() && other.is_nothing());
    if (!has_gap) return false;
    there.add_to(lines);
    back.add_to(lines);
    return true;
}

}  // namespace ink::methods
