#pragma once

#include <functional>
#include <map>
#include <string>
#include <vector>

#include "experiment/experiment.h"
#include "harness/tracing.h"

namespace ink::experiment {

/// A table that an experiment writes.
struct PlannedTable {
    std::string name;     ///< "rows.csv"
    std::string heading;  ///< the columns, joined by commas

    friend bool operator==(const PlannedTable&, const PlannedTable&) = default;
};

/// What a block came to.
struct BlockResult {
    std::map<std::string, std::string> lines;  ///< by table, every line ended; none: no entry
    std::vector<std::string> faults;           ///< why the whole run would be void
};

/// What is computed together: the cells of one view, whose drawings take turns (A B C A B C), so
/// that a machine that slows down slows all alike. Blocks depend on nothing but the plan.
struct Block {
    std::string key;  ///< what it is, for people and for its file; no two of a plan are equal
    int cells = 0;    ///< rows it will have, brackets counted
    double work = 0;  ///< seconds it may take on one core of 2022, to weigh blocks by
    /// Ctrl-C may cut it short; it is then done again.
    bool may_be_cut = false;
    std::function<BlockResult()> run;
};

/// An experiment taken apart: the order of blocks is the order of lines in every table.
struct Plan {
    std::string name;
    std::string identity;  ///< hash of all that rows depend on, the build included
    std::string build;     ///< version and commit, for messages
    bool times = true;
    bool one_place = true;  ///< one size and one number of threads: summaries mean something
    std::vector<PlannedTable> tables;
    std::vector<Block> blocks;

    [[nodiscard]] int cells() const;
};

/// Loads the scenes and lists the blocks. Throws core::Error for scenes that cannot be loaded, and
/// where = the file if nothing is left to do.
[[nodiscard]] Plan make_plan(const Experiment& experiment, const harness::TraceOptions& trace);

/// The indices of the blocks that shard `i` of `n` (1..n) computes: heaviest first, each goes to
/// the shard that has least to do, so that shards take about as long as each other. Every block
/// belongs to one shard, the same on every machine.
[[nodiscard]] std::vector<std::size_t> shard_blocks(const Plan& plan, int i, int n);

/// What a kind of experiment adds to its plan: tables and blocks.
void plan_compare(const Experiment& experiment, const harness::TraceOptions& trace, Plan& plan);
void plan_animation(const Experiment& experiment, const harness::TraceOptions& trace, Plan& plan);
void plan_stress(const Experiment& experiment, const harness::TraceOptions& trace, Plan& plan);

}  // namespace ink::experiment
