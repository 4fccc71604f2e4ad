#pragma once

#include <filesystem>
#include <span>
#include <string>
#include <vector>

#include "harness/rows/row.h"
#include "harness/truths/compare_truths.h"
#include "truth/curve.h"

namespace ink::inspect {

/// What the cross-check says of a view's truth, for a terminal: lengths and both coverages per
/// class, the rate of disagreement, what it cost, and how much of what the cross-check lacks lies
/// on strips too thin to be seen. `curves` are the truth's.
[[nodiscard]] std::string crosscheck_summary(const harness::Crosscheck& check,
                                             std::span<const truth::Curve> curves);

/// Writes a PNG of twice the view's size: lines that both have grey, what only the curves or only
/// the cross-check have as dots in two colours. Throws core::Error if the file cannot be written.
void write_disagreement(const scene::View& view,
                        std::span<const truth::Curve> curves,
                        const harness::Agreement& agreement,
                        const std::filesystem::path& path);

/// One sentence over all rows: the pooled rate of disagreement, and the worst view's. "" if no row
/// was held against the cross-check.
[[nodiscard]] std::string crosscheck_sentence(const std::vector<harness::Row>& rows);

}  // namespace ink::inspect
