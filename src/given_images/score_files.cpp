#include "given_images/score_files.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <set>
#include <string_view>
#include <system_error>
#include <variant>

#include "core/error.h"
#include "core/parse_number.h"
#include "draw/exr_layers.h"
#include "image_io/exr_file.h"
#include "image_io/image_file.h"
#include "score/doubts.h"
#include "truth/line_class.h"

namespace ink::given_images {
namespace {

namespace fs = std::filesystem;
using Gray = core::Image<std::uint8_t>;

std::string size_text(const Gray& image) {
    return fmt::format("{} x {} px", image.width_px(), image.height_px());
}

/// What is to be done where the image has another size than the truth.
std::string other_size(const Named<harness::OutlineImage>& prediction,
                       const Named<TruthLabels>& truth) {
    const Gray& image = prediction.held.responses;
    const std::string needed = fmt::format("an image of {}", size_text(truth.held.labels));
    if (truth.held.command.empty()) {
        return fmt::format(
            "{}, or its own truth: inkbench score {} --model MODEL", needed, prediction.name);
    }
    return fmt::format("{}, or its own truth: {} --size {}x{} -o {}",
                       needed,
                       truth.held.command,
                       image.width_px(),
                       image.height_px(),
                       truth.name);
}

void check_sizes(const Named<harness::OutlineImage>& prediction,
                 const Named<TruthLabels>& truth,
                 int band_px) {
    const Gray& image = prediction.held.responses;
    const Gray& labels = truth.held.labels;
    if (image.width_px() != labels.width_px() || image.height_px() != labels.height_px()) {
        throw core::Error(prediction.name,
                          fmt::format("its size is {}, but that of {} is {}",
                                      size_text(image),
                                      truth.name,
                                      size_text(labels)),
                          other_size(prediction, truth));
    }
    const int widest_px = (std::min(labels.width_px(), labels.height_px()) - 1) / 2;
    if (band_px > widest_px) {
        throw core::Error("band",
                          fmt::format("{} px leave nothing of {}", band_px, size_text(labels)),
                          fmt::format("0..{} px", widest_px));
    }
}

void check_coverage(const Named<TruthLabels>& truth, double line_width_px) {
    if (truth.held.coverage.is_empty()) {
        throw core::Error(truth.name,
                          "it does not say what its lines cover",
                          "the .exr of inkbench truth -o, or --model MODEL");
    }
    if (truth.held.line_width_px == line_width_px) return;
    throw core::Error("--line-width",
                      fmt::format("{} covers lines {} px wide, not {}",
                                  truth.name,
                                  truth.held.line_width_px,
                                  line_width_px),
                      fmt::format("{}, or --model MODEL", truth.held.line_width_px));
}

std::vector<std::string> doubts_of_prediction(const std::string& name,
                                              const FilesScore& scored,
                                              const score::ScoringTruth& truth) {
    std::string doubt = score::doubt_of(scored.responses, truth, scored.options, scored.score.f());
    if (doubt.empty()) return {};
    const double share = score::drawn_share(scored.responses, scored.options.threshold);
    if (share > score::kMostDrawn && share < 1) {
        doubt += fmt::format("; if its lines are {}, score it with --polarity {}",
                             scored.is_inverted ? "light on dark" : "dark on light",
                             scored.is_inverted ? "light" : "dark");
    }
    return {name + ": " + doubt};
}

/// A truth holds classes and little else.
std::vector<std::string> doubts_of_truth(const Named<TruthLabels>& truth,
                                         score::Intersections intersections) {
    std::vector<std::string> found;
    std::set<int> unknown;
    const Gray& labels = truth.held.labels;
    for (std::size_t i = 0; i < labels.size(); ++i) {
        const int label = labels.data()[i];
        if (label > static_cast<int>(truth::LineClass::ignore) && label != 255)
            unknown.insert(label);
    }
    if (!unknown.empty()) {
        found.push_back(
            fmt::format("{} holds {} values that are no line class, such as {}; the "
                        "truth is the file of inkbench truth -o, not its coloured "
                        "preview",
                        truth.name,
                        unknown.size(),
                        *unknown.begin()));
    }
    if (truth.held.below_crease_px > 0 && intersections == score::Intersections::above_crease) {
        found.push_back(
            fmt::format("{} px of {} are intersections below the crease angle, and count (truth "
                        "--intersections above_crease leaves them out)",
                        truth.held.below_crease_px,
                        truth.name));
    }
    return found;
}

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

/// The channel called `name`, or null.
template <class T>
const core::Image<T>* find_channel(const image_io::ExrFile& file, std::string_view name) {
    for (const image_io::ExrChannel& channel : file.channels) {
        if (channel.name == name) return std::get_if<core::Image<T>>(&channel.pixels);
    }
    return nullptr;
}

template <class T>
std::optional<T> find_attribute(const image_io::ExrFile& file, std::string_view name) {
    for (const image_io::ExrAttribute& attribute : file.attributes) {
        if (attribute.name != name) continue;
        if (const T* value = std::get_if<T>(&attribute.value)) return *value;
    }
    return std::nullopt;
}

std::optional<int> find_number(const image_io::Texts& texts, const char* name) {
    const auto found = texts.find(name);
    return found == texts.end() ? std::nullopt : core::parse_number<int>(found->second);
}

TruthLabels read_exr_labels(const std::filesystem::path& path, score::Intersections intersections) {
    const image_io::ExrFile file = image_io::read_exr(path);
    const auto* labels = find_channel<std::uint32_t>(file, "class.label");
    if (labels == nullptr) {
        throw core::Error(path.string(),
                          "it has no channel class.label of whole numbers",
                          "the file of inkbench truth -o truth.exr");
    }
    TruthLabels truth{core::mapped<std::uint8_t>(*labels,
                                                 [](std::uint32_t label) {
                                                     return static_cast<std::uint8_t>(
                                                         std::min<std::uint32_t>(label, 255));
                                                 }),
                      find_attribute<double>(file, "ink:ignore_label"),
                      find_attribute<double>(file, "ink:band_px"),
                      true,
                      find_attribute<std::string>(file, "ink:command").value_or("")};
    if (const auto* coverage = find_channel<float>(file, draw::kCoverageChannel)) {
        truth.coverage = *coverage;
        const auto* const end = coverage->data() + coverage->size();
        const auto* const wrong =
            std::find_if(coverage->data(), end, [](float v) { return !std::isfinite(v); });
        if (wrong != end) {
            const auto at = static_cast<int>(wrong - coverage->data());
            throw core::Error(path.string(),
                              fmt::format("channel {} is {} at pixel {},{}",
                                          draw::kCoverageChannel,
                                          *wrong,
                                          at % coverage->width_px(),
                                          at / coverage->width_px()),
                              "finite numbers");
        }
        truth.line_width_px = find_attribute<double>(file, draw::kLineWidthAttribute).value_or(0);
    }
    const auto* below = find_channel<std::uint32_t>(file, "class.below_crease");
    if (below == nullptr) return truth;
    const auto is_below =
        core::mapped<std::uint8_t>(*below, [](std::uint32_t value) { return value != 0; });
    truth.labels = score::counted_labels(truth.labels, is_below, intersections);
    return truth;
}

}  // namespace

std::string label_text(int label) {
    for (const truth::LineClass c : truth::kLineClasses) {
        if (static_cast<int>(c) == label) return fmt::format("{} {}", label, truth::name(c));
    }
    return std::to_string(label);
}

FilesScore score_outline(Named<harness::OutlineImage> prediction,
                         Named<TruthLabels> truth,
                         const ScoreRequest& request) {
    FilesScore scored;
    scored.options = request.options;
    if (!scored.options.ignore_label) scored.options.ignore_label = truth.held.ignore_label;
    scored.options.band_px =
        request.band_px.value_or(truth.held.band_px.value_or(request.options.band_px));
    score::check(scored.options);
    check_sizes(prediction, truth, scored.options.band_px);
    if (request.line_width_px) check_coverage(truth, *request.line_width_px);
    scored.doubts = doubts_of_truth(truth, request.intersections);
    scored.responses = std::move(prediction.held.responses);
    scored.is_inverted = prediction.held.is_inverted;
    scored.notes = std::move(prediction.held.notes);
    scored.labels = std::move(truth.held.labels);
    score::ScoringTruth prepared = score::prepare_truth(scored.labels, scored.options, false);
    if (truth.held.has_classes) prepared.is_binary = false;
    scored.score = score::score(scored.responses, prepared, scored.options);
    if (request.line_width_px) {
        scored.soft = score::score_ink(
            score::ink_of(scored.responses),
            score::prepare_ink(
                std::move(truth.held.coverage), *request.line_width_px, prepared, scored.options),
            scored.options);
    }
    const auto of_prediction = doubts_of_prediction(prediction.name, scored, prepared);
    scored.doubts.insert(scored.doubts.begin(), of_prediction.begin(), of_prediction.end());
    if (scored.score.n_truth == 0) scored.doubts.emplace(scored.doubts.begin(), kNoTruth);
    return scored;
}

FilesScore score_files(const fs::path& prediction,
                       const fs::path& truth,
                       const ScoreRequest& request) {
    score::ScoreOptions options = request.options;
    if (request.band_px) options.band_px = *request.band_px;
    score::check(options);  // before anything is read
    return score_outline(
        {prediction.string(), harness::read_outline_image(prediction, request.polarity)},
        {truth.string(), read_truth_labels(truth, request.intersections)},
        request);
}

draw::RgbImage picture_of(const FilesScore& scored) {
    // Whatever number a line or the ignored places have in the file.
    core::Image<std::uint8_t> labels = scored.labels;
    std::transform(labels.data(), labels.data() + labels.size(), labels.data(), [&](int label) {
        const bool is_ignored = scored.options.ignore_label == label;
        const bool is_class = label > 0 && label <= static_cast<int>(truth::LineClass::seam);
        if (is_ignored) return static_cast<std::uint8_t>(truth::LineClass::ignore);
        if (label == 0 || is_class) return static_cast<std::uint8_t>(label);
        return static_cast<std::uint8_t>(truth::LineClass::contour);
    });
    return draw::error_image(draw::mark_errors(labels,
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

TruthLabels read_truth_labels(const std::filesystem::path& path,
                              score::Intersections intersections) {
    if (path.extension() == ".exr") return read_exr_labels(path, intersections);
    image_io::GrayFile file = image_io::read_gray_file(path);
    if (file.has_colour) {
        throw core::Error(path.string(),
                          "it is in colour: a preview for people, no truth",
                          "an image of class numbers, or the .exr, of inkbench truth -o");
    }
    const auto command = file.texts.find("ink:command");
    return {std::move(file.pixels),
            find_number(file.texts, "ink:ignore_label"),
            find_number(file.texts, "ink:band_px"),
            file.texts.contains("ink:labels"),
            command == file.texts.end() ? "" : command->second,
            find_number(file.texts, "ink:below_crease_px").value_or(0)};
}

}  // namespace ink::given_images
