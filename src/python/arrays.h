#pragma once

#include <pybind11/numpy.h>

#include <cstdint>
#include <string>
#include <utility>

#include "core/image.h"

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

}  // namespace ink::python
