#include "crosscheck/known_lines.h"
#include "crosscheck/line_names.h"

#include <algorithm>
#include <glm/geometric.hpp>
#include <utility>

namespace ink::crosscheck {
namespace {

constexpr double kFound_px = 0.2;             ///< points along an edge lie at most 3/8 px apart
constexpr double kBesideLine_px = 1.0 / 512;  ///< before and behind a line

constexpr double kFinest_px = 1.0 / 512;

bool is_long(const Way& way) {
    return glm::length(way.to.p_px - way.from.p_px) > kFinest_px;
}

/// Adds what separates two samples that lie very close and are not joined.
void add_crossing(const SightRays& rays, const CellWay& way, double spacing_px, Crossings& found) {
    const Between between = name_between(rays, way.from, way.to);
    found.counts.defects += between.is_defect;
    found.counts.near_cuts += between.is_near_cut;
    found.counts.unexplained += !between.is_explained;
    const glm::dvec2 p = 0.5 * (way.from.p_px + way.to.p_px);
    const scene::View& view = rays.mesh().view();
    if (p.x < 0 || p.y < 0 || p.x >= view.width_px || p.y >= view.height_px) return;
    for (int i = 0; i < between.count; ++i) {
        const NamedLine& line = between.lines[i];
        found.points.push_back({way.cell, {p.x, p.y, line.line_class, spacing_px / line.slant}});
    }
}

constexpr std::size_t kMostLines = 8;  ///< that one way may cross and be explained

/// Finds out whether the way between two samples crosses known lines alone: it is followed over the
/// surface to the first feature edge, which must be a known line, and from what is seen just beyond
/// that on to the next; from the other end where that fails.
///
/// Asks for one look at a time, so that those of many ways can be made together. Borrows the lines.
class Explanation {
  public:
    Explanation(const KnownLines& known, const Way& way, Reach reach);

    /// Whether it waits for the look at `wanted_px`.
    [[nodiscard]] bool is_waiting() const { return state_ == State::waiting; }
    [[nodiscard]] const glm::dvec2& wanted_px() const { return wanted_px_; }
    /// Goes on with what is seen there.
    void go_on(const Sample& sample);
    /// What came out, once it waits no more.
    [[nodiscard]] bool is_explained() const { return state_ == State::explained; }

  private:
    enum class State { waiting, explained, failed };

    /// A rest of the way, and from how many of its ends it was followed in vain.
    struct Rest {
        Way way;
        int turn = 0;
        bool is_seen_before = false;  ///< the surface is seen up to the line
        KnownLines::Meeting line = {};

        [[nodiscard]] const Sample& begin() const { return turn == 0 ? way.from : way.to; }
        [[nodiscard]] const Sample& end() const { return turn == 0 ? way.to : way.from; }
    };

    void follow();
    void turn();
    [[nodiscard]] bool pass(Rest& rest);
    void want(const glm::dvec2& p_px);

