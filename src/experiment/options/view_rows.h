#pragma once

#include <glm/vec3.hpp>
#include <string>
#include <vector>

#include "experiment/options/option_table.h"

namespace ink::experiment {

/// Adds the rows that say which views are meant, and how they look, to the table of all options.
///
/// Commands have --views and --eye with what belongs to it, files `orbit`, `directions`,
/// `file_cameras` and `cameras`, a list of tables: rows of these are of one of the two alone.
void add_view_rows(OptionTable& table);

/// The rows of views as commands have them, in the order of help: --size, --views, --projection,
/// --parallel, --fit, --margin, --object, --eye, --target, --up, --fov, --time, --frame,
/// --animation, --seams.
[[nodiscard]] const std::vector<std::string>& view_rows();

/// Checks what was asked of views against each other, when all of it is there, and completes it: a
/// height of parallel views goes to cameras that are set by hand. Throws core::Error (where = the
/// option).
void settle_views(harness::ViewRequest& request);

/// What is up: an axis by its name, or a direction, "X,Y,Z". Throws core::Error (where = the
/// text's).
[[nodiscard]] glm::dvec3 parse_direction(const core::GivenText& given);

/// A direction, and the text that says so. Throws core::Error (where = the text's) if its length is
/// 0.
[[nodiscard]] glm::dvec3 checked_direction(const glm::dvec3& direction,
                                           const core::GivenText& given);

/// "X,Y,Z". Throws core::Error (where = the text's) for text that is no point.
[[nodiscard]] glm::dvec3 parse_point(const core::GivenText& given);

}  // namespace ink::experiment
