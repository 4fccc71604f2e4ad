#include "given_images/score_files.h"

#include <fmt/format.h>

#include <algorithm>
#include <set>

#include "core/error.h"
#include "score/doubts.h"
#include "truth/line_class.h"

namespace ink::given_images {
namespace {

namespace fs = std::filesystem;
using Gray = core::Image<std::uint8_t>;

std::string size_text(const Gray& image) {
    return fmt::format("{} x {} px", image.width_px(), image.height_px());
}

/// What is to be done where the image has another size than the truth.
std::string other_size(const Named<harness::OutlineImage>& prediction,
                       const Named<TruthLabels>& truth) {
    const Gray& image = prediction.held.responses;
    const std::string needed = fmt::format("an image of {}", size_text(truth.held.labels));
    if (truth.held.command.empty()) {
        return fmt::format(
            "{}, or its own truth: inkbench score {} --model MODEL", needed, prediction.name);
    }
    return fmt::format("{}, or its own truth: {} --size {}x{} -o {}",
                       needed,
                       truth.held.command,
                       image.width_px(),
                       image.height_px(),
                       truth.name);
}

void check_sizes(const Named<harness::OutlineImage>& prediction,
                 const Named<TruthLabels>& truth,
                 int band_px) {
    const Gray& image = prediction.held.responses;
    const Gray& labels = truth.held.labels;
    if (image.width_px() != labels.width_px() || image.height_px() != labels.height_px()) {
        throw core::Error(prediction.name,
                          fmt::format("its size is {}, but that of {} is {}",
                                      size_text(image),
                                      truth.name,
                                      size_text(labels)),
                          other_size(prediction, truth));
    }
    const int widest_px = (std::min(labels.width_px(), labels.height_px()) - 1) / 2;
    if (band_px > widest_px) {
        throw core::Error("band",
                          fmt::format("{} px leave nothing of {}", band_px, size_text(labels)),
                          fmt::format("0..{} px", widest_px));
    }
}

void check_coverage(const Named<TruthLabels>& truth, double line_width_px) {
    if (truth.held.coverage.is_empty()) {
        throw core::Error(truth.name,
                          "it does not say what its lines cover",
                          "the .exr of inkbench truth -o, or --model MODEL");
    }
    if (truth.held.line_width_px == line_width_px) return;
    throw core::Error("--line-width",
                      fmt::format("{} covers lines {} px wide, not {}",
                                  truth.name,
                                  truth.held.line_width_px,
                                  line_width_px),
                      fmt::format("{}, or --model MODEL", truth.held.line_width_px));
}

std::vector<std::string> doubts_of_prediction(const std::string& name,
                                              const FilesScore& scored,
                                              const score::ScoringTruth& truth) {
    std::string doubt = score::doubt_of(scored.responses, truth, scored.options, scored.score.f());
    if (doubt.empty()) return {};
    const double share = score::drawn_share(scored.responses, scored.options.threshold);
    if (share > score::kMostDrawn && share < 1) {
        doubt += fmt::format("; if its lines are {}, score it with --polarity {}",
                             scored.is_inverted ? "light on dark" : "dark on light",
                             scored.is_inverted ? "light" : "dark");
    }
    return {name + ": " + doubt};
}

/// A truth holds classes and little else.
std::vector<std::string> doubts_of_truth(const Named<TruthLabels>& truth,
                                         score::Intersections intersections) {
    std::vector<std::string> found;
    std::set<int> unknown;
    const Gray& labels = truth.held.labels;
    for (std::size_t i = 0; i < labels.size(); ++i) {
        const int label = labels.data()[i];
        if (label > static_cast<int>(truth::LineClass::ignore) && label != 255)
            unknown.insert(label);
    }
    if (!unknown.empty()) {
        found.push_back(
            fmt::format("{} holds {} values that are no line class, such as {}; the "
                        "truth is the file of inkbench truth -o, not its coloured "
                        "preview",
                        truth.name,
                        unknown.size(),
                        *unknown.begin()));
    }
    if (truth.held.below_crease_px > 0 && intersections == score::Intersections::above_crease) {
        found.push_back(
            fmt::format("{} px of {} are intersections below the crease angle, and count (truth "
                        "--intersections above_crease leaves them out)",
                        truth.held.below_crease_px,
                        truth.name));
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

FilesScore score_outline(Named<harness::OutlineImage> prediction,
                         Named<TruthLabels> truth,
                         const ScoreRequest& request) {
    FilesScore scored;
    scored.options = request.options;
    if (!scored.options.ignore_label) scored.options.ignore_label = truth.held.ignore_label;
    scored.options.band_px =
        request.band_px.value_or(truth.held.band_px.value_or(request.options.band_px));
    score::check(scored.options);
    check_sizes(prediction, truth, scored.options.band_px);
    if (request.line_width_px) check_coverage(truth, *request.line_width_px);
    scored.doubts = doubts_of_truth(truth, request.intersections);
    scored.responses = std::move(prediction.held.responses);
    scored.is_inverted = prediction.held.is_inverted;
    scored.notes = std::move(prediction.held.notes);
    scored.labels = std::move(truth.held.labels);
    score::ScoringTruth prepared = score::prepare_truth(scored.labels, scored.options, false);
    if (truth.held.has_classes) prepared.is_binary = false;
    scored.score = score::score(scored.responses, prepared, scored.options);
    if (request.line_width_px) {
        scored.soft = score::score_ink(
            score::ink_of(scored.responses),
            score::prepare_ink(
                std::move(truth.held.coverage), *request.line_width_px, prepared, scored.options),
            scored.options);
    }
    const auto of_prediction = doubts_of_prediction(prediction.name, scored, prepared);
    scored.doubts.insert(scored.doubts.begin(), of_prediction.begin(), of_prediction.end());
    if (scored.score.n_truth == 0) scored.doubts.emplace(scored.doubts.begin(), kNoTruth);
    return scored;
}

FilesScore score_files(const fs::path& prediction,
                       const fs::path& truth,
                       const ScoreRequest& request) {
    score::ScoreOptions options = request.options;
    if (request.band_px) options.band_px = *request.band_px;
    score::check(options);  // before anything is read
    return score_outline(
        {prediction.string(), harness::read_outline_image(prediction, request.polarity)},
        {truth.string(), read_truth_labels(truth, request.intersections)},
        request);
}

draw::RgbImage picture_of(const FilesScore& scored) {
    // Whatever number a line or the ignored places have in the file.
    core::Image<std::uint8_t> labels = scored.labels;
    std::transform(labels.data(), labels.data() + labels.size(), labels.data(), [&](int label) {
        const bool is_ignored = scored.options.ignore_label == label;
        const bool is_class = label > 0 && label <= static_cast<int>(truth::LineClass::seam);
        if (is_ignored) return static_cast<std::uint8_t>(truth::LineClass::ignore);
        if (label == 0 || is_class) return static_cast<std::uint8_t>(label);
        return static_cast<std::uint8_t>(truth::LineClass::contour);
    });
    return draw::error_image(draw::mark_errors(labels,
                                               scored.responses,
                                               {.threshold = scored.options.threshold,
                                                .tolerance_px = scored.options.tolerance_px,
                                                .band_px = scored.options.band_px}));
}

}  // namespace ink::given_images