    const KnownLines& known_;
    Reach reach_;
    State state_ = State::failed;
    glm::dvec2 wanted_px_{0};
    std::vector<Rest> rests_;  ///< each of the one before it
};

Explanation::Explanation(const KnownLines& known, const Way& way, Reach reach)
    : known_(known), reach_(reach) {
    if (reach == Reach::whole && is_joined(known.mesh(), way.from, way.to)) {
        state_ = State::explained;
        return;
    }
    rests_.push_back({way});
    follow();
}

void Explanation::go_on(const Sample& sample) {
    state_ = State::failed;
    Rest& rest = rests_.back();
    if (!rest.is_seen_before) {
        // The edge is what ends the surface only if the surface is seen up to it.
        rest.is_seen_before = is_joined(known_.mesh(), rest.begin(), sample);
        if (rest.is_seen_before && pass(rest)) return;
    } else if (is_joined(known_.mesh(), sample, rest.end())) {
        state_ = State::explained;
        return;
    } else if (rests_.size() < kMostLines) {
        const Way next{sample, rest.end()};
        rests_.push_back({next});
        follow();
        return;
    }
    turn();
    follow();
}

/// Follows what is left, from one end and then the other, until a look is needed.
void Explanation::follow() {
    while (!rests_.empty()) {
        Rest& rest = rests_.back();
        rest.line = known_.first_known(rest.begin(), rest.end());
        rest.is_seen_before = rest.line.before <= 0;
        if (rest.line.is_known) {
            if (!rest.is_seen_before) {
                want(rest.line.before_px);
                return;
            }
            if (pass(rest)) return;
        }
        turn();
    }
}

/// Takes up the other end of the rest, or of the last one whose other end is left.
void Explanation::turn() {
    const int ends = reach_ == Reach::whole ? 2 : 1;
    while (!rests_.empty() && ++rests_.back().turn >= ends)
        rests_.pop_back();
}

/// Goes past the line that was met; false if the way does not lead there.
bool Explanation::pass(Rest& rest) {
    if (rest.line.is_stuck()) return false;
    if (rest.line.is_last() || reach_ == Reach::first_line) {
        state_ = State::explained;
    } else {
        want(rest.line.next_px);
    }
    return true;
}

void Explanation::want(const glm::dvec2& p_px) {
    wanted_px_ = p_px;
    state_ = State::waiting;
}

}  // namespace

KnownLines::KnownLines(const SampleCells& cells,
                       const ClipMesh& mesh,
                       std::span<const CellPoint> points)
    : cells_(cells),
      mesh_(mesh),
      points_(static_cast<std::size_t>(cells.columns()) * cells.rows(), [&](auto take) {
          for (const CellPoint& p : points)
              take(cells.index(p.cell), p.point);
      }) {}

bool KnownLines::has_near(const glm::dvec2& p_px,
                          truth::LineClass line_class,
                          double reach_px) const {
    const auto is_near = [&](const SampledPoint& q) {
        const double dx = q.x_px - p_px.x, dy = q.y_px - p_px.y;
        return q.line_class == line_class && dx * dx + dy * dy <= reach_px * reach_px;
    };
    const glm::ivec2 low = cells_.cell_of(p_px - reach_px), high = cells_.cell_of(p_px + reach_px);
    for (int y = low.y; y <= high.y; ++y) {
        const std::size_t first = cells_.index({low.x, y}), last = cells_.index({high.x, y});
        if (std::ranges::any_of(points_.of(first, last), is_near)) return true;
    }
    return false;
}

bool KnownLines::Meeting::is_stuck() const {
    return !is_last() && before + 2 * kBesideLine_px <= 0;
}

KnownLines::Meeting KnownLines::first_known(const Sample& from, const Sample& to) const {
    if (from.sight.face == kNothing) return {};
    const auto way = walking::walk(mesh_, from, to.p_px, walking::Stop::at_feature);
    if (way.met.line_class == truth::LineClass::none) return {};
    if (way.met.w < mesh_.view().camera.near) return {};
    const glm::dvec2 end_px = mesh_.px(way.met.p_world);
    if (!has_near(end_px, way.met.line_class, kFound_px)) return {};
    const glm::dvec2 d = glm::normalize(to.p_px - from.p_px);
    Meeting line;
    line.is_known = true;
    line.before = glm::dot(end_px - from.p_px, d) - kBesideLine_px;
    line.behind = glm::dot(to.p_px - end_px, d) - kBesideLine_px;
    line.before_px = end_px - kBesideLine_px * d;
    line.next_px = end_px + kBesideLine_px * d;
    return line;
}

void add_crossings(const SightRays& rays,
                   std::span<const CellWay> ways,
                   double spacing_px,
                   Crossings& found) {
    std::vector<CellWay> parts, halves;
    const auto add_open = [&](const CellWay& way, std::vector<CellWay>& to) {
        if (!is_joined(rays.mesh(), way.from, way.to)) to.push_back(way);
    };
    for (const CellWay& way : ways)
        add_open(way, parts);
    std::vector<Sample> middles;
    while (true) {
        middles.clear();
        for (const CellWay& part : parts) {
            if (is_long(part)) middles.push_back({0.5 * (part.from.p_px + part.to.p_px), {}});
        }
        if (middles.empty()) break;
        look_at_all(rays, middles);
        found.counts.rays += middles.size();
        halves.clear();
        auto middle = middles.begin();
        for (const CellWay& part : parts) {
            if (!is_long(part)) {
                halves.push_back(part);
                continue;
            }
            add_open({{part.from, *middle}, part.cell}, halves);
            add_open({{*middle, part.to}, part.cell}, halves);
            ++middle;
        }
        std::swap(parts, halves);
    }
    for (const CellWay& part : parts)
        add_crossing(rays, part, spacing_px, found);
}

std::vector<char> explain_all(const KnownLines& known,
                              const SightRays& rays,
                              std::span<const Way> ways,
                              Reach reach,
                              std::size_t& ray_count) {
    std::vector<Explanation> all;
    all.reserve(ways.size());
    for (const Way& way : ways)
        all.emplace_back(known, way, reach);
    std::vector<Explanation*> waiting;
    std::vector<Sample> samples;
    do {
        waiting.clear();
        samples.clear();
        for (Explanation& explanation : all) {
            if (!explanation.is_waiting()) continue;
            waiting.push_back(&explanation);
            samples.push_back({explanation.wanted_px(), {}});
        }
        look_at_all(rays, samples);
        ray_count += samples.size();
        for (std::size_t i = 0; i < waiting.size(); ++i)
            waiting[i]->go_on(samples[i]);
    } while (!waiting.empty());
    std::vector<char> is_explained(ways.size());
    std::ranges::transform(
        all, is_explained.begin(), [](const Explanation& e) { return e.is_explained(); });
    return is_explained;
}

}  // namespace ink::crosscheck
