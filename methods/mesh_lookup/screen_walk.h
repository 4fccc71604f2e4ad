#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <glm/vec3.hpp>
#include <optional>
#include <span>

#include "methods/mesh_lookup/screen_mesh.h"

namespace ink::methods {

/// One walk over the mesh along the line of samples from s = 0 to 1.
class ScreenMesh::Walk {
  public:
    enum class End {
        arrived,  ///< at the other face
        line,     ///< at an edge that is one
        beyond,   ///< past the other sample, on another surface
        hidden,   ///< at an edge of many, of whose faces another hides the walk's
        cut,      ///< at the near plane
        lost,     ///< nowhere: too many steps, or the face does not hold its sample
    };

    /// Whether a walk ends at any line, or goes on over those at which the surface goes on, too.
    enum class Ends { at_lines, at_borders };

    /// From the first sample to the second, or back.
    Walk(const ScreenMesh& screen, const SampleSide& side, bool is_back, Ends ends = Ends::at_lines)
        : screen_(screen),
          is_down_(side.is_down),
          goes_over_(ends == Ends::at_borders),
          sign_(is_back ? -1 : 1),
          x_(side.x + (is_back && !side.is_down ? 1 : 0)),
          y_(side.y + (is_back && side.is_down ? 1 : 0)),
          at_(is_back ? side.second : side.first),
          goal_(is_back ? side.first : side.second) {
        if (at_ != kNoNeighbour) run();
    }

    [[nodiscard]] End end() const { return end_; }
    [[nodiscard]] LineKind kind() const { return kind_; }
    [[nodiscard]] double s() const { return s_; }
    [[nodiscard]] double q() const { return q_; }
    /// The last face.
    [[nodiscard]] std::uint32_t face() const { return at_; }
    /// The lines that it met, from its own end on. One that ends at borders alone notes them.
    [[nodiscard]] std::span<const Crossing> lines() const { return {lines_.data(), line_count_}; }
    /// The face that the walk was on at s.
    [[nodiscard]] std::uint32_t face_at(double s) const {
        for (std::size_t i = 0; i < piece_count_; ++i)
            if (s <= pieces_[i].s1) return pieces_[i].face;
        return piece_count_ > 0 ? pieces_[piece_count_ - 1].face : at_;
    }
    /// Whether the line that ended it hides, or lies on, what the other walk came over there.
    [[nodiscard]] bool is_in_front_of(const Walk& other) const {
        const auto q = other.q_at(1 - s_);
        return !q || q_ >= *q * (1 - kSameDepth);
    }

    /// 1/w of the surface at s, nothing where the walk did not come or is not known.
    [[nodiscard]] std::optional<double> q_at(double s) const {
        if (end_ == End::line && s > s_) return std::nullopt;
        for (std::size_t i = 0; i < piece_count_; ++i) {
            const Piece& piece = pieces_[i];
            if (s > piece.s1 && i + 1 < piece_count_) continue;
            const double length = piece.s1 - piece.s0;
            if (!(length > 0)) return piece.q0;
            return piece.q0 + (piece.q1 - piece.q0) * (s - piece.s0) / length;
        }
        return std::nullopt;
    }

  private:
    static constexpr double kBeyond_px = 1.0 / 256;  ///< a face is met so far beyond the far sample

    /// A crossing of the line with an edge, from its end above the line to that below.
    struct Passage {
        std::uint32_t high = 0;
        std::uint32_t low = 0;
        double s = 0;
        double q = 0;  ///< 1/w; 0 behind the eye
        bool is_on_screen = false;
    };
    struct Piece {
        double s0, q0, s1, q1;
        std::uint32_t face;
    };
    /// A face and the edge over which the walk came to it.
    struct Landing {
        std::uint32_t face = kNoNeighbour;
        std::size_t edge = 0;
    };

    /// A sample counts as lying a little to the right of where it is and below, as the rasterizer's
    /// rule has it: what lies on the line is above it.
    [[nodiscard]] bool is_high(std::uint32_t vertex) const { return height(vertex) > 0; }

    [[nodiscard]] double height(std::uint32_t vertex) const {
        const Vertex v = screen_.vertex(vertex);
        return v.is_on_screen() ? height(v) : height_off_screen(vertex);
    }
    /// Of what is on the screen, from the line and along it, in 1/256 px.
    [[nodiscard]] int height(const Vertex& v) const {
        return is_down_ ? v.x - 256 * x_ - 128 : v.y - 256 * y_ - 128;
    }
    [[nodiscard]] int along(const Vertex& v) const {
        return is_down_ ? v.y - 256 * y_ - 128 : v.x - 256 * x_ - 128;
    }
    [[nodiscard]] double height_off_screen(std::uint32_t vertex) const;

    /// Fills `at` in place: what is copied right after waits for it.
    void pass_over(std::uint32_t high, std::uint32_t low, Passage& at) const {
        const Vertex a = screen_.vertex(high);
        const Vertex b = screen_.vertex(low);
        at.high = high;
        at.low = low;
        at.is_on_screen = a.is_on_screen() && b.is_on_screen();
        if (!at.is_on_screen) return pass_off_screen(at);
        const double ha = height(a), hb = height(b);
        const double t = ha > hb ? std::clamp(ha / (ha - hb), 0.0, 1.0) : 0.5;
        const double from = along(a), to = along(b);
        at.s = sign_ * (from + t * (to - from)) / 256;
        at.q = a.q + t * (b.q - a.q);
    }
    void pass_off_screen(Passage& at) const;
    struct ClipPlace {
        double w, s_w;
    };
    [[nodiscard]] ClipPlace clip_place(const Passage& at) const;

