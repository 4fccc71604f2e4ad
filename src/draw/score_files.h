#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "core/image.h"
#include "draw/error_image.h"
#include "edge/edge_image.h"
#include "score/intersections.h"
#include "score/score.h"

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

/// How image files are scored.
struct ScoreRequest {
    Polarity polarity = Polarity::automatic;
    /// Which intersections count, where the truth is an EXR.
    score::Intersections intersections = score::Intersections::above_crease;
    /// Its ignore label and band are those of the truth file where the caller names none.
    score::ScoreOptions options = {};
    std::optional<int> band_px = {};  ///< instead of options.band_px; default: the file's, else 0
};

/// Why there is no F, and what may help.
inline constexpr const char* kNoTruth =
    "empty: the truth has no pixel that counts, so there is no F; a smaller --band, or a truth "
    "that "
    "shows lines";

/// What came of a prediction and a truth.
struct FilesScore {
    score::Score score;
    score::ScoreOptions options;  ///< as they were used
    bool is_inverted = false;     ///< the prediction was taken as dark lines on light
    core::Image<std::uint8_t> labels;
    edge::EdgeImage responses;
    /// A sentence each, for people: the truth is empty (kNoTruth); most of the prediction counts as
    /// drawn; the truth holds values that are no class.
    std::vector<std::string> doubts;
};

/// Reads both files and scores them. The truth is taken as it is, never thinned.
///
/// Throws core::Error, before any scoring, for options outside their range, files that are not
/// what read_prediction and read_truth_labels take, two sizes (both files and sizes are named) or a
/// band that leaves nothing of the image.
[[nodiscard]] FilesScore score_files(const std::filesystem::path& prediction,
                                     const std::filesystem::path& truth,
                                     const ScoreRequest& request);

/// What is right and wrong of it, in colour (error_image.h).
[[nodiscard]] RgbImage picture_of(const FilesScore& scored);

/// "1 contour"; the number alone where this project has no class of it.
[[nodiscard]] std::string label_text(int label);

}  // namespace ink::draw
