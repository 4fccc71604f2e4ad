#include "draw/score_files.h"

#include <fmt/format.h>

#include <algorithm>
#include <set>
#include <string_view>
#include <variant>

#include "core/error.h"
#include "image_io/exr_file.h"
#include "image_io/image_file.h"
#include "score/polarity.h"
#include "truth/line_class.h"

namespace ink::draw {
namespace {

using Gray = core::Image<std::uint8_t>;

/// The channel called `name`, or null.
const core::Image<std::uint32_t>* find_channel(const image_io::ExrFile& file,
                                               std::string_view name) {
    for (const image_io::ExrChannel& channel : file.channels) {
        if (channel.name == name) return std::get_if<core::Image<std::uint32_t>>(&channel.pixels);
    }
    return nullptr;
}

std::optional<int> find_number(const image_io::ExrFile& file, std::string_view name) {
    for (const image_io::ExrAttribute& attribute : file.attributes) {
        if (attribute.name != name) continue;
        if (const auto* value = std::get_if<double>(&attribute.value))
            return static_cast<int>(*value);
    }
    return std::nullopt;
}

TruthLabels read_exr_labels(const std::filesystem::path& path, score::Intersections intersections) {
    const image_io::ExrFile file = image_io::read_exr(path);
    const auto* labels = find_channel(file, "class.label");
    if (labels == nullptr) {
        throw core::Error(path.string(),
                          "it has no channel class.label of whole numbers",
                          "the file of inkbench truth -o truth.exr");
    }
    TruthLabels truth{Gray(labels->width_px(), labels->height_px()),
                      find_number(file, "ink:ignore_label"),
                      find_number(file, "ink:band_px"),
                      true};
    std::transform(labels->data(),
                   labels->data() + labels->size(),
                   truth.labels.data(),
                   [](std::uint32_t label) {
                       return static_cast<std::uint8_t>(std::min<std::uint32_t>(label, 255));
                   });
    const auto* below = find_channel(file, "class.below_crease");
    if (below == nullptr || intersections == score::Intersections::all) return truth;
    for (std::size_t i = 0; i < truth.labels.size(); ++i) {
        if (below->data()[i] != 0)
            truth.labels.data()[i] = static_cast<std::uint8_t>(truth::LineClass::ignore);
    }
    return truth;
}

namespace fs = std::filesystem;
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

Prediction read_prediction(const std::filesystem::path& path, Polarity polarity) {
    Prediction prediction{image_io::read_gray(path)};
    Gray& image = prediction.responses;
    prediction.is_inverted = polarity == Polarity::dark_on_light ||
                             (polarity == Polarity::automatic && score::has_dark_lines(image));
    if (prediction.is_inverted) score::invert(image);
    return prediction;
}

TruthLabels read_truth_labels(const std::filesystem::path& path,
                              score::Intersections intersections) {
    if (path.extension() == ".exr") return read_exr_labels(path, intersections);
    image_io::GrayFile file = image_io::read_gray_file(path);
    if (file.has_colour) {
        throw core::Error(path.string(),
                          "it is in colour: a preview for people, no truth",
                          "an image of class numbers, or the .exr, of inkbench truth -o");
    }
    return {std::move(file.pixels)};
}

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
