#include "python/buffers.h"

#include <fmt/format.h>

#include <string>
#include <utility>

namespace ink::python {

namespace py = pybind11;
namespace {

/// An array of `planes` images of one size, (height, width, planes).
template <class T, class At>
py::array_t<T> interleaved(const core::Image<At>& size, std::size_t planes, auto value_of) {
    const auto height = static_cast<py::ssize_t>(size.height_px());
    const auto width = static_cast<py::ssize_t>(size.width_px());
    py::array_t<T> array({height, width, static_cast<py::ssize_t>(planes)});
    T* to = array.mutable_data();
    for (std::size_t i = 0; i < size.size(); ++i)
        for (std::size_t plane = 0; plane < planes; ++plane)
            *to++ = value_of(i, plane);
    return array;
}

}  // namespace

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

BufferArrays::BufferArrays(entrants::ViewBuffers&& buffers, const std::string& view_json)
    : depth(array_of(std::move(buffers.w))),
      normal(interleaved<float>(
          buffers.object,
          3,
          [&](std::size_t i, std::size_t plane) { return buffers.normal[plane].data()[i]; })),
      object(array_of(std::move(buffers.object))),
      patch(array_of(std::move(buffers.patch))),
      triangle(array_of(std::move(buffers.triangle))),
      material(array_of(std::move(buffers.material))),
      view(py::module_::import("json").attr("loads")(view_json)) {
    view.attr("pop")("files");  // there are none
}

py::array layer_array(const method::Layer& layer) {
    if (!layer.codes.empty()) {
        return interleaved<std::uint16_t>(
            layer.rgb, layer.codes.size(), [&](std::size_t i, std::size_t plane) {
                return layer.codes[plane].data()[i];
            });
    }
    return interleaved<std::uint8_t>(layer.rgb, 3, [&](std::size_t i, std::size_t channel) {
        return layer.rgb.data()[i][static_cast<int>(channel)];
    });
}

void add_buffers(py::module_& module) {
    py::class_<BufferArrays>(
        module,
        "Buffers",
        "What each pixel centre of a view sees. Of the sky every id is 2^32 - 1.")
        .def_readonly("depth",
                      &BufferArrays::depth,
                      "float32, (height, width): distance along the view direction in world units, "
                      "infinity for the sky.")
        .def_readonly(
            "normal",
            &BufferArrays::normal,
            "float32, (height, width, 3): x right, y up, z to the eye, of length 1; 0 for "
            "the sky. Interpolated over smooth patches.")
        .def_readonly("object", &BufferArrays::object, "uint32, (height, width): the object.")
        .def_readonly("patch",
                      &BufferArrays::patch,
                      "uint32, (height, width): the smooth patch, which ends at creases.")
        .def_readonly("triangle",
                      &BufferArrays::triangle,
                      "uint32, (height, width): the triangle, counted through the scene.")
        .def_readonly("material", &BufferArrays::material, "uint32, (height, width): its material.")
        .def_readonly("view",
                      &BufferArrays::view,
                      "A dict: scene, view, size, camera, matrices, and conventions in words.");
}

}  // namespace ink::python
