#pragma once

#include <map>
#include <memory>
#include <string>
#include <vector>

#include "harness/rows/row_table.h"

namespace ink::harness {

/// The table of rows while it is put together.
using RowTable = core::TableOf<RowRecord>;

/// Adds soft F and the ink that it is made of.
void add_ink_columns(const core::PartOf<score::SoftScore>& soft);

/// Adds a column per cause: what false_positives and false_negatives are made of.
void add_cause_columns(RowTable& table);

/// Adds what was left undone: two columns per skip, and which skips were not allowed.
void add_skip_columns(RowTable& table);

/// Adds what the row comes from: program, machine, libraries. read_provenance() reads them.
void add_provenance_columns(RowTable& table);

/// The provenance that record `i` names, null if it is that of this program on this machine.
/// `known` keeps those that were read, so that rows of one source share it.
[[nodiscard]] std::shared_ptr<const core::Provenance> read_provenance(
    const core::CsvTable& table,
    std::size_t i,
    std::map<std::string, std::shared_ptr<const core::Provenance>>& known);

}  // namespace ink::harness
