#include "python/results.h"

#include <pybind11/stl.h>

#include <string>
#include <utility>

#include "python/buffers.h"
#include "truth/line_class.h"

namespace ink::python {

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
    auto records = array.mutable_unchecked<1>();
    for (std::size_t i = 0; i < curves.size(); ++i) {
        const truth::Curve& c = curves[i];
        records(static_cast<py::ssize_t>(i)) = {c.begin.x_px,
                                                c.begin.y_px,
                                                c.begin.w,
                                                c.end.x_px,
                                                c.end.y_px,
                                                c.end.w,
                                                c.deviation_rad,
                                                c.gap,
                                                static_cast<std::uint8_t>(c.line_class),
                                                static_cast<std::uint8_t>(c.kind)};
    }
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

}  // namespace ink::python
