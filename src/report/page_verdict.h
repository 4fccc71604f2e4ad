#pragma once

#include <string>
#include <vector>

#include "experiment/summary/summary.h"
#include "harness/row.h"

namespace ink::report {

/// The summaries of all methods as an HTML table, the winner marked.
[[nodiscard]] std::string verdict_html(const std::vector<experiment::MethodSummary>& summaries);

/// The same table once per scene, each folded away behind the scene's name and its best method; ""
/// without rows. A scene's values are pooled over its views.
[[nodiscard]] std::string scene_verdicts_html(const std::vector<harness::Row>& rows);

}  // namespace ink::report
