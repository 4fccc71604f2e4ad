#pragma once

#include <filesystem>
#include <optional>
#include <string>

#include "core/image.h"
#include "score/intersections.h"

namespace ink::draw {

/// A truth image, and how it wants to be scored against.
struct TruthLabels {
    core::Image<std::uint8_t> labels;      ///< 0 no line, every other value a class
    std::optional<int> ignore_label = {};  ///< that the file names
    std::optional<int> band_px = {};       ///< that the file names
    bool has_classes = false;              ///< its values are classes, even a lone 1
    std::string command = {};              ///< that traced it, without size and output; or ""
    /// How many of its pixels are intersections below the crease angle that count all the same.
    int below_crease_px = 0;
};

/// Reads a truth: an 8-bit image of classes, or the EXR of `inkbench truth -o` (channel
/// class.label). Both of these name their ignore label and band. In an EXR intersections that
/// `intersections` does not count become the ignore label; in an image they are what they were when
/// it was traced.
///
/// Throws core::Error for a file that cannot be read, an EXR without that channel, and an image in
/// colour: that is a preview for people, no truth.
[[nodiscard]] TruthLabels read_truth_labels(const std::filesystem::path& path,
                                            score::Intersections intersections);

}  // namespace ink::draw
