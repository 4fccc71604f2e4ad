#pragma once

#include <string>
#include <vector>

namespace ink::cli {

/// Runs notebooks/figures.py with these arguments; what it prints goes where the program's own
/// output goes. Returns its exit code, 128 + signal if it was killed.
///
/// Python is $INKBENCH_PYTHON, or /usr/bin/python3. The script is that of the install prefix
/// (share/inkbench/notebooks), or of the source tree that the program was built from. Throws
/// core::Error, which says what to install, if Python cannot be started or the script is in neither
/// place.
[[nodiscard]] int run_figures_script(const std::vector<std::string>& arguments);

}  // namespace ink::cli
