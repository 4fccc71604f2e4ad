// The Python module `inkbench`: its functions. Names, defaults and sentences are the program's.

#include <pybind11/pybind11.h>
#include <pybind11/stl.h>

#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "core/error.h"
#include "core/parallel.h"
#include "core/param.h"
#include "draw/drawing.h"
#include "entrants/view_files.h"
#include "experiment/experiment_plan.h"
#include "harness/cells/skip_switches.h"
#include "harness/suite/suite.h"
#include "harness/truths/tracing.h"
#include "methods/method_configs.h"
#include "methods/registry.h"
#include "python/asked.h"
#include "python/buffers.h"
#include "python/results.h"

namespace ink::python {
namespace {

namespace py = pybind11;

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

const Keywords& truth_keywords() {
    static const Keywords keywords = [] {
        Keywords of_truth{{"measure.crease_deg",
                           "measure.creases",
                           "measure.weld_epsilon",
                           "measure.intersections",
                           "grid.threads"}};
        of_truth.usual.threads = {core::hardware_threads()};
        return of_truth;
    }();
    return keywords;
}

const Keywords& draw_keywords() {
    static const Keywords keywords{{"grid.threads", "measure.skips_off"}, {}, true};
    return keywords;
}

const Keywords& buffer_keywords() {
    static const Keywords keywords{{"measure.crease_deg"}};
    return keywords;
}

TruthArrays truth(const py::object& scene, const py::object& view, const py::kwargs& given) {
    const Asked asked = read_asked(truth_keywords(), view, given);
    const std::string name = text_of(scene);
    harness::TraceOptions options = experiment::trace_of(asked.experiment, {});
    options.truth.threads = asked.experiment.threads.front();
    auto traced = [&] {
        const py::gil_scoped_release others_run;
        const auto of = harness::load_one_view(name, asked.view, asked.views());
        truth::SceneModel model(of.scene, options.truth);
        return harness::trace_view(model, of.views.front(), options);
    }();
    return TruthArrays(std::move(traced));
}

/// Calls use(scene and view, configuration, options of drawing) while other Python threads run.
template <class Use>
auto drawn_by(const py::object& method,
              const py::object& scene,
              const py::object& view,
              const py::kwargs& given,
              Use use) {
    const Asked asked = read_asked(draw_keywords(), view, given);
    const std::string names = text_of(method);
    const std::string name = text_of(scene);
    const py::gil_scoped_release others_run;
    const auto configs = methods::make_configs(names, asked.experiment.settings);
    if (configs.size() != 1) throw core::Error("--method", "an image is of one", "one name");
    draw::DrawOptions options;
    options.threads = asked.experiment.threads.front();
    options.skips = harness::without_skips({}, asked.experiment.compare.skips_off);
    return use(harness::load_one_view(name, asked.view, asked.views()), configs.front(), options);
}

py::array draw(const py::object& method,
               const py::object& scene,
               const py::object& view,
               const py::kwargs& given) {
    return array_of(drawn_by(method, scene, view, given, draw::make_drawing).edge_responses);
}

py::dict layers(const py::object& method,
                const py::object& scene,
                const py::object& view,
                const py::kwargs& given) {
    py::dict arrays;
    for (const method::Layer& layer : drawn_by(method, scene, view, given, draw::draw_layers))
        arrays[py::str(layer.name)] = layer_array(layer);
    return arrays;
}

BufferArrays buffers(const py::object& scene, const py::object& view, const py::kwargs& given) {
    const Asked asked = read_asked(buffer_keywords(), view, given);
    const std::string name = text_of(scene);
    const double crease_rad = experiment::trace_of(asked.experiment, {}).truth.crease_rad;
    std::string json;
    auto drawn = [&] {
        const py::gil_scoped_release others_run;
        const auto of = harness::load_one_view(name, asked.view, asked.views());
        json = entrants::view_json(of.scene, of.views.front(), {});
        return entrants::view_buffers(of.scene, of.views.front(), crease_rad);
    }();
    return {std::move(drawn), json};
}

score::Score score(const py::object& edges,
                   const py::object& truth,
                   double tolerance_px,
                   int threshold,
                   bool thin,
                   std::optional<int> band_px,
                   std::optional<int> ignore) {
    const core::Image<std::uint8_t> drawn = image_of(edges, "edges");
    const score::ScoreOptions options{
        .tolerance_px = tolerance_px, .threshold = threshold, .thin = thin};
    score::check(options);
    const Reference reference = reference_of(truth, options, band_px, ignore);
    const py::gil_scoped_release others_run;
    return score::score(drawn, reference.truth, reference.options);
}

/// The functions whose keywords are the program's options.
void add_functions_of_views(py::module_& module) {
    const auto add = [&](const char* name,
                         auto function,
                         const char* doc,
                         const Keywords& keywords,
                         const auto&... arguments) {
        module.def(name, function, (doc + keywords.text()).c_str(), arguments...);
    };
    const auto scene = py::arg("scene");
    const auto method = py::arg("method");
    const auto view = py::arg("view") = "";
    add("truth",
        &truth,
        "Traces the exact outline of one view of a built-in scene or a model file. view is a name "
        "(the first unless one is named) or a Camera.",
        truth_keywords(),
        scene,
        view);
    add("draw",
        &draw,
        "Draws one view with one method: its edge responses, uint8, (height, width), 0 no line .. "
        "255; of strokes and chords the share of each pixel that ink covers.",
        draw_keywords(),
        method,
        scene,
        view);
    add("layers",
        &layers,
        "What a method has inside for one view, name to array: codes (`codes`, `packed`) as they "
        "are, uint16, (height, width, planes); the rest as images, uint8, (height, width, 3).",
        draw_keywords(),
        method,
        scene,
        view);
    add("buffers",
        &buffers,
        "Depth, normals and ids of one view, as Buffers.",
        buffer_keywords(),
        scene,
        view);
    add("compare",
        &compare,
        "Draws, traces, scores and times methods on all views of scenes (or by cameras) as the "
        "command compare does, and gives the lines of rows.csv: a list of dicts, column to value, "
        "None where a field is empty; experiments/columns.md says what columns mean. functions are "
        "methods of yours, name to function: called with the Buffers of a view, it returns edge "
        "responses, uint8, (height, width), light lines on dark, that count from threshold 128 "
        "on. draw_ns is the time of the call; making the buffers does not count. Without methods "
        "the functions alone are compared, or without any all methods.",
        compare_keywords(),
        py::arg("scenes"),
        py::arg("functions") = py::dict(),
        py::arg("cameras") = py::tuple());
}

}  // namespace

PYBIND11_MODULE(inkbench, module) {
    module.doc() =
        "Draws outlines, traces exact ones and scores one against the other. Images are "
        "arrays of uint8, (height, width), row 0 the top.";
    // Raised for bad input, with the sentence that the program would print.
    py::register_exception<core::Error>(module, "Error", PyExc_ValueError);
    py::register_exception<truth::TooLarge>(module, "TooLarge", PyExc_MemoryError);
    add_results(module);
    add_camera(module);
    add_buffers(module);
    module.def(
        "methods",
        &methods,
        "The methods: a dict each, with name, summary, source and params (defaults as text).");
    add_functions_of_views(module);
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
}

}  // namespace ink::python
