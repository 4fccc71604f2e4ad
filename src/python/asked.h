#pragma once

#include <pybind11/pybind11.h>

#include <optional>
#include <string>
#include <vector>

#include "experiment/experiment.h"

namespace ink::python {

/// A camera that is set by hand, and the size of its image: --eye, --target, --up, --fov,
/// --parallel and --size of the program, as Python has them.
struct Camera {
    /// Throws core::Error for what the program would refuse.
    Camera(const pybind11::object& eye,
           const pybind11::object& target,
           const pybind11::object& up,
           double fov_deg,
           const pybind11::object& size,
           std::optional<double> parallel_height);

    harness::CameraRequest request = {};
    experiment::ImageSize size_px;
};

/// Which keywords a function takes beside those of views, and what it has without them.
struct Keywords {
    std::vector<std::string> rows;  ///< of the option table; the keyword is the row's key
    experiment::Experiment usual = {};
    bool has_settings = false;

    /// Sentences on all of them, for a docstring.
    [[nodiscard]] std::string text() const;
};

/// What a function is asked, as the options of the program that it means.
struct Asked {
    /// `settings` and views too, with the model reader that is installed with this module.
    experiment::Experiment experiment;
    std::string view = {};  ///< the name of one, or ""

    [[nodiscard]] harness::ViewRequest views() const { return views_of(experiment); }
};

/// A value as the program's text for it: True is "true".
[[nodiscard]] std::string text_of(const pybind11::handle& value);

/// Reads what was given; None leaves what is usual. `view` is a name, a Camera, or a list of these
/// with images of one size. Throws core::Error with the program's sentences; for another keyword,
/// the accepted ones.
[[nodiscard]] Asked read_asked(const Keywords& keywords,
                               const pybind11::handle& view,
                               const pybind11::dict& given);

/// Adds the class Camera to the module.
void add_camera(pybind11::module_& module);

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
