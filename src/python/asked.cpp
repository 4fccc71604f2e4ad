#include "python/asked.h"

#include <dlfcn.h>
#include <fmt/format.h>
#include <fmt/ranges.h>
#include <pybind11/stl.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <map>
#include <utility>

#include "core/error.h"
#include "core/param.h"
#include "core/split_list.h"
#include "experiment/options/option_table.h"

namespace ink::python {

namespace py = pybind11;
using experiment::option_table;

namespace {

/// The program that reads models: from the folder of this module as the build or the installation
/// has it.
std::filesystem::path model_reader() {
    Dl_info info{};
    dladdr(reinterpret_cast<const void*>(&model_reader), &info);
    const auto folder = std::filesystem::absolute(info.dli_fname).parent_path();
    for (const char* from_module : {INK_READER_IN_BUILD, INK_READER_INSTALLED}) {
        const auto reader = (folder / from_module).lexically_normal();
        if (std::filesystem::exists(reader)) return reader;
    }
    return (folder / INK_READER_INSTALLED).lexically_normal();
}

bool is_sequence(const py::handle& value) {
    return !py::isinstance<py::str>(value) && py::hasattr(value, "__iter__");
}

/// What a value is where it is a number that a double can hold. True and False are none.
std::optional<double> number_of(const py::handle& value) try {
    const std::string text = text_of(value);
    if (text == "true" || text == "false") return std::nullopt;
    return value.cast<double>();
} catch (const py::cast_error&) {
    return std::nullopt;
}

/// The elements of a sequence, or the one that is none: texts, with their numbers.
std::vector<core::GivenText> elements_of(const py::handle& value, const std::string& where) {
    if (!is_sequence(value)) return {{text_of(value), where, number_of(value)}};
    std::vector<core::GivenText> elements;
    for (const py::handle each : value)
        elements.push_back({text_of(each), where, number_of(each)});
    return elements;
}

std::string joined(const py::handle& value, const char* between) {
    std::string text;
    for (const core::GivenText& each : elements_of(value, ""))
        text += (text.empty() ? "" : between) + each.text;
    return text;
}

/// The numbers of a sequence of them; none of a text, which says them in the program's way.
std::vector<double> numbers_of(const py::handle& value) try {
    std::vector<double> numbers;
    if (!is_sequence(value)) return numbers;
    for (const py::handle each : value)
        numbers.push_back(each.cast<double>());
    return numbers;
} catch (const py::cast_error&) {
    return {};
}

glm::dvec3 point_of(const py::handle& value, const core::GivenText& given) {
    const std::vector<double> numbers = numbers_of(value);
    if (numbers.size() == 3 && std::isfinite(numbers[0] + numbers[1] + numbers[2]))
        return {numbers[0], numbers[1], numbers[2]};
    return experiment::parse_point(given);
}

experiment::ImageSize size_of(const py::handle& value) {
    const std::vector<double> numbers = numbers_of(value);
    const auto is_whole = [](double number) {
        return std::abs(number) < 1e9 && number == std::round(number);
    };
    if (numbers.size() != 2 || !std::ranges::all_of(numbers, is_whole))
        return experiment::parse_image_size(joined(value, "x"), "--size");
    const experiment::ImageSize size{static_cast<int>(numbers[0]), static_cast<int>(numbers[1])};
    harness::check_size(size.width_px, size.height_px);
    return size;
}

/// Rows of views that are keywords too; a Camera has the others.
const std::vector<std::string>& rows_of_views() {
    static const std::vector<std::string> rows = core::split_list(
        "grid.sizes, views.views, views.up, grid.projections, views.fit, views.margin, "
        "views.objects, views.time_s, views.frame, views.animation, grid.seams");
    return rows;
}

/// Where a command takes one of a list, the keyword is called as its option.
std::string key_of(const std::string& name) {
    const std::size_t row = option_table().row(name);
    const experiment::Option& option = option_table().options[row];
    return option.is_once ? option.flag.substr(2)
                          : experiment::place_of(option_table().param(row)).key;
}

/// What is given for an option, and how messages call it: as the command line does, where it has
/// it. Numbers stay what they are.
std::vector<core::GivenText> given_texts(std::size_t row, const py::handle& value) {
    const core::Param& param = option_table().param(row);
    const std::string& flag = option_table().options[row].flag;
    const std::string where =
        flag.empty() ? experiment::place_of(param).key : flag.substr(0, flag.find(','));
    const bool is_path = param.name == "grid.scenes" || param.name == "grid.presets" ||
                         param.name == "grid.entrants" || param.name == "views.objects";
    std::vector<core::GivenText> given;
    for (const auto& [text, place, number] : elements_of(value, where)) {
        const bool is_list = param.kind == core::ParamKind::list && !is_path;
        for (std::string& part : is_list ? core::split_list(text) : std::vector{text})
            given.push_back({std::move(part), place, number});
    }
    return given;
}

/// "key=value" of each; a dict as a value is of the method that is its key.
void add_settings(const std::string& prefix,
                  const py::handle& settings,
                  std::vector<std::string>& texts) {
    if (!py::hasattr(settings, "items")) {
        throw core::Error(
            "settings", fmt::format("'{}' is no dict", text_of(settings)), "{parameter: value}");
    }
    for (const py::handle item : settings.attr("items")()) {
        const auto [key, value] = item.cast<std::pair<py::object, py::object>>();
        if (py::hasattr(value, "items")) {
            add_settings(prefix + text_of(key) + ".", value, texts);
        } else {
            texts.push_back(prefix + text_of(key) + "=" + text_of(value));
        }
    }
}

std::vector<std::string> rows_of(const Keywords& keywords) {
    std::vector<std::string> rows = keywords.rows;
    rows.insert(rows.end(), rows_of_views().begin(), rows_of_views().end());
    return rows;
}

/// The row of a keyword. Throws core::Error for another.
std::size_t row_of(const Keywords& keywords, const std::string& key) {
    std::vector<std::string> known;
    for (const std::string& name : rows_of(keywords)) {
        known.push_back(key_of(name));
        if (known.back() == key) return option_table().row(name);
    }
    if (keywords.has_settings) known.emplace_back("settings");
    throw core::Error(key, "there is no such keyword", core::known_names(known, key));
}

/// Asks for these cameras, if there are any, in images of their size.
void ask_cameras(const std::vector<Camera>& cameras, const py::dict& given, Asked& asked) {
    if (cameras.empty()) return;
    if (given.contains("up"))
        throw core::Error("up", "each Camera has its own", "up for views by name, without cameras");
    const experiment::ImageSize size = cameras.front().size_px;
    const bool is_one_size =
        std::ranges::all_of(cameras, [&](const Camera& camera) { return camera.size_px == size; });
    if (given.contains("size") || !is_one_size) {
        throw core::Error("--size",
                          is_one_size ? "the camera has one" : "the cameras have several",
                          "one size, as Camera(..., size=(WIDTH, HEIGHT))");
    }
    asked.experiment.sizes = {size};
    for (const Camera& camera : cameras)
        asked.experiment.view_request.cameras.push_back(camera.request);
}

/// Cameras, one or several; the name of a view is put into `name`.
std::vector<Camera> cameras_of(const py::handle& view, std::string& name) {
    if (py::isinstance<Camera>(view)) return {view.cast<Camera>()};
    std::vector<Camera> cameras;
    if (!py::isinstance<py::list>(view) && !py::isinstance<py::tuple>(view)) {
        name = text_of(view);
        return cameras;
    }
    for (const py::handle each : view) {
        if (!py::isinstance<Camera>(each)) {
            throw core::Error(
                "cameras", fmt::format("'{}' is no Camera", text_of(each)), "Camera(eye, ...)");
        }
        cameras.push_back(each.cast<Camera>());
    }
    return cameras;
}

}  // namespace

std::string text_of(const py::handle& value) {
    const std::string text = py::str(value);
    return text == "True" ? "true" : text == "False" ? "false" : text;
}

Camera::Camera(const py::object& eye,
               const py::object& target,
               const py::object& up,
               double fov_deg,
               const py::object& size,
               std::optional<double> parallel_height)
    : size_px(size_of(size)) {
    request.eye_world = point_of(eye, {joined(eye, ","), "--eye"});
    if (!target.is_none())
        request.target_world = point_of(target, {joined(target, ","), "--target"});
    const core::GivenText up_text{joined(up, ","), "--up"};
    request.up_world = numbers_of(up).empty()
                           ? experiment::parse_direction(up_text)
                           : experiment::checked_direction(point_of(up, up_text), up_text);
    if (parallel_height) {
        request.height_world = harness::checked_height(*parallel_height);
    } else {
        request.fov_deg = harness::checked_fov_deg(fov_deg);
    }
}

std::string Keywords::text() const {
    std::string text;
    for (const std::string& name : rows) {
        const std::size_t row = option_table().row(name);
        // The sentence of a flag that switches off is of what is so then.
        const bool is_off = option_table().options[row].flag.starts_with("--no-") &&
                            option_table().param(row).kind == core::ParamKind::flag;
        text += fmt::format("\n\n{} = {}{}: {}.",
                            key_of(name),
                            fmt::join(option_table().texts(usual, row), ","),
                            is_off ? "; false" : "",
                            option_table().param(row).doc);
    }
    if (has_settings) {
        text +=
            "\n\nsettings = {}: Parameters of methods and their values, of any type; of one method "
            "alone as {method: {parameter: value}}.";
    }
    std::vector<std::string> of_views;
    for (const std::string& name : rows_of_views())
        of_views.push_back(key_of(name));
    return text + fmt::format("\n\n{}: as the program's options of views (inkbench draw --help).\n",
                              fmt::join(of_views, ", "));
}

Asked read_asked(const Keywords& keywords, const py::handle& view, const py::dict& given) {
    Asked asked{keywords.usual};
    ask_cameras(cameras_of(view, asked.view), given, asked);
    std::map<std::size_t, py::handle> by_row;  // they are set in the order of the table
    for (const auto& [name, value] : given) {
        const std::string key = text_of(name);
        if (value.is_none()) continue;
        if (keywords.has_settings && key == "settings") {
            add_settings("", value, asked.experiment.settings);
        } else {
            by_row[row_of(keywords, key)] = value;
        }
    }
    for (const auto& [row, value] : by_row) {
        if (option_table().param(row).name == "grid.sizes") {
            asked.experiment.sizes = {size_of(value)};
        } else {
            option_table().rows.set(asked.experiment, row, given_texts(row, value), "it");
        }
    }
    experiment::settle_views(asked.experiment.view_request);
    asked.experiment.view_request.limits.child = model_reader();
    return asked;
}

void add_camera(py::module_& module) {
    py::class_<Camera>(module, "Camera", "A camera that is set by hand, and the size of its image.")
        .def(py::init<const py::object&,
                      const py::object&,
                      const py::object&,
                      double,
                      const py::object&,
                      std::optional<double>>(),
             "Points are in the coordinates of the model's file; without a target it looks at the "
             "scene's centre. fov_deg is vertical, size width and height in px. With "
             "parallel_height it is a "
             "parallel camera that sees so much of the scene's units, and has no fov_deg.",
             py::arg("eye"),
             py::arg("target") = py::none(),
             py::arg("up") = py::make_tuple(0, 1, 0),
             py::arg("fov_deg") = harness::CameraRequest{}.fov_deg,
             py::arg("size") = py::make_tuple(1280, 720),
             py::arg("parallel_height") = py::none());
}

}  // namespace ink::python
