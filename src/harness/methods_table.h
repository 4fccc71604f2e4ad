#pragma once

#include <string>
#include <vector>

#include "harness/entrants.h"

namespace ink::harness {

/// The columns of methods.csv, in order: method, role (method, floor, ceiling or exact), family,
/// marker, tunables, bytes_per_px, preset_of, source, params.
[[nodiscard]] const std::vector<std::string>& method_columns();

/// A line per bracket row (none, sampled, oracle), then one per entrant, in their order; no final
/// line break.
///
/// `tunables` is "name:low..high;..." with the ends within which `inkbench tune` searches, or
/// "name:a|b|c" for a choice or a flag; `params` is every parameter as rows.csv has it. Empty is
/// what nobody knows: the bytes of a method that plans by the scene, all but the role of a bracket
/// row.
[[nodiscard]] std::string method_lines(const std::vector<Entrant>& entrants);

/// methods.csv, heading and line breaks included.
[[nodiscard]] std::string methods_csv(const std::vector<Entrant>& entrants);

}  // namespace ink::harness
