#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "score/score.h"

namespace ink::draw {

/// A prediction image to be scored against a truth image.
struct ScoreRequest {
    std::filesystem::path prediction;  ///< 8-bit, 0 no line .. 255 the strongest
    std::filesystem::path truth;       ///< 8-bit labels, 0 no line; taken as it is, never thinned
    bool is_inverted = false;          ///< the prediction has dark lines on light
    score::ScoreOptions options;
};

/// What came of it, and what makes it doubtful.
struct FilesScore {
    score::Score score;
    /// A sentence each, for people: most of the prediction counts as drawn (dark lines on light?);
    /// the truth holds values that are no class (a coloured preview?).
    std::vector<std::string> doubts;
};

/// Reads both and scores them.
///
/// Throws core::Error, before any scoring, for options outside their range, files that are not
/// 8-bit images, two sizes (both files and sizes are named) or a band that leaves nothing of the
/// image.
[[nodiscard]] FilesScore score_files(const ScoreRequest& request);

/// "1 contour"; the number alone where this project has no class of it.
[[nodiscard]] std::string label_text(int label);

}  // namespace ink::draw
