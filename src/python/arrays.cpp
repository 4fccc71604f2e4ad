#include "python/arrays.h"

#include <fmt/format.h>

namespace ink::python {

namespace py = pybind11;

core::Image<std::uint8_t> image_of(const py::handle& array, const std::string& name) {
    if (!py::isinstance<py::array>(array)) {
        throw py::type_error(
            fmt::format("{}: this is a {} (accepted: an array of uint8)",
                        name,
                        py::str(py::type::handle_of(array).attr("__name__")).cast<std::string>()));
    }
    const auto pixels = py::reinterpret_borrow<py::array>(array);
    if (!pixels.dtype().is(py::dtype::of<std::uint8_t>())) {
        throw py::type_error(fmt::format("{}: its values are {} (accepted: uint8)",
                                         name,
                                         py::str(pixels.dtype()).cast<std::string>()));
    }
    if (pixels.ndim() != 2) {
        throw py::value_error(fmt::format(
            "{}: it has {} dimensions (accepted: 2, height and width)", name, pixels.ndim()));
    }
    const auto values = py::array_t<std::uint8_t>(pixels).unchecked<2>();
    core::Image<std::uint8_t> image(static_cast<int>(values.shape(1)),
                                    static_cast<int>(values.shape(0)));
    for (py::ssize_t y = 0; y < values.shape(0); ++y) {
        std::uint8_t* to = image.row(static_cast<int>(y));
        for (py::ssize_t x = 0; x < values.shape(1); ++x)
            to[x] = values(y, x);
    }
    return image;
}

}  // namespace ink::python
