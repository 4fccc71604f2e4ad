#pragma once

#include <string>
#include <vector>

#include "core/tables/table.h"
#include "method/method_config.h"

namespace ink::harness {

/// The columns of methods.csv: method, role (method, floor, one_sample or exact), family, marker,
/// tunables, bytes_per_px, ink, preset_of, source, params.
[[nodiscard]] const core::TableInfo& methods_table();

/// methods.csv: a line per baseline (none, sampled, exact_corner, oracle), then one per
/// configuration, in their order.
///
/// `tunables` is "name:low..high;..." with the ends within which `inkbench tune` searches, or
/// "name:a|b|c" for a choice or a flag; `params` is every parameter as rows.csv has it. Empty is
/// what nobody knows: the bytes of a method that plans by the scene, all but the role of a
/// baseline.
[[nodiscard]] std::string methods_csv(const std::vector<method::MethodConfig>& configs);

}  // namespace ink::harness
