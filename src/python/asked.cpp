#include "python/asked.h"

#include <dlfcn.h>
#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <filesystem>
#include <utility>

#include "core/error.h"
#include "core/named.h"
#include "core/param.h"
#include "core/parse_number.h"
#include "core/split_list.h"
#include "experiment/options/option_table.h"

namespace ink::python {

namespace py = pybind11;
using experiment::option_table;
using experiment::ViewOptions;

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

/// The texts of a sequence; of anything else, the one of it.
std::vector<std::string> texts_of(const py::handle& value) {
    if (py::isinstance<py::str>(value) || !py::hasattr(value, "__iter__")) return {text_of(value)};
    std::vector<std::string> texts;
    for (const py::handle each : value)
        texts.push_back(text_of(each));
    return texts;
}

/// A point, "X,Y,Z", or a size, "WIDTHxHEIGHT".
std::string joined(const py::handle& value, const char* between) {
    return fmt::format("{}", fmt::join(texts_of(value), between));
}

template <class T>
T number_of(const py::handle& value, const char* option, const char* accepted) {
    const std::string text = text_of(value);
    const auto number = core::parse_number<T>(text);
    if (!number) throw core::Error(option, fmt::format("'{}' is no number", text), accepted);
    return *number;
}

struct ViewKeyword {
    const char* name;
    void (*set)(ViewOptions& options, const py::handle& value);
};
constexpr std::array kViewKeywords = {
    ViewKeyword{"size", [](ViewOptions& o, const py::handle& v) { o.size = joined(v, "x"); }},
    ViewKeyword{"views", [](ViewOptions& o, const py::handle& v) { o.views = text_of(v); }},
    ViewKeyword{"up", [](ViewOptions& o, const py::handle& v) { o.up = text_of(v); }},
    ViewKeyword{"projection",
                [](ViewOptions& o, const py::handle& v) {
                    const bool is_list = !py::isinstance<py::str>(v);
                    o.projection =
                        is_list ? fmt::format("{}", fmt::join(texts_of(v), ",")) : text_of(v);
                }},
    ViewKeyword{"fit", [](ViewOptions& o, const py::handle& v) { o.fit = text_of(v); }},
    ViewKeyword{"margin",
                [](ViewOptions& o, const py::handle& v) {
                    o.margin = number_of<double>(v, "--margin", "a share of the frame");
                }},
    ViewKeyword{"objects", [](ViewOptions& o, const py::handle& v) { o.objects = texts_of(v); }},
    ViewKeyword{"time_s",
                [](ViewOptions& o, const py::handle& v) {
                    o.time_s = number_of<double>(v, "--time", "seconds");
                }},
    ViewKeyword{"frame",
                [](ViewOptions& o, const py::handle& v) {
                    o.frame = number_of<int>(v, "--frame", "a stored frame's number");
                }},
    ViewKeyword{"animation", [](ViewOptions& o, const py::handle& v) { o.animation = text_of(v); }},
    ViewKeyword{"seams", [](ViewOptions& o, const py::handle& v) { o.seams = text_of(v); }}};

std::string key_of(const std::string& row) {
    return experiment::place_of(option_table().param(option_table().row(row))).key;
}

/// The texts of an option and how messages call it: as the command line does, where it has it.
std::vector<core::GivenText> given_texts(std::size_t row, const py::handle& value) {
    const core::Param& param = option_table().param(row);
    const std::string& flag = option_table().options[row].flag;
    const std::string where =
        flag.empty() ? experiment::place_of(param).key : flag.substr(0, flag.find(','));
    const bool is_path = param.name == "grid.scenes" || param.name == "grid.presets" ||
                         param.name == "grid.entrants";
    std::vector<core::GivenText> given;
    for (const std::string& text : texts_of(value)) {
        const bool is_list = param.kind == core::ParamKind::list && !is_path;
        for (std::string& part : is_list ? core::split_list(text) : std::vector{text})
            given.push_back({std::move(part), where});
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

std::vector<std::string> names_of(const Keywords& keywords) {
    std::vector<std::string> names;
    for (const std::string& row : keywords.rows)
        names.push_back(key_of(row));
    for (const ViewKeyword& keyword : kViewKeywords)
        names.emplace_back(keyword.name);
    if (keywords.has_settings) names.emplace_back("settings");
    return names;
}

/// The request for these cameras, or without any as the options have it.
harness::ViewRequest request_of(const std::vector<Camera>& cameras,
                                bool has_size,
                                const ViewOptions& options) {
    if (cameras.empty()) return view_request(options);
    if (options.up)
        throw core::Error("up", "each Camera has its own", "up for views by name, without cameras");
    harness::ViewRequest all;
    for (const Camera& camera : cameras) {
        ViewOptions with_camera = options;
        camera.put_into(with_camera);
        harness::ViewRequest one = view_request(with_camera);
        const bool is_other_size = one.width_px != all.width_px || one.height_px != all.height_px;
        if (has_size || (!all.cameras.empty() && is_other_size)) {
            throw core::Error("--size",
                              has_size ? "the camera has one" : "the cameras have several",
                              "one size, as Camera(..., size=(WIDTH, HEIGHT))");
        }
        one.cameras.insert(one.cameras.begin(), all.cameras.begin(), all.cameras.end());
        all = std::move(one);
    }
    return all;
}

}  // namespace

std::string text_of(const py::handle& value) {
    const std::string text = py::str(value);
    return text == "True" ? "true" : text == "False" ? "false" : text;
}

void Camera::put_into(ViewOptions& options) const {
    options.size = joined(size, "x");
    options.eyes = {joined(eye, ",")};
    options.targets.clear();
    if (!target.is_none()) options.targets = {joined(target, ",")};
    options.up = joined(up, ",");
    if (parallel_height.is_none()) {
        options.fov_deg = number_of<double>(fov_deg, "--fov", "1..170");
    } else {
        options.parallel_height =
            number_of<double>(parallel_height, "--parallel", "a length above 0");
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
    return text + fmt::format("\n\n{}: as the program's options of views (inkbench draw --help).\n",
                              fmt::join(core::names_of(kViewKeywords), ", "));
}

Asked read_asked(const Keywords& keywords, const py::handle& view, const py::dict& given) {
    Asked asked{keywords.usual};
    ViewOptions options;
    for (const auto& [name, value] : given) {
        const std::string key = text_of(name);
        if (value.is_none()) continue;
        if (const ViewKeyword* of_view = core::find_named(kViewKeywords, key)) {
            of_view->set(options, value);
            continue;
        }
        if (keywords.has_settings && key == "settings") {
            add_settings("", value, asked.experiment.settings);
            continue;
        }
        const auto row = std::find_if(keywords.rows.begin(),
                                      keywords.rows.end(),
                                      [&](const std::string& each) { return key_of(each) == key; });
        if (row == keywords.rows.end()) {
            throw core::Error(
                key, "there is no such keyword", core::known_names(names_of(keywords), key));
        }
        const std::size_t i = option_table().row(*row);
        option_table().rows.set(asked.experiment, i, given_texts(i, value), "it");
    }
    std::vector<Camera> cameras;
    if (py::isinstance<py::list>(view) || py::isinstance<py::tuple>(view)) {
        for (const py::handle each : view) {
            if (!py::isinstance<Camera>(each)) {
                throw core::Error(
                    "cameras", fmt::format("'{}' is no Camera", text_of(each)), "Camera(eye, ...)");
            }
            cameras.push_back(each.cast<Camera>());
        }
    } else if (py::isinstance<Camera>(view)) {
        cameras.push_back(view.cast<Camera>());
    } else {
        asked.view = text_of(view);
    }
    asked.views = request_of(cameras, given.contains("size"), options);
    asked.views.limits.child = model_reader();
    return asked;
}

void add_camera(py::module_& module) {
    py::class_<Camera>(module, "Camera", "A camera that is set by hand, and the size of its image.")
        .def(py::init([](py::object eye,
                         py::object target,
                         py::object up,
                         py::object fov_deg,
                         py::object size,
                         py::object parallel_height) {
                 Camera camera{std::move(eye),
                               std::move(target),
                               std::move(up),
                               std::move(fov_deg),
                               std::move(parallel_height),
                               std::move(size)};
                 ViewOptions options;
                 camera.put_into(options);
                 (void)view_request(options);
                 return camera;
             }),
             "Points are in the coordinates of the model's file; without a target it looks at the "
             "scene's centre. fov_deg is vertical, size width and height in px. With "
             "parallel_height it is a "
             "parallel camera that sees so much of the scene's units, and has no fov_deg.",
             py::arg("eye"),
             py::arg("target") = py::none(),
             py::arg("up") = py::make_tuple(0, 1, 0),
             py::arg("fov_deg") = experiment::kFov_deg,
             py::arg("size") = py::make_tuple(1280, 720),
             py::arg("parallel_height") = py::none())
        .def_readonly("eye", &Camera::eye, "Where it is.")
        .def_readonly("target", &Camera::target, "What it looks at; None for the centre.")
        .def_readonly("up", &Camera::up, "What is up in the image.")
        .def_readonly("fov_deg", &Camera::fov_deg, "Vertical field of view in degrees.")
        .def_readonly("parallel_height",
                      &Camera::parallel_height,
                      "Height that a parallel camera sees; None for a pinhole.")
        .def_readonly("size", &Camera::size, "Width and height of the image in px.");
}

}  // namespace ink::python
