#pragma once

#include <pybind11/pybind11.h>

#include "python/asked.h"

namespace ink::python {

/// The keywords of `compare`.
[[nodiscard]] const Keywords& compare_keywords();

/// Draws, traces, scores and times methods on all views of scenes, or by these
/// cameras alone, as the command `compare` does,
/// and gives the lines of rows.csv: a dict each, of columns and values, None where a field is
/// empty.
///
/// `functions` are methods by name: called with the Buffers of a view, each returns edge responses.
/// What one throws ends the comparison.
[[nodiscard]] pybind11::list compare(const pybind11::object& scenes,
                                     const pybind11::dict& functions,
                                     const pybind11::object& cameras,
                                     const pybind11::kwargs& given);

}  // namespace ink::python
