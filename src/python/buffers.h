#pragma once

#include <pybind11/numpy.h>

#include <cstdint>
#include <string>
#include <utility>

#include "core/image.h"
#include "entrants/view_files.h"
#include "method/method.h"

namespace ink::python {

/// An array over the pixels of an image, which it takes over: nothing is copied. Shape (height,
/// width), row 0 the top.
template <class T>
[[nodiscard]] pybind11::array_t<T> array_of(core::Image<T>&& image) {
    auto* owned = new core::Image<T>(std::move(image));
    const pybind11::capsule owner(owned, [](void* p) { delete static_cast<core::Image<T>*>(p); });
    return pybind11::array_t<T>({static_cast<pybind11::ssize_t>(owned->height_px()),
                                 static_cast<pybind11::ssize_t>(owned->width_px())},
                                owned->data(),
                                owner);
}

/// The image in an array of uint8, shape (height, width), read where it lies (any strides) and
/// copied once, into the program's own rows.
///
/// Raises TypeError for anything but an array of uint8, ValueError for another number of
/// dimensions. `name` is what messages call it.
[[nodiscard]] core::Image<std::uint8_t> image_of(const pybind11::handle& array,
                                                 const std::string& name);

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
