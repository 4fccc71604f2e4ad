#include "given_images/score_folders.h"

#include <map>
#include <set>
#include <system_error>

#include "core/error.h"

namespace ink::given_images {
namespace {

namespace fs = std::filesystem;
using FilesByName = std::map<std::string, fs::path>;

/// What `inkbench export` writes into the folder of a view.
constexpr const char* kViewFile = "camera.json";
constexpr const char* kTruthFile = "truth.exr";

std::set<fs::path> files_below(const fs::path& folder) {
    std::error_code failure;
    std::set<fs::path> sorted;
    for (auto entry = fs::recursive_directory_iterator(folder, failure);
         !failure && entry != fs::recursive_directory_iterator();
         entry.increment(failure)) {
        if (entry->is_regular_file()) sorted.insert(entry->path());
    }
    if (failure) {
        throw core::Error(folder.string(),
                          "this folder cannot be read: " + failure.message(),
                          "a folder of images");
    }
    return sorted;
}

/// The files below `folder` with one of `endings` (all if none is named), by their relative path
/// without ending. The first of two with one name stays.
FilesByName named_files_below(const fs::path& folder, const std::vector<std::string>& endings) {
    FilesByName files;
    for (const fs::path& path : files_below(folder)) {
        bool is_asked = endings.empty();
        for (const std::string& ending : endings)
            is_asked = is_asked || path.extension() == ending;
        if (is_asked)
            files.emplace(path.lexically_relative(folder).replace_extension().string(), path);
    }
    return files;
}

/// The truths below `folder` by their names. Of an exported view that is its truth alone, under the
/// name of the view's folder, as entrants name their images.
FilesByName truths_below(const fs::path& folder) {
    FilesByName truths;
    // ".exr" sorts before ".png", so it is the one that stays.
    for (const auto& [name, path] : named_files_below(folder, {".exr", ".png"})) {
        const bool is_exported = fs::exists(path.parent_path() / kViewFile);
        if (!is_exported) {
            truths.emplace(name, path);
        } else if (path.filename() == kTruthFile) {
            truths.emplace(fs::path(name).parent_path().string(), path);
        }
    }
    return truths;
}

}  // namespace

std::vector<FolderScore> score_folders(
    const fs::path& predictions,
    const fs::path& truths,
    const ScoreRequest& request,
    const std::function<void(const std::string& name, const FilesScore&)>& on_scored) {
    score::check(request.options);
    const FilesByName truth_files = truths_below(truths);
    if (truth_files.empty())
        throw core::Error(truths.string(), "there is no truth in it", "files of inkbench truth -o");
    const FilesByName drawn = named_files_below(predictions, {});
    std::vector<FolderScore> scores;
    for (const auto& [name, truth] : truth_files) {
        FolderScore& result = scores.emplace_back(FolderScore{name});
        const auto prediction = drawn.find(name);
        if (prediction == drawn.end()) {
            result.status = "there is no image of this name in " + predictions.string();
            continue;
        }
        try {
            const FilesScore scored = score_files(prediction->second, truth, request);
            result.notes = scored.notes;
            result.doubts = scored.doubts;
            if (scored.score.n_truth == 0) {
                result.status = kNoTruth;
                continue;
            }
            result.score = scored.score;
            result.soft = scored.soft;
            on_scored(name, scored);
        } catch (const core::Error& error) {
            result.status = error.what();
        }
    }
    return scores;
}

std::vector<std::string> files_without_truth(const fs::path& predictions, const fs::path& truths) {
    const FilesByName truth_files = truths_below(truths);
    const FilesByName drawn = named_files_below(predictions, {});
    std::vector<std::string> files;
    for (const fs::path& path : files_below(predictions)) {
        const fs::path within = path.lexically_relative(predictions);
        const std::string name = fs::path(within).replace_extension().string();
        const bool is_image =
            path.filename() != "times.csv" && !path.filename().string().starts_with(".");
        const bool is_scored = truth_files.contains(name) && drawn.at(name) == path;
        if (is_image && !is_scored) files.push_back(within.string());
    }
    return files;
}

score::CurveCount pooled(const std::vector<FolderScore>& scores) {
    score::CurveCount total;
    for (const FolderScore& each : scores) {
        if (each.score) total += *each.score;
    }
    return total;
}

std::optional<double> pooled_f(const std::vector<FolderScore>& scores) {
    const score::CurveCount all = pooled(scores);
    if (all.n_truth == 0) return std::nullopt;
    return all.f();
}

}  // namespace ink::given_images
