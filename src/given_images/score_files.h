#pragma once

#include <filesystem>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "draw/error_image.h"
#include "harness/images/outline_image.h"
#include "score/intersections.h"
#include "score/score.h"
#include "score/soft_score.h"

namespace ink::given_images {

/// A truth image, and how it wants to be scored against.
struct TruthLabels {
    core::Image<std::uint8_t> labels;      ///< 0 no line, every other value a class
    std::optional<int> ignore_label = {};  ///< that the file names
    std::optional<int> band_px = {};       ///< that the file names
    bool has_classes = false;              ///< its values are classes, even a lone 1
    std::string command = {};              ///< that traced it, without size and output; or ""
    /// How many of its pixels are intersections below the crease angle that count all the same.
    int below_crease_px = 0;
    /// The share of each pixel that its lines cover, drawn so wide (score/coverage.h); or empty.
    core::Image<float> coverage = {};
    double line_width_px = 0;
};

/// Reads a truth: an 8-bit image of classes, or the EXR of `inkbench truth -o` (channel
/// class.label). Both of these name their ignore label and band. In an EXR intersections that
/// `intersections` does not count become the ignore label; in an image they are what they were when
/// it was traced. An EXR has the coverage, too.
///
/// Throws core::Error for a file that cannot be read, an EXR without that channel, and an image in
/// colour: that is a preview for people, no truth.
[[nodiscard]] TruthLabels read_truth_labels(const std::filesystem::path& path,
                                            score::Intersections intersections);

/// How image files are scored.
struct ScoreRequest {
    harness::Polarity polarity = harness::Polarity::automatic;
    /// Which intersections count, where the truth is an EXR.
    score::Intersections intersections = score::Intersections::above_crease;
    /// Its ignore label and band are those of the truth file where the caller names none.
    score::ScoreOptions options = {};
    std::optional<int> band_px = {};  ///< instead of options.band_px; default: the file's, else 0
    /// The image is scored as grey lines, too, against true ones of this width.
    std::optional<double> line_width_px = {};
};

/// Why there is no F, and what may help.
inline constexpr const char* kNoTruth =
    "empty: the truth has no pixel that counts, so there is no F; a smaller --band, or a truth "
    "that "
    "shows lines";

/// What came of a prediction and a truth.
struct FilesScore {
    score::Score score;
    std::optional<score::SoftScore> soft;  ///< of grey lines, where it was asked for
    score::ScoreOptions options;           ///< as they were used
    bool is_inverted = false;              ///< the prediction was taken as dark lines on light
    core::Image<std::uint8_t> labels;
    edge::EdgeImage responses;
    std::vector<std::string> notes;  ///< how the prediction was read (harness::OutlineImage)
    /// A sentence each, for people: the truth is empty (kNoTruth); what seems to be wrong with the
    /// prediction (score/doubts.h); what does with the truth.
    std::vector<std::string> doubts;
};

/// An image, or a truth, and what messages call it: the file's name as the user gave it.
template <class Held>
struct Named {
    std::string name;
    Held held;
};

/// Reads both files and scores them. The truth is taken as it is, never thinned.
///
/// Throws core::Error, before any scoring, for options outside their range, files that are not
/// what read_outline_image and read_truth_labels take, two sizes (both files and sizes are named,
/// and the command that traces the right truth), a band that leaves nothing of the image, and a
/// truth without the coverage that was asked for.
[[nodiscard]] FilesScore score_files(const std::filesystem::path& prediction,
                                     const std::filesystem::path& truth,
                                     const ScoreRequest& request);

/// The same of what was read or traced already.
[[nodiscard]] FilesScore score_outline(Named<harness::OutlineImage> prediction,
                                       Named<TruthLabels> truth,
                                       const ScoreRequest& request);

/// What is right and wrong of it, in colour (error_image.h).
[[nodiscard]] draw::RgbImage picture_of(const FilesScore& scored);

/// "1 contour"; the number alone where this project has no class of it.
[[nodiscard]] std::string label_text(int label);

/// What came of one truth file of a folder.
struct FolderScore {
    std::string name;           ///< its path within the folder, without its ending
    std::string status = "ok";  ///< or why it has no score
    std::optional<score::Score> score = {};
    std::vector<std::string> notes = {};        ///< how the image was read (FilesScore::notes)
    std::vector<std::string> doubts = {};       ///< what seems to be wrong (FilesScore::doubts)
    std::optional<score::SoftScore> soft = {};  ///< of grey lines (FilesScore::soft)

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

/// The files below `predictions`, by their paths within it, that score_folders() scores against no
/// truth: none has their name, or another file of that name comes first. Hidden files and times.csv
/// (entrants/entrant.h) are no images.
[[nodiscard]] std::vector<std::string> files_without_truth(const std::filesystem::path& predictions,
                                                           const std::filesystem::path& truths);

/// Counts of all that were scored, pooled.
[[nodiscard]] score::CurveCount pooled(const std::vector<FolderScore>& scores);

/// F of these counts; nothing if nothing was scored.
[[nodiscard]] std::optional<double> pooled_f(const std::vector<FolderScore>& scores);

}  // namespace ink::given_images
