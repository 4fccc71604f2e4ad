#pragma once

#include <filesystem>
#include <optional>

#include "core/image.h"
#include "edge/edge_image.h"
#include "score/intersections.h"

namespace ink::draw {

/// Which pixels of an outline image are its lines.
enum class Polarity {
    automatic,      ///< dark on light if more than three quarters of the pixels are light
    light_on_dark,  ///< the lighter, the stronger
    dark_on_light   ///< the darker, the stronger
};

/// An outline image as edge responses.
struct Prediction {
    edge::EdgeImage responses;  ///< 0 no line .. 255 the strongest
    bool is_inverted = false;   ///< the file has dark lines on light
};

/// Reads an 8-bit image. One that holds a single value has no lines on it, and is taken as it is
/// where `polarity` is automatic. Throws core::Error as image_io::read_gray does.
[[nodiscard]] Prediction read_prediction(const std::filesystem::path& path, Polarity polarity);

/// A truth image, and how it wants to be scored against.
struct TruthLabels {
    core::Image<std::uint8_t> labels;      ///< 0 no line, every other value a class
    std::optional<int> ignore_label = {};  ///< that the file names
    std::optional<int> band_px = {};       ///< that the file names
    bool has_classes = false;              ///< its values are classes, even a lone 1
};

/// Reads a truth: an 8-bit image of classes, or the EXR of `inkbench truth -o` (channel
/// class.label), which also names its ignore label and band. In an EXR intersections that
/// `intersections` does not count become the ignore label.
///
/// Throws core::Error for a file that cannot be read, an EXR without that channel, and an image in
/// colour: that is a preview for people, no truth.
[[nodiscard]] TruthLabels read_truth_labels(const std::filesystem::path& path,
                                            score::Intersections intersections);

}  // namespace ink::draw
