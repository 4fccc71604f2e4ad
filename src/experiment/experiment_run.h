#pragma once

#include <chrono>
#include <filesystem>
#include <functional>
#include <mutex>
#include <string>
#include <vector>

#include "core/progress.h"
#include "experiment/block_store.h"
#include "experiment/experiment_plan.h"
#include "experiment/run_record.h"

namespace ink::experiment {

/// Which share of the blocks is computed.
struct Shard {
    int i = 1;  ///< 1..n
    int n = 1;

    [[nodiscard]] bool is_all() const { return n == 1; }
};

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

/// "2/4"; throws core::Error (where = "--shard") for anything else.
[[nodiscard]] Shard parse_shard(const std::string& text);

struct RunOptions {
    std::filesystem::path out;
    Shard shard = {};
    /// Scenes that are worked on at a time, at most; 0: one on every core, or on as many as a timed
    /// drawing takes. Rows do not depend on it, times aside.
    int lanes = 0;
    bool is_forced = false;  ///< a run that is in `out`, this one or another, is thrown away
    std::function<void(const std::string&)> say = [](const std::string&) {};  ///< takes a line
    /// Called when the program is about to be cut off (core::InterruptGuard), with the tables of
    /// what is finished in `out`.
    std::function<void()> cut_off = [] {};
};

/// How a run or a merge ended.
struct RunOutcome {
    bool is_interrupted = false;  ///< Ctrl-C: what was finished is kept, and in the tables
    RunRecord record;             ///< as run.toml has it now
};

/// Computes the blocks that are not in `out` yet and writes the run folder; a shard keeps its
/// blocks for merge_shards instead.
///
/// Says first how much there is to do, how much of it is done, and how long it may take. Killed at
/// any moment, every finished block stays; the next run goes on behind it, and what is written in
/// the end has the same bytes as after an undisturbed run, columns of times aside. After Ctrl-C the
/// tables hold the finished blocks, and run.toml lists what is missing. Throws core::Error if `out`
/// holds another run and `is_forced` is not set, if another run is at work there, or if it cannot
/// be written.
[[nodiscard]] RunOutcome run_experiment(const Plan& plan, const RunOptions& options);

/// Writes to `out` the run folder of the shards in `folders`: the bytes that one run would write.
/// Throws core::Error that names the folder if one holds no shard, or one of another run, if blocks
/// are missing, or in two folders. With `is_partial` blocks may be missing: the tables then hold
/// what is there, and run.toml lists the rest.
[[nodiscard]] RunOutcome merge_shards(const std::vector<std::filesystem::path>& folders,
                                      const std::filesystem::path& out,
                                      bool is_partial = false);

/// Writes tables, images and run.toml of the blocks that are in `store`, then lets the blocks go if
/// all are there and the run is valid: in this order, so that a kill in between costs nothing.
/// `missing` are the keys of the blocks that are not there.
[[nodiscard]] RunOutcome write_run(const BlockStore& store,
                                   RunRecord record,
                                   const std::vector<std::string>& missing);

/// Makes sure that `out` holds no other run than `mine`: with `is_forced` by throwing it away, else
/// by core::Error (where = the folder), also for results without a run.toml.
void take_folder(const std::filesystem::path& out, const RunRecord& mine, bool is_forced);

}  // namespace ink::experiment
