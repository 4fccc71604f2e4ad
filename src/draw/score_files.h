#pragma once

#include <filesystem>
#include <string>

#include "score/score.h"

namespace ink::draw {

/// A prediction image to be scored against a truth image.
struct ScoreRequest {
    std::filesystem::path prediction;  ///< 8-bit, 0 no line .. 255 the strongest
    std::filesystem::path truth;       ///< 8-bit labels, 0 no line; taken as it is, never thinned
    score::ScoreOptions options;
};

/// Reads both and scores them.
///
/// Throws core::Error, before any scoring, for options outside their range, files that are not
/// 8-bit images, two sizes (both files and sizes are named) or a band that leaves nothing of the
/// image.
[[nodiscard]] score::Score score_files(const ScoreRequest& request);

/// "1 contour"; the number alone where this project has no class of it.
[[nodiscard]] std::string label_text(int label);

}  // namespace ink::draw
