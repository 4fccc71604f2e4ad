#pragma once

#include <string>
#include <vector>

#include "harness/row.h"
#include "report/page_pictures.h"

namespace ink::report {

/// The names of the scenes that have pictures, in order: what anchors are made of.
[[nodiscard]] std::vector<std::string> pictured_scenes(const PageScenes& scenes);

/// The part of the page that shows them: legend, tools, a stage per scene. Where `first_method`
/// drew a scene it is the one that is seen at first.
[[nodiscard]] std::string scenes_html(const PageScenes& scenes,
                                      const std::vector<harness::Row>& rows,
                                      const std::string& first_method);

}  // namespace ink::report
