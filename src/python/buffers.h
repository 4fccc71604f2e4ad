#pragma once

#include <pybind11/numpy.h>

#include "entrants/view_files.h"
#include "method/method.h"

namespace ink::python {

/// What each pixel centre of a view sees, as Python has it: its arrays take the images over.
struct BufferArrays {
    pybind11::array depth;
    pybind11::array normal;
    pybind11::array object;
    pybind11::array patch;
    pybind11::array triangle;
    pybind11::array material;
    pybind11::object view;  ///< a dict, of view_json

    /// `view_json` is that of the view (entrants/view_files.h).
    BufferArrays(entrants::ViewBuffers&& buffers, const std::string& view_json);
};

/// A method's layer: the codes that it is of, uint16, (height, width, planes), else its image,
/// uint8, (height, width, 3).
[[nodiscard]] pybind11::array layer_array(const method::Layer& layer);

/// Adds the class Buffers to the module.
void add_buffers(pybind11::module_& module);

}  // namespace ink::python
