#include "crosscheck/explanation.h"

#include <algorithm>

namespace ink::crosscheck {
namespace {

constexpr std::size_t kMostLines = 8;  ///< that one way may cross and be explained

}  // namespace

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

std::vector<char> explain_all(const KnownLines& known,
                              const SightRays& rays,
                              std::span<const Way> ways,
                              Explanation::Reach reach,
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
