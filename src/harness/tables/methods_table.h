#pragma once

#include <string>
#include <vector>

#include "harness/method_configs.h"

namespace ink::harness {

/// The columns of methods.csv, in order: method, role (method, floor, ceiling or exact), family,
/// marker, tunables, bytes_per_px, preset_of, source, params.
[[nodiscard]] const std::vector<std::string>& method_columns();

/// A line per baseline (none, sampled, oracle), then one per configuration, in their order; no
/// final line break.
///
/// `tunables` is "name:low..high;..." with the ends within which `inkbench tune` searches, or
/// "name:a|b|c" for a choice or a flag; `params` is every parameter as rows.csv has it. Empty is
/// what nobody knows: the bytes of a method that plans by the scene, all but the role of a baseline
/// .
[[nodiscard]] std::string method_lines(const std::vector<MethodConfig>& configs);

/// methods.csv, heading and line breaks included.
[[nodiscard]] std::string methods_csv(const std::vector<MethodConfig>& configs);

}  // namespace ink::harness
