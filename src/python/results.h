#pragma once

#include <pybind11/numpy.h>
#include <pybind11/pybind11.h>

#include <optional>

#include "harness/truths/tracing.h"
#include "score/score.h"

namespace ink::python {

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

/// Checks and prepares. Raises TypeError for another type, and throws core::Error for options out
/// of range.
[[nodiscard]] Reference reference_of(const pybind11::object& truth,
                                     score::ScoreOptions options,
                                     std::optional<int> band_px,
                                     std::optional<int> ignore_label);

/// Adds the classes Truth, Score and ClassScore to the module.
void add_results(pybind11::module_& module);

}  // namespace ink::python
