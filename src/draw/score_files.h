#pragma once

#include <filesystem>
#include <functional>
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
/// Throws core::Error, before any scoring, for options outside their range, a prediction that is no
/// 8-bit image, a truth that is neither an 8-bit image of classes nor the EXR of `inkbench truth
/// -o`, two sizes (both files and sizes are named) or a band that leaves nothing of the image.
[[nodiscard]] FilesScore score_files(const std::filesystem::path& prediction,
                                     const std::filesystem::path& truth,
                                     const ScoreRequest& request);

/// What is right and wrong of it, in colour (error_image.h).
[[nodiscard]] RgbImage picture_of(const FilesScore& scored);

/// "1 contour"; the number alone where this project has no class of it.
[[nodiscard]] std::string label_text(int label);

/// What came of one truth file of a folder.
struct FolderScore {
    std::string name;           ///< its path within the folder, without its ending
    std::string status = "ok";  ///< or why it has no score
    std::optional<score::Score> score = {};

    [[nodiscard]] bool is_scored() const { return score.has_value(); }
};

/// Scores every truth (.png or .exr; .exr where both are there) below `truths` against the image of
/// the same relative path, whatever its ending, below `predictions`, in alphabetical order. The
/// truth of an exported view (a folder with camera.json) goes with the image called as that folder;
/// what else lies there is no truth.
///
/// A missing or bad prediction or truth is an entry with its status, and so is a truth without a
/// pixel that counts (kNoTruth). `on_scored` gets the name and
/// all of each that came out. Throws core::Error for folders that cannot be read, for one without
/// any truth, and for options outside their range.
[[nodiscard]] std::vector<FolderScore> score_folders(
    const std::filesystem::path& predictions,
    const std::filesystem::path& truths,
    const ScoreRequest& request,
    const std::function<void(const std::string& name, const FilesScore&)>& on_scored);

/// Counts of all that were scored, pooled.
[[nodiscard]] score::CurveCount pooled(const std::vector<FolderScore>& scores);

/// F of these counts; nothing if nothing was scored.
[[nodiscard]] std::optional<double> pooled_f(const std::vector<FolderScore>& scores);

}  // namespace ink::draw
