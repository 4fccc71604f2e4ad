#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "experiment/block_store.h"
#include "experiment/run_record.h"

namespace ink::experiment {

/// A table as its file will hold it.
struct FinishedTable {
    std::string name;
    std::string text;
};

/// The tables of the finished blocks of a run, in plan order: their lines, with the times that the
/// cost model predicts from all of them, and summary.csv, differences.csv or axis_summary.csv
/// where the run has what they are made from. A function of the blocks alone: whoever computed
/// which, the bytes are the same. Blocks that are missing leave their lines out, and those of other
/// tables about cells that rows.csv lacks then.
[[nodiscard]] std::vector<FinishedTable> finished_tables(const RunRecord& record,
                                                         const BlockStore& store);

}  // namespace ink::experiment
