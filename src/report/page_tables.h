#pragma once

#include <string>
#include <vector>

#include "experiment/summary/summary.h"
#include "harness/row.h"

namespace ink::report {

/// The names of the scenes of `rows`, each once, in order of first appearance.
[[nodiscard]] std::vector<std::string> scenes_of(const std::vector<harness::Row>& rows);

/// F per scene and method as an HTML table whose cells are the darker the more is wrong. Scenes
/// that have a picture on the page link to it.
[[nodiscard]] std::string scene_heat_html(const std::vector<harness::Row>& rows,
                                          const std::vector<experiment::MethodSummary>& summaries,
                                          const std::vector<std::string>& pictured_scenes);

/// The cells that failed, with what went wrong; "" if none did.
[[nodiscard]] std::string failures_html(const std::vector<harness::Row>& rows);

/// Every row in a table that the page's script sorts and filters.
[[nodiscard]] std::string rows_html(const std::vector<harness::Row>& rows);

/// The anchor of a scene's pictures on the page.
[[nodiscard]] std::string scene_anchor(const std::vector<std::string>& pictured_scenes,
                                       const std::string& scene);

}  // namespace ink::report
