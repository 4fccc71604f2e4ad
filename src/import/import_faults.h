#pragma once

#include <string>

namespace ink::import {

/// Misbehaves as the stem of `path` asks, in the test build of the import child only: `crash`,
/// `abort`, `hang`, `sleep`, `hungry` (memory), `quit` (an exit without an answer), `babble`
/// (nonsense for an answer), `flood` (an endless answer), `linger` (closes its answer and stays).
/// Else returns.
void provoke_fault(const std::string& path, int output_fd);

}  // namespace ink::import
