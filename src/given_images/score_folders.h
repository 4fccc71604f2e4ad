#pragma once

#include <filesystem>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "given_images/score_files.h"

namespace ink::given_images {

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
