#include "draw/score_files.h"

#include <fmt/format.h>

#include <algorithm>

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

}  // namespace

std::string label_text(int label) {
    for (const truth::LineClass c : truth::kLineClasses) {
        if (static_cast<int>(c) == label) return fmt::format("{} {}", label, truth::name(c));
    }
    return std::to_string(label);
}

score::Score score_files(const ScoreRequest& request) {
    score::check(request.options);
    const Gray prediction = image_io::read_gray(request.prediction);
    const Gray labels = image_io::read_gray(request.truth);
    check_sizes(request, prediction, labels);
    const score::ScoringTruth truth = score::prepare_truth(labels, request.options, false);
    return score::score(prediction, truth, request.options);
}

}  // namespace ink::draw
