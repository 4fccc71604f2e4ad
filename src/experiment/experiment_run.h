#pragma once

#include <filesystem>
#include <functional>
#include <string>
#include <vector>

#include "experiment/block_store.h"
#include "experiment/block_work.h"
#include "experiment/experiment_plan.h"
#include "experiment/run_record.h"

namespace ink::experiment {

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

/// What every run folder may hold: removed before another run takes the folder.
void clear_run_folder(const std::filesystem::path& folder);

}  // namespace ink::experiment
