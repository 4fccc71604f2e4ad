#pragma once

#include <chrono>
#include <functional>
#include <mutex>
#include <string>
#include <vector>

#include "core/progress.h"
#include "experiment/block_store.h"
#include "experiment/experiment_plan.h"

namespace ink::experiment {

/// Which share of the blocks is computed.
struct Shard {
    int i = 1;  ///< 1..n
    int n = 1;

    [[nodiscard]] bool is_all() const { return n == 1; }
};

/// "8 s", "4 min", "1.5 h".
[[nodiscard]] std::string duration_text(double seconds);

/// The blocks of a run: which are wanted, which are there, and the work of computing the others.
///
/// Blocks of groups run beside each other on lanes (core::run_lanes): some trace, draw and score
/// while others do. A lane takes a group of its own while there is one, and then blocks of groups
/// that others have begun. Each is timed while the others work; where a timed loop was found to be
/// slower beside them, there is one lane. Blocks without a group come last and run alone. Borrows
/// plan and store.
class BlockWork {
  public:
    BlockWork(const Plan& plan, const BlockStore& store, std::vector<std::size_t> wanted);

    /// How much there is to do, how much of it is done, how long the rest may take.
    [[nodiscard]] std::string heading(const Shard& shard) const;

    /// Computes what is missing, on at most so many lanes (0: as many as fit the machine); false if
    /// an end was asked for before all was there. Rethrows what a block throws.
    [[nodiscard]] bool run(int lanes, const std::function<void(const std::string&)>& say);

    /// The end of a sentence where scenes had to be worked on one at a time, because others would
    /// have disturbed what is timed; else "".
    [[nodiscard]] const std::string& lanes_text() const { return lanes_text_; }

    /// Keys of the blocks of the whole plan that are not there.
    [[nodiscard]] std::vector<std::string> missing_of_plan() const;

  private:
    /// The missing blocks of a scene, in the order of the plan.
    struct Group {
        std::vector<std::size_t> blocks;
        std::size_t taken = 0;
        std::size_t done = 0;

        [[nodiscard]] bool is_taken() const { return taken == blocks.size(); }
    };

    [[nodiscard]] std::string estimate() const;
    [[nodiscard]] std::vector<Group> missing_groups() const;
    void try_neighbours();
    [[nodiscard]] double work_of(const std::vector<std::size_t>& blocks) const;
    void work_through(std::vector<Group>& groups);
    [[nodiscard]] Group* next_group(std::vector<Group>& groups, Group* mine) const;
    [[nodiscard]] bool compute(std::size_t block);
    void note(std::size_t block, double seconds);

    const Plan& plan_;
    const BlockStore& store_;
    std::vector<std::size_t> wanted_;
    std::vector<std::size_t> missing_;
    int lanes_ = 1;
    std::string lanes_text_;
    double known_work_ = 0;
    double known_s_ = 0;

    // What lanes share while they work; all above belongs to it, too.
    std::mutex mutex_;
    bool is_stopped_ = false;
    bool has_said_ = false;
    core::Progress* progress_ = nullptr;
    const std::function<void(const std::string&)>* say_ = nullptr;
    std::chrono::steady_clock::time_point start_;
};

}  // namespace ink::experiment
