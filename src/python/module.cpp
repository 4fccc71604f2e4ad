// The Python module `inkbench`: its functions. Names, defaults and sentences are the program's.

#include <dlfcn.h>
#include <pybind11/pybind11.h>
#include <pybind11/stl.h>

#include <filesystem>
#include <map>
#include <numbers>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "catalogue/catalogue.h"
#include "core/error.h"
#include "core/parallel.h"
#include "core/param.h"
#include "draw/drawing.h"
#include "harness/suite.h"
#include "harness/tracing.h"
#include "methods/method_configs.h"
#include "methods/registry.h"
#include "python/arrays.h"
#include "python/results.h"
#include "score/intersections.h"

namespace ink::python {
namespace {

namespace py = pybind11;

constexpr double kRadPerDeg = std::numbers::pi / 180;

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

harness::SceneViews load(const std::string& scene,
                         const std::string& view,
                         int width_px,
                         int height_px) {
    harness::ViewRequest request;
    request.width_px = width_px;
    request.height_px = height_px;
    import::ImportLimits limits;
    limits.child = model_reader();
    return harness::load_one_view(scene, view, request, limits);
}

int checked_threads(int threads) {
    if (threads < 0 || threads > 1024) {
        throw core::Error("threads", std::to_string(threads) + " is not possible", "0..1024");
    }
    return threads == 0 ? core::hardware_threads() : threads;
}

py::list scenes() {
    py::list list;
    for (const catalogue::CatalogueEntry& entry : catalogue::catalogue()) {
        py::list views;
        for (const scene::Camera& camera : entry.make().cameras)
            views.append(camera.name);
        py::dict of;
        of["name"] = entry.name;
        of["split"] = scene::split_name(entry.split);
        of["views"] = views;
        of["summary"] = entry.summary;
        list.append(of);
    }
    return list;
}

py::list methods() {
    py::list list;
    for (const method::MethodInfo& info : methods::registry()) {
        py::dict params;
        for (const core::Param& param : info.params)
            params[py::str(param.name)] = core::format_param(param, param.default_value);
        py::dict of;
        of["name"] = info.name;
        of["summary"] = info.summary;
        of["source"] = info.source;
        of["params"] = params;
        list.append(of);
    }
    return list;
}

TruthArrays truth(const std::string& scene,
                  const std::string& view,
                  int width_px,
                  int height_px,
                  double crease_deg,
                  const std::string& intersections,
                  int threads) {
    harness::TraceOptions options;
    if (!(crease_deg >= 0 && crease_deg <= 180)) {
        throw core::Error("crease_deg", std::to_string(crease_deg) + " is no angle", "0..180");
    }
    options.truth.crease_rad = crease_deg * kRadPerDeg;
    options.truth.threads = checked_threads(threads);
    options.intersections = score::parse_intersections(intersections, "intersections");
    auto traced = [&] {
        const py::gil_scoped_release others_run;
        const harness::SceneViews of = load(scene, view, width_px, height_px);
        truth::SceneModel model(of.scene, options.truth);
        return harness::trace_view(model, of.views.front(), options);
    }();
    return TruthArrays(std::move(traced));
}

py::array draw(const std::string& method,
               const std::string& scene,
               const std::string& view,
               int width_px,
               int height_px,
               const std::map<std::string, std::string>& settings,
               int threads) {
    std::vector<std::string> texts;
    for (const auto& [key, value] : settings)
        texts.push_back(key + "=" + value);
    draw::Drawing drawing = [&] {
        const py::gil_scoped_release others_run;
        const std::vector<method::MethodConfig> configs = methods::make_configs(method, texts);
        if (configs.size() != 1) throw core::Error("method", "one is drawn", "the name of one");
        draw::DrawOptions options;
        options.threads = checked_threads(threads);
        return draw::make_drawing(load(scene, view, width_px, height_px), configs.front(), options);
    }();
    return array_of(std::move(drawing.edge_responses));
}

score::ScoreOptions options_of(double tolerance_px, int threshold, bool thin) {
    score::ScoreOptions options;
    options.tolerance_px = tolerance_px;
    options.threshold = threshold;
    options.thin = thin;
    score::check(options);
    return options;
}

score::Score score(const py::object& edges,
                   const py::object& truth,
                   double tolerance_px,
                   int threshold,
                   bool thin,
                   std::optional<int> band_px,
                   std::optional<int> ignore) {
    const core::Image<std::uint8_t> drawn = image_of(edges, "edges");
    const Reference reference =
        reference_of(truth, options_of(tolerance_px, threshold, thin), band_px, ignore);
    const py::gil_scoped_release others_run;
    return score::score(drawn, reference.truth, reference.options);
}

py::array score_curve(const py::object& edges,
                      const py::object& truth,
                      double tolerance_px,
                      bool thin,
                      std::optional<int> band_px,
                      std::optional<int> ignore) {
    const core::Image<std::uint8_t> drawn = image_of(edges, "edges");
    const Reference reference =
        reference_of(truth, options_of(tolerance_px, 128, thin), band_px, ignore);
    const auto curve = [&] {
        const py::gil_scoped_release others_run;
        return score::score_curve(drawn, reference.truth, reference.options);
    }();
    py::array_t<std::int64_t> counts({static_cast<py::ssize_t>(curve.size()), py::ssize_t{3}});
    auto to = counts.mutable_unchecked<2>();
    for (std::size_t i = 0; i < curve.size(); ++i) {
        const auto row = static_cast<py::ssize_t>(i);
        to(row, 0) = curve[i].k;
        to(row, 1) = curve[i].n_pred;
        to(row, 2) = curve[i].n_truth;
    }
    return counts;
}

}  // namespace

PYBIND11_MODULE(inkbench, module) {
    module.doc() =
        "Draws outlines, traces exact ones and scores one against the other. Images are "
        "arrays of uint8, (height, width), row 0 the top. Experiments are the program's.";
    // Raised for bad input, with the sentence that the program would print.
    py::register_exception<core::Error>(module, "Error", PyExc_ValueError);
    py::register_exception<truth::TooLarge>(module, "TooLarge", PyExc_MemoryError);
    add_results(module);
    module.def("scenes",
               &scenes,
               "The built-in scenes: a dict each, with name, split, views and summary.");
    module.def(
        "methods",
        &methods,
        "The methods: a dict each, with name, summary, source and params (defaults as text).");
    module.def(
        "truth",
        &truth,
        "Traces the exact outline of one view of a built-in scene or a model file; the first "
        "view unless one is named. Sizes are px, angles degrees; 0 threads are all that the "
        "machine has. intersections: above_crease or all, the others are ignored.",
        py::arg("scene"),
        py::arg("view") = "",
        py::kw_only(),
        py::arg("width_px") = 1280,
        py::arg("height_px") = 720,
        py::arg("crease_deg") = 40.0,
        py::arg("intersections") = "above_crease",
        py::arg("threads") = 0);
    module.def("draw",
               &draw,
               "Draws one view with one method: its edge responses, uint8, (height, width), 0 no "
               "line .. 255. settings are parameters of the method, name to text.",
               py::arg("method"),
               py::arg("scene"),
               py::arg("view") = "",
               py::kw_only(),
               py::arg("width_px") = 1280,
               py::arg("height_px") = 720,
               py::arg("settings") = std::map<std::string, std::string>(),
               py::arg("threads") = 1);
    module.def(
        "score",
        &score,
        "Scores a drawing, uint8, (height, width), light lines on dark, against a Truth or an "
        "array of labels. Matched pixels are at most tolerance_px (up to 8) apart. With a "
        "Truth, pixels within 6 px of the frame and ignored ones do not count, as in `compare`; "
        "with an array, band_px (0) and ignore (no label) say so.",
        py::arg("edges"),
        py::arg("truth"),
        py::kw_only(),
        py::arg("tolerance_px") = 2.0,
        py::arg("threshold") = 128,
        py::arg("thin") = true,
        py::arg("band_px") = py::none(),
        py::arg("ignore") = py::none());
    module.def(
        "score_curve",
        &score_curve,
        "The same at 99 thresholds: int64, (99, 3), columns k, n_pred, n_truth; row i counts "
        "pixels of at least (i + 1) / 100 of the full edge response.",
        py::arg("edges"),
        py::arg("truth"),
        py::kw_only(),
        py::arg("tolerance_px") = 2.0,
        py::arg("thin") = true,
        py::arg("band_px") = py::none(),
        py::arg("ignore") = py::none());
}

}  // namespace ink::python
