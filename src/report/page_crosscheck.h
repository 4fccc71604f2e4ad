#pragma once

#include <string>
#include <vector>

#include "harness/row.h"

namespace ink::report {

/// How far the truths of `rows` agree with their cross-check, as HTML: a sentence with the pooled
/// and the worst rate, a table of each scene's worst view, and the views whose truth is
/// contradicted, by name. "" if no row was held against the cross-check.
[[nodiscard]] std::string crosscheck_html(const std::vector<harness::Row>& rows);

}  // namespace ink::report
