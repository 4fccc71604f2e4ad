#pragma once

#include <string>

#include "experiment/experiment.h"

namespace ink::experiment {

/// What an experiment asks for as a TOML document: scenes and views, methods with every parameter,
/// grids, how things are measured. Keys are sorted, so that equal experiments give equal texts. It
/// can be asked again (parse_experiment), but for methods that are made by code.
[[nodiscard]] std::string asked_text(const Experiment& experiment);

}  // namespace ink::experiment
