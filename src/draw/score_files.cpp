#include "draw/score_files.h"

#include <fmt/format.h>

#include <algorithm>
#include <set>

#include "core/error.h"
#include "image_io/image_file.h"
#include "truth/line_class.h"

namespace ink::draw {
namespace {

using Gray = core::Image<std::uint8_t>;

std::string size_text(const Gray& image) {
    return fmt::format("{} x {} px", image.width_px(), image.height_px());
}

void check_sizes(const ScoreRequest& request, const Gray& prediction, const Gray& truth) {
    if (prediction.width_px() != truth.width_px() || prediction.height_px() != truth.height_px()) {
        throw core::Error(request.prediction.string(),
                          fmt::format("its size is {}, but that of {} is {}",
                                      size_text(prediction),
                                      request.truth.string(),
                                      size_text(truth)),
                          "two images of one size");
    }
    const int widest_px = (std::min(truth.width_px(), truth.height_px()) - 1) / 2;
    const int band_px = request.options.band_px;
    if (band_px > widest_px) {
        throw core::Error("band",
                          fmt::format("{} px leave nothing of {}", band_px, size_text(truth)),
                          fmt::format("0..{} px", widest_px));
    }
}

void invert(Gray& image) {
    std::transform(image.data(), image.data() + image.size(), image.data(), [](std::uint8_t v) {
        return static_cast<std::uint8_t>(255 - v);
    });
}

/// Lines cover a small part of any image; a truth holds classes and little else.
std::vector<std::string> doubts(const ScoreRequest& request,
                                const Gray& prediction,
                                const Gray& labels) {
    constexpr double kMostDrawn = 0.5;
    std::vector<std::string> found;
    const auto drawn = std::count_if(prediction.data(),
                                     prediction.data() + prediction.size(),
                                     [&](int v) { return v >= request.options.threshold; });
    const double share = static_cast<double>(drawn) / static_cast<double>(prediction.size());
    if (share > kMostDrawn) {
        found.push_back(
            fmt::format("{:.0f} % of {} count as drawn; if its lines are dark on light, "
                        "score it with --invert",
                        100 * share,
                        request.prediction.string()));
    }
    std::set<int> unknown;
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
                        request.truth.string(),
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

FilesScore score_files(const ScoreRequest& request) {
    score::check(request.options);
    Gray prediction = image_io::read_gray(request.prediction);
    if (request.is_inverted) invert(prediction);
    const Gray labels = image_io::read_gray(request.truth);
    check_sizes(request, prediction, labels);
    const score::ScoringTruth truth = score::prepare_truth(labels, request.options, false);
    return {score::score(prediction, truth, request.options), doubts(request, prediction, labels)};
}

}  // namespace ink::draw
