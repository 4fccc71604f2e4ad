#include <pybind11/numpy.h>
#include <pybind11/pybind11.h>
#include <pybind11/stl.h>

#include <algorithm>
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
#include "harness/cells/cell.h"
#include "harness/suite/suite.h"
#include "harness/truths/tracing.h"
#include "methods/method_configs.h"
#include "methods/registry.h"
#include "python/asked.h"
#include "python/buffers.h"
#include "score/score.h"
#include "truth/line_class.h"

namespace ink::python {
namespace {

/// A truth as Python sees it: its arrays take the images over.
struct TruthArrays {
    pybind11::array labels;
    pybind11::array below_crease;
    pybind11::array sampled;
    pybind11::array exact_corner;
    pybind11::array curves;
    double crowded_share = 0;
    double trace_s = 0;

    explicit TruthArrays(harness::ViewTruth&& truth);
};

/// What a prediction is scored against: a TruthArrays, with its ignore label, the band that
/// `compare` uses and classes; or an array of labels with what the caller says.
struct Reference {
    score::ScoringTruth truth;
    score::ScoreOptions options;
};

namespace py = pybind11;

namespace {

/// A row of Truth.curves; field names are those of the array's type.
struct CurveRecord {
    double x0_px, y0_px, w0;
    double x1_px, y1_px, w1;
    float deviation_rad;
    float gap;
    std::uint8_t line_class;
    std::uint8_t behind;
};

py::array curve_array(const std::vector<truth::Curve>& curves) {
    py::array_t<CurveRecord> array(static_cast<py::ssize_t>(curves.size()));
    std::ranges::transform(curves, array.mutable_data(), [](const truth::Curve& c) -> CurveRecord {
        return {c.begin.x_px,
                c.begin.y_px,
                c.begin.w,
                c.end.x_px,
                c.end.y_px,
                c.end.w,
                c.deviation_rad,
                c.gap,
                static_cast<std::uint8_t>(c.line_class),
                static_cast<std::uint8_t>(c.kind)};
    });
    return array;
}

std::string class_name(int label) {
    for (const truth::LineClass c : truth::kLineClasses)
        if (static_cast<int>(c) == label) return std::string(truth::name(c));
    return std::to_string(label);
}

}  // namespace

TruthArrays::TruthArrays(harness::ViewTruth&& truth)
    : labels(array_of(truth.counted_labels())),
      below_crease(array_of(std::move(truth.traced.below_crease))),
      sampled(array_of(std::move(truth.traced.sampled))),
      exact_corner(array_of(std::move(truth.traced.exact_corner))),
      curves(curve_array(truth.traced.curves)),
      crowded_share(truth.traced.counts.crowded_share),
      trace_s(truth.traced.trace_s) {}

/// Checks and prepares. Raises TypeError for another type, and throws core::Error for options out
/// of range.
Reference reference_of(const py::object& truth,
                       score::ScoreOptions options,
                       std::optional<int> band_px,
                       std::optional<int> ignore_label) {
    const bool is_traced = py::isinstance<TruthArrays>(truth);
    options.ignore_label = ignore_label;
    options.band_px = band_px.value_or(is_traced ? harness::kBand_px : 0);
    if (is_traced && !ignore_label)
        options.ignore_label = static_cast<int>(truth::LineClass::ignore);
    const py::object labels = is_traced ? truth.attr("labels") : truth;
    Reference reference{score::prepare_truth(image_of(labels, "truth"), options, is_traced),
                        options};
    if (is_traced) reference.truth.is_binary = false;
    return reference;
}

/// Adds the classes Truth, Score and ClassScore to the module.
void add_results(py::module_& module) {
    PYBIND11_NUMPY_DTYPE(
        CurveRecord, x0_px, y0_px, w0, x1_px, y1_px, w1, deviation_rad, gap, line_class, behind);
    py::class_<TruthArrays>(module, "Truth", "The exact outline of one view.")
        .def_readonly("labels",
                      &TruthArrays::labels,
                      "uint8, (height, width): 0 no line, 1 contour, 2 boundary, 3 crease, 4 "
                      "intersection, 5 seam, 7 ignored.")
        .def_readonly("below_crease",
                      &TruthArrays::below_crease,
                      "uint8, (height, width): 1 where only intersections that bend by less than a "
                      "crease run.")
        .def_readonly("sampled",
                      &TruthArrays::sampled,
                      "uint8, (height, width): the same lines by one exact sample a pixel, at its "
                      "centre.")
        .def_readonly("exact_corner",
                      &TruthArrays::exact_corner,
                      "uint8, (height, width): the same with samples at pixel corners.")
        .def_readonly("curves",
                      &TruthArrays::curves,
                      "Records, (n,): every visible piece of line, sub-pixel. x0_px, y0_px, w0 and "
                      "x1_px, y1_px, w1 are its ends (w: distance along the view direction, world "
                      "units), deviation_rad the bend, gap what lies behind it in world units, "
                      "line_class as in labels, behind 1 sky, 2 another object, 3 itself.")
        .def_readonly("crowded_share",
                      &TruthArrays::crowded_share,
                      "Share of the lines, 0..1, that lie in blocks too full to score.")
        .def_readonly("trace_s", &TruthArrays::trace_s, "Seconds that the trace took.");

    py::class_<score::ClassCount>(module, "ClassScore", "The recall of one class of lines.")
        .def_property_readonly(
            "name",
            [](const score::ClassCount& c) { return class_name(c.label); },
            "What the class is called; its number where it has no name.")
        .def_readonly("label", &score::ClassCount::label, "Its number in the truth.")
        .def_readonly("k", &score::ClassCount::k, "True pixels that are matched.")
        .def_readonly("n_truth", &score::ClassCount::n_truth, "True pixels.");

    using score::Score;
    py::class_<Score>(module, "Score", "How a drawing compares with a truth.")
        .def_property_readonly("f",
                               &Score::f_of_truth,
                               "2 k / (n_pred + n_truth), 0..1; None if there is no true line.")
        .def_property_readonly(
            "precision", &Score::precision, "k / n_pred, 0..1; None if nothing is drawn.")
        .def_property_readonly(
            "recall", &Score::recall, "k / n_truth, 0..1; None if there is no true line.")
        .def_readonly("k", &Score::k, "Matched pixels: the size of a largest one-to-one matching.")
        .def_readonly("n_pred", &Score::n_pred, "Drawn pixels, thinned.")
        .def_readonly("n_truth", &Score::n_truth, "True pixels.")
        .def_readonly("unmatched_duplicates",
                      &Score::unmatched_duplicates,
                      "Unmatched drawn pixels with a true one in reach.")
        .def_readonly(
            "false_positives", &Score::false_positives, "Drawn pixels without a true one in reach.")
        .def_readonly("unmatched_truth",
                      &Score::unmatched_truth,
                      "Unmatched true pixels with a drawn one in reach.")
        .def_readonly(
            "false_negatives", &Score::false_negatives, "True pixels without a drawn one in reach.")
        .def_readonly("mean_width_px",
                      &Score::mean_width_px,
                      "Drawn pixels over thinned ones; 0 if nothing is drawn.")
        .def_readonly("classes", &Score::classes, "A ClassScore per class of the truth.")
        .def("__repr__", [](const Score& s) {
            const auto f = s.f_of_truth();
            return "Score(f=" + (f ? std::to_string(*f) : "None") + ", k=" + std::to_string(s.k) +
                   ", n_pred=" + std::to_string(s.n_pred) +
                   ", n_truth=" + std::to_string(s.n_truth) + ")";
        });
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
