#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "harness/row.h"
#include "studies/skip_study.h"

namespace ink::report {

/// What the part on skips is about, in two sentences.
[[nodiscard]] std::string_view skips_intro();

/// What the methods left undone, pooled over `rows` and where most; what that is worth, from
/// `study`, which may be empty. "" if no row counts anything.
[[nodiscard]] std::string skips_html(const std::vector<harness::Row>& rows,
                                     const std::vector<studies::SkipTime>& study);

}  // namespace ink::report
