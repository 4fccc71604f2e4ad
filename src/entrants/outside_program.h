#pragma once

#include <filesystem>
#include <string>

#include "entrants/entrant.h"
#include "harness/outside_method.h"

namespace ink::entrants {

/// Images that `program` draws, called as `program view.json out.png` in a folder of its own under
/// the system's temporary folder, removed with the source.
///
/// The source throws core::Error (where = the program) that says how a call failed: it could not be
/// started, hung, crashed, ended with an exit code and what it last said, wrote no image or a wrong
/// one.
[[nodiscard]] harness::OutsideSource program_source(const std::filesystem::path& program,
                                                    const EntrantLimits& limits);

}  // namespace ink::entrants
