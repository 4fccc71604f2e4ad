#include "draw/score_files.h"

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <set>
#include <string_view>
#include <system_error>
#include <variant>

#include "core/error.h"
#include "image_io/exr_file.h"
#include "image_io/image_file.h"
#include "score/polarity.h"
#include "truth/line_class.h"

namespace ink::draw {
namespace {

namespace fs = std::filesystem;
using Gray = core::Image<std::uint8_t>;

/// An outline image as edge responses.
struct Prediction {
    edge::EdgeImage responses;  ///< 0 no line .. 255 the strongest
    bool is_inverted = false;   ///< the file has dark lines on light
};

/// A truth image, and how it wants to be scored against.
struct TruthLabels {
    core::Image<std::uint8_t> labels;      ///< 0 no line, every other value a class
    std::optional<int> ignore_label = {};  ///< that the file names
    std::optional<int> band_px = {};       ///< that the file names
    bool has_classes = false;              ///< its values are classes, even a lone 1
};

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

std::string size_text(const Gray& image) {
    return fmt::format("{} x {} px", image.width_px(), image.height_px());
}

void check_sizes(const fs::path& prediction_path,
                 const fs::path& truth_path,
                 const FilesScore& scored) {
    const Gray& prediction = scored.responses;
    const Gray& truth = scored.labels;
    if (prediction.width_px() != truth.width_px() || prediction.height_px() != truth.height_px()) {
        throw core::Error(prediction_path.string(),
                          fmt::format("its size is {}, but that of {} is {}",
                                      size_text(prediction),
                                      truth_path.string(),
                                      size_text(truth)),
                          "two images of one size");
    }
    const int widest_px = (std::min(truth.width_px(), truth.height_px()) - 1) / 2;
    const int band_px = scored.options.band_px;
    if (band_px > widest_px) {
        throw core::Error("band",
                          fmt::format("{} px leave nothing of {}", band_px, size_text(truth)),
                          fmt::format("0..{} px", widest_px));
    }
}

/// Lines cover a small part of any image; a truth holds classes and little else.
std::vector<std::string> doubts(const fs::path& prediction_path,
                                const fs::path& truth_path,
                                const FilesScore& scored) {
    constexpr double kMostDrawn = 0.5;
    std::vector<std::string> found;
    if (scored.score.n_truth == 0) found.emplace_back(kNoTruth);
    const Gray& prediction = scored.responses;
    const auto drawn = std::count_if(prediction.data(),
                                     prediction.data() + prediction.size(),
                                     [&](int v) { return v >= scored.options.threshold; });
    const double share = static_cast<double>(drawn) / static_cast<double>(prediction.size());
    if (share > kMostDrawn) {
        found.push_back(fmt::format(
            "{:.0f} % of {} count as drawn; if its lines are {}, score it with --polarity {}",
            100 * share,
            prediction_path.string(),
            scored.is_inverted ? "light on dark" : "dark on light",
            scored.is_inverted ? "light" : "dark"));
    }
    std::set<int> unknown;
    for (std::size_t i = 0; i < scored.labels.size(); ++i) {
        const int label = scored.labels.data()[i];
        if (label > static_cast<int>(truth::LineClass::ignore) && label != 255)
            unknown.insert(label);
    }
    if (!unknown.empty()) {
        found.push_back(
            fmt::format("{} holds {} values that are no line class, such as {}; the "
                        "truth is the file of inkbench truth -o, not its coloured "
                        "preview",
                        truth_path.string(),
                        unknown.size(),
                        *unknown.begin()));
    }
    return found;
}

using FilesByName = std::map<std::string, fs::path>;

/// What `inkbench export` writes into the folder of a view.
constexpr const char* kViewFile = "camera.json";
constexpr const char* kTruthFile = "truth.exr";

/// The files below `folder` with one of `endings` (all if none is named), by their relative path
/// without ending. The first of two with one name stays.
FilesByName files_below(const fs::path& folder, const std::vector<std::string>& endings) {
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
    FilesByName files;
    for (const fs::path& path : sorted) {
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
    for (const auto& [name, path] : files_below(folder, {".exr", ".png"})) {
        const bool is_exported = fs::exists(path.parent_path() / kViewFile);
        if (!is_exported) {
            truths.emplace(name, path);
        } else if (path.filename() == kTruthFile) {
            truths.emplace(fs::path(name).parent_path().string(), path);
        }
    }
    return truths;
}

/// Reads an 8-bit image. One that holds a single value has no lines on it, and is taken as it is
/// where `polarity` is automatic. Throws core::Error as image_io::read_gray does.
Prediction read_prediction(const std::filesystem::path& path, Polarity polarity) {
    Prediction prediction{image_io::read_gray(path)};
    Gray& image = prediction.responses;
    prediction.is_inverted = polarity == Polarity::dark_on_light ||
                             (polarity == Polarity::automatic && score::has_dark_lines(image));
    if (prediction.is_inverted) score::invert(image);
    return prediction;
}

/// Reads a truth: an 8-bit image of classes, or the EXR of `inkbench truth -o` (channel
/// class.label), which also names its ignore label and band. In an EXR intersections that
/// `intersections` does not count become the ignore label.
///
/// Throws core::Error for a file that cannot be read, an EXR without that channel, and an image in
/// colour: that is a preview for people, no truth.
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

}  // namespace

std::string label_text(int label) {
    for (const truth::LineClass c : truth::kLineClasses) {
        if (static_cast<int>(c) == label) return fmt::format("{} {}", label, truth::name(c));
    }
    return std::to_string(label);
}

FilesScore score_files(const fs::path& prediction,
                       const fs::path& truth,
                       const ScoreRequest& request) {
    FilesScore scored;
    scored.options = request.options;
    if (request.band_px) scored.options.band_px = *request.band_px;
    score::check(scored.options);
    Prediction drawn = read_prediction(prediction, request.polarity);
    scored.responses = std::move(drawn.responses);
    scored.is_inverted = drawn.is_inverted;
    TruthLabels labels = read_truth_labels(truth, request.intersections);
    scored.labels = std::move(labels.labels);
    if (!scored.options.ignore_label) scored.options.ignore_label = labels.ignore_label;
    if (!request.band_px && labels.band_px) scored.options.band_px = *labels.band_px;
    check_sizes(prediction, truth, scored);
    score::ScoringTruth prepared = score::prepare_truth(scored.labels, scored.options, false);
    if (labels.has_classes) prepared.is_binary = false;
    scored.score = score::score(scored.responses, prepared, scored.options);
    scored.doubts = doubts(prediction, truth, scored);
    return scored;
}

RgbImage picture_of(const FilesScore& scored) {
    // Whatever number a line or the ignored places have in the file.
    core::Image<std::uint8_t> labels = scored.labels;
    std::transform(labels.data(), labels.data() + labels.size(), labels.data(), [&](int label) {
        const bool is_ignored = scored.options.ignore_label == label;
        const bool is_class = label > 0 && label <= static_cast<int>(truth::LineClass::seam);
        if (is_ignored) return static_cast<std::uint8_t>(truth::LineClass::ignore);
        if (label == 0 || is_class) return static_cast<std::uint8_t>(label);
        return static_cast<std::uint8_t>(truth::LineClass::contour);
    });
    return error_image(mark_errors(labels,
                                   scored.responses,
                                   {.threshold = scored.options.threshold,
                                    .tolerance_px = scored.options.tolerance_px,
                                    .band_px = scored.options.band_px}));
}

std::vector<FolderScore> score_folders(
    const fs::path& predictions,
    const fs::path& truths,
    const ScoreRequest& request,
    const std::function<void(const std::string& name, const FilesScore&)>& on_scored) {
    score::check(request.options);
    const FilesByName truth_files = truths_below(truths);
    if (truth_files.empty())
        throw core::Error(truths.string(), "there is no truth in it", "files of inkbench truth -o");
    const FilesByName drawn = files_below(predictions, {});
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
            if (scored.score.n_truth == 0) {
                result.status = kNoTruth;
                continue;
            }
            result.score = scored.score;
            on_scored(name, scored);
        } catch (const core::Error& error) {
            result.status = error.what();
        }
    }
    return scores;
}

score::CurveCount pooled(const std::vector<FolderScore>& scores) {
    score::CurveCount total;
    for (const FolderScore& each : scores) {
        if (each.score) total += {each.score->k, each.score->n_pred, each.score->n_truth};
    }
    return total;
}

std::optional<double> pooled_f(const std::vector<FolderScore>& scores) {
    const score::CurveCount all = pooled(scores);
    if (all.n_truth == 0) return std::nullopt;
    return all.f();
}

}  // namespace ink::draw