    /// Whether the line meets an edge of a face behind another.
    [[nodiscard]] bool is_ahead(const Passage& at, const Passage& other) const {
        if (at.is_on_screen && other.is_on_screen) return at.s > other.s;
        return is_ahead_off_screen(at, other);
    }
    [[nodiscard]] bool is_ahead_off_screen(const Passage& at, const Passage& other) const;

    void run() {
        std::size_t exit = 0;
        std::array<Passage, 2> passages;
        const auto last = start(passages, exit);
        if (!last) return;
        Passage& out = passages[*last];
        double s_in = passages[1 - *last].s, q_in = passages[1 - *last].q;
        for (int step = 0; step < screen_.options_.most_steps; ++step) {
            note(s_in, q_in, out);
            if (out.q * screen_.near_ > 1 || out.q <= 0) {
                end_ = End::cut;
                return;
            }
            if (out.s > 1 + kBeyond_px) {
                end_ = End::beyond;
                return;
            }
            const Landing next = across(exit, out);
            if (end_ == End::hidden) return;
            if (kind_ != LineKind::none && ends_at_line(exit, next, out)) return;
            at_ = next.face;
            if (at_ == goal_) {
                end_ = End::arrived;
                return;
            }
            s_in = out.s;
            q_in = out.q;
            exit = leave(next.edge, out);
        }
    }

    /// Whether the walk ends at the line in kind_; else it is noted, and the walk goes on.
    bool ends_at_line(std::size_t exit, const Landing& next, const Passage& out) {
        if (goes_over_) {
            const std::size_t to = std::min(line_count_, lines_.size() - 1);
            Crossing& line = lines_[to];
            line.face = at_;
            line.edge = static_cast<std::uint8_t>(exit);
            line.kind = kind_;
            line.s = static_cast<float>(out.s);
            line.q = static_cast<float>(out.q);
            line_count_ = to + 1;
            const bool is_border = next.face == kNoNeighbour || kind_ == LineKind::contour ||
                                   kind_ == LineKind::boundary;
            if (!is_border) {
                kind_ = LineKind::none;
                return false;
            }
        }
        end_ = End::line;
        s_ = out.s;
        q_ = out.q;
        return true;
    }

    /// Where the line enters the first face and leaves it, over edge `exit`; returns which of
    /// `passages` that is.
    std::optional<std::size_t> start(std::array<Passage, 2>& passages, std::size_t& exit) const {
        const auto& v = screen_.mesh_->faces[at_].vertices;
        const std::array<bool, 3> high = {is_high(v[0]), is_high(v[1]), is_high(v[2])};
        if (high[0] == high[1] && high[1] == high[2]) return std::nullopt;
        // Both edges of the corner that is alone on its side.
        const std::size_t alone = high[0] == high[1] ? 2 : high[0] == high[2] ? 1 : 0;
        const std::array<std::size_t, 2> edges = {alone == 2 ? 1U : 0U, alone == 0 ? 2U : alone};
        for (std::size_t i = 0; i < 2; ++i) {
            const std::uint32_t a = v[edges[i]], b = v[(edges[i] + 1) % 3];
            high[edges[i]] ? pass_over(a, b, passages[i]) : pass_over(b, a, passages[i]);
        }
        const std::size_t last = is_ahead(passages[1], passages[0]) ? 1 : 0;
        exit = edges[last];
        return last;
    }

    /// Over which edge the line leaves a face that it entered over another: over that of the two
    /// whose ends lie on both sides; where, in `out`.
    std::size_t leave(std::size_t entered, Passage& out) const {
        const LookupFace& face = screen_.mesh_->faces[at_];
        std::uint32_t high = face.vertices[entered];
        std::uint32_t low = face.vertices[(entered + 1) % 3];
        std::size_t of_high = (entered + 2) % 3, of_low = (entered + 1) % 3;  // edges to the third
        if (height(high) < height(low)) {
            std::swap(high, low);
            std::swap(of_high, of_low);
        }
        const std::uint32_t third = face.vertices[(entered + 2) % 3];
        const bool is_third_high = is_high(third);
        is_third_high ? pass_over(third, low, out) : pass_over(high, third, out);
        return is_third_high ? of_low : of_high;
    }

    void note(double s_in, double q_in, const Passage& out) {
        if (piece_count_ < pieces_.size()) ++piece_count_;
        pieces_[piece_count_ - 1] = {s_in, q_in, out.s, out.q, at_};
    }

    [[nodiscard]] glm::dvec3 p_world(std::uint32_t vertex) const {
        return screen_.mesh_->p_world[vertex];
    }

    /// The face on the other side of an edge that is left, or the line that it is, in kind_.
    Landing across(std::size_t exit, const Passage& out) {
        const LookupFace& face = screen_.mesh_->faces[at_];
        const Twin twin = face.twins[exit];
        if (twin.is_nothing()) {
            kind_ = LineKind::boundary;
            return {};
        }
        if (twin.is_many()) {
            const std::uint32_t mine = face.vertices[(exit + 2) % 3];
            return nearest_of_many(exit, out, screen_.side_of(out.high, out.low, mine));
        }
        kind_ = screen_.is_open(at_, twin) ? face.kinds[exit] : LineKind::contour;
        return {twin.face(), twin.edge()};
    }

    [[nodiscard]] double slope(const Passage& out, std::uint32_t third) const;
    Landing nearest_of_many(std::size_t exit, const Passage& out, int mine);

    const ScreenMesh& screen_;

    bool is_down_, goes_over_;
    int sign_;
    int x_, y_;
    std::uint32_t at_, goal_;
    End end_ = End::lost;
    LineKind kind_ = LineKind::none;
    double s_ = 0, q_ = 0;
    std::array<Piece, 16> pieces_;
    std::size_t piece_count_ = 0;
    std::array<Crossing, 4> lines_;
    std::size_t line_count_ = 0;
};

}  // namespace ink::methods
