#pragma once

#include <filesystem>
#include <functional>
#include <string>
#include <vector>

#include "experiment/experiment_plan.h"
#include "experiment/experiment_tables.h"

namespace ink::experiment {

/// Which share of the blocks is computed.
struct Shard {
    int i = 1;  ///< 1..n
    int n = 1;

    [[nodiscard]] bool is_all() const { return n == 1; }
};

/// "2/4"; throws core::Error (where = "--shard") for anything else.
[[nodiscard]] Shard parse_shard(const std::string& text);

struct RunOptions {
    std::filesystem::path out;
    Shard shard = {};
    bool is_fresh = false;  ///< what an earlier run left in `out` is thrown away
    std::function<void(const std::string&)> say = [](const std::string&) {};  ///< takes a line
};

/// Computes the blocks that are not in `out` yet, and writes the tables when all are there; a shard
/// keeps its blocks for merge_shards instead.
///
/// Says first how much there is to do, how much of it is done, and how long it may take. Killed at
/// any moment, every finished block stays; the next run goes on behind it, and what is written in
/// the end has the same bytes as after an undisturbed run, columns of times aside. Throws
/// core::Error if `out` belongs to another plan or to another run at work, or cannot be written.
[[nodiscard]] RunOutcome run_experiment(const Plan& plan, const RunOptions& options);

/// Writes to `out` the tables of the shards in `folders`: the bytes that one run would write.
/// Throws core::Error that names the folder if one holds no shard, or one of another experiment, if
/// blocks are missing, or in two folders.
[[nodiscard]] RunOutcome merge_shards(const std::vector<std::filesystem::path>& folders,
                                      const std::filesystem::path& out);

}  // namespace ink::experiment
