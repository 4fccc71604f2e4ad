#include "draw/score_images.h"

#include <algorithm>
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

}  // namespace ink::draw
