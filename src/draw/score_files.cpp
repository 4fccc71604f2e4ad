#include "draw/score_files.h"

#include <fmt/format.h>

#include <algorithm>
#include <set>

#include "core/error.h"
#include "truth/line_class.h"

namespace ink::draw {
namespace {

namespace fs = std::filesystem;
using Gray = core::Image<std::uint8_t>;

std::string size_text(const Gray& image) {
    return fmt::format("{} x {} px", image.width_px(), image.height_px());
}

void check_sizes(const fs::path& prediction_path,
                 const fs::path& truth_path,
                 const FilesScore& scored) {
    const Gray& prediction = scored.responses;
    const Gray& truth = scored.labels;
    if (prediction.width_px() != truth.width_px() || prediction.height_px() != truth.height_px()) {
        throw core::Error(prediction_path.string(),
                          fmt::format("its size is {}, but that of {} is {}",
                                      size_text(prediction),
                                      truth_path.string(),
                                      size_text(truth)),
                          "two images of one size");
    }
    const int widest_px = (std::min(truth.width_px(), truth.height_px()) - 1) / 2;
    const int band_px = scored.options.band_px;
    if (band_px > widest_px) {
        throw core::Error("band",
                          fmt::format("{} px leave nothing of {}", band_px, size_text(truth)),
                          fmt::format("0..{} px", widest_px));
    }
}

/// Lines cover a small part of any image; a truth holds classes and little else.
std::vector<std::string> doubts(const fs::path& prediction_path,
                                const fs::path& truth_path,
                                const FilesScore& scored) {
    constexpr double kMostDrawn = 0.5;
    std::vector<std::string> found;
    if (scored.score.n_truth == 0) found.emplace_back(kNoTruth);
    const Gray& prediction = scored.responses;
    const auto drawn = std::count_if(prediction.data(),
                                     prediction.data() + prediction.size(),
                                     [&](int v) { return v >= scored.options.threshold; });
    const double share = static_cast<double>(drawn) / static_cast<double>(prediction.size());
    if (share > kMostDrawn) {
        found.push_back(fmt::format(
            "{:.0f} % of {} count as drawn; if its lines are {}, score it with --polarity {}",
            100 * share,
            prediction_path.string(),
            scored.is_inverted ? "light on dark" : "dark on light",
            scored.is_inverted ? "light" : "dark"));
    }
    std::set<int> unknown;
    for (std::size_t i = 0; i < scored.labels.size(); ++i) {
        const int label = scored.labels.data()[i];
        if (label > static_cast<int>(truth::LineClass::ignore) && label != 255)
            unknown.insert(label);
    }
    if (!unknown.empty()) {
        found.push_back(
            fmt::format("{} holds {} values that are no line class, such as {}; the "
                        "truth is the file of inkbench truth -o, not its coloured "
                        "preview",
                        truth_path.string(),
                        unknown.size(),
                        *unknown.begin()));
    }
    return found;
}

}  // namespace

std::string label_text(int label) {
    for (const truth::LineClass c : truth::kLineClasses) {
        if (static_cast<int>(c) == label) return fmt::format("{} {}", label, truth::name(c));
    }
    return std::to_string(label);
}

FilesScore score_files(const fs::path& prediction,
                       const fs::path& truth,
                       const ScoreRequest& request) {
    FilesScore scored;
    scored.options = request.options;
    if (request.band_px) scored.options.band_px = *request.band_px;
    score::check(scored.options);
    Prediction drawn = read_prediction(prediction, request.polarity);
    scored.responses = std::move(drawn.responses);
    scored.is_inverted = drawn.is_inverted;
    TruthLabels labels = read_truth_labels(truth, request.intersections);
    scored.labels = std::move(labels.labels);
    if (!scored.options.ignore_label) scored.options.ignore_label = labels.ignore_label;
    if (!request.band_px && labels.band_px) scored.options.band_px = *labels.band_px;
    check_sizes(prediction, truth, scored);
    score::ScoringTruth prepared = score::prepare_truth(scored.labels, scored.options, false);
    if (labels.has_classes) prepared.is_binary = false;
    scored.score = score::score(scored.responses, prepared, scored.options);
    scored.doubts = doubts(prediction, truth, scored);
    return scored;
}

RgbImage picture_of(const FilesScore& scored) {
    // Whatever number a line or the ignored places have in the file.
    core::Image<std::uint8_t> labels = scored.labels;
    std::transform(labels.data(), labels.data() + labels.size(), labels.data(), [&](int label) {
        const bool is_ignored = scored.options.ignore_label == label;
        const bool is_class = label > 0 && label <= static_cast<int>(truth::LineClass::seam);
        if (is_ignored) return static_cast<std::uint8_t>(truth::LineClass::ignore);
        if (label == 0 || is_class) return static_cast<std::uint8_t>(label);
        return static_cast<std::uint8_t>(truth::LineClass::contour);
    });
    return error_image(mark_errors(labels,
                                   scored.responses,
                                   {.threshold = scored.options.threshold,
                                    .tolerance_px = scored.options.tolerance_px,
                                    .band_px = scored.options.band_px}));
}

}  // namespace ink::draw
