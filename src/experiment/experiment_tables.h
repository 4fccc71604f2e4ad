#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "experiment/block_store.h"

namespace ink::experiment {

/// A table as its file will hold it.
struct FinishedTable {
    std::string name;
    std::string text;
};

/// The tables of an experiment whose blocks are all there, in plan order: the lines of the blocks,
/// with the times that the cost model predicts from all of them, and summary.csv or
/// stress_summary.csv where the plan has what they are made from. A function of its arguments
/// alone: whoever computed which block, the bytes are the same. Times are empty if the plan says
/// so.
[[nodiscard]] std::vector<FinishedTable> finished_tables(const PlanRecord& record,
                                                         const std::vector<KeptBlock>& blocks);

/// How a run or a merge ended.
struct RunOutcome {
    bool is_interrupted = false;                     ///< Ctrl-C: what was finished is kept
    std::vector<std::string> faults = {};            ///< why the run is void
    std::vector<std::filesystem::path> tables = {};  ///< that were written; none of a shard
};

/// Writes the tables of a complete set of blocks, then says so in plan.toml, then lets the blocks
/// go: in this order, so that a kill in between costs nothing. A run with faults keeps them.
[[nodiscard]] RunOutcome finish_run(const BlockStore& store,
                                    PlanRecord record,
                                    const std::vector<KeptBlock>& blocks);

}  // namespace ink::experiment
