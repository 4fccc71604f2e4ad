#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "crosscheck/known_lines.h"

namespace ink::crosscheck {

/// Finds out whether the way between two samples crosses known lines alone: it is followed over the
/// surface to the first feature edge, which must be a known line, and from what is seen just beyond
/// that on to the next; from the other end where that fails.
///
/// Asks for one look at a time, so that those of many ways can be made together. Borrows the lines.
class Explanation {
  public:
    /// Of the whole way, or only of the first line that it crosses.
    enum class Reach { whole, first_line };

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

/// For each way 1 if it is explained, else 0. Adds to `rays` the looks it took.
[[nodiscard]] std::vector<char> explain_all(const KnownLines& known,
                                            const SightRays& rays,
                                            std::span<const Way> ways,
                                            Explanation::Reach reach,
                                            std::size_t& ray_count);

}  // namespace ink::crosscheck
