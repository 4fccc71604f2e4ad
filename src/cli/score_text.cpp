#include "cli/score_text.h"

#include <fmt/ranges.h>

#include <algorithm>
#include <map>
#include <nlohmann/json.hpp>

#include <optional>
#include <utility>
#include <vector>

#include "cli/json_values.h"
#include "core/tables/csv.h"
#include "core/text_table.h"

namespace ink::cli {
namespace {

using Json = nlohmann::ordered_json;

std::optional<double> mean_width(const score::Score& s) {
    return s.mean_width_px > 0 ? std::optional(s.mean_width_px) : std::nullopt;
}

std::string four_places(std::optional<double> value) {
    return value ? fmt::format("{:.4f}", *value) : "-";
}

/// Numbers by their columns; null where there is none.
using Numbers = std::vector<std::pair<const char*, Json>>;

Numbers numbers_of(const score::Score& s) {
    return {{"f", or_null(s.f_of_truth())},
            {"precision", or_null(s.precision())},
            {"recall", or_null(s.recall())},
            {"k", s.k},
            {"n_pred", s.n_pred},
            {"n_truth", s.n_truth},
            {"unmatched_duplicates", s.unmatched_duplicates},
            {"false_positives", s.false_positives},
            {"unmatched_truth", s.unmatched_truth},
            {"false_negatives", s.false_negatives},
            {"mean_width_px", or_null(mean_width(s))}};
}

/// Those of grey lines, by the names of rows.csv.
Numbers numbers_of(const score::SoftScore& soft) {
    return {{"soft_f", or_null(soft.f())},
            {"ink_line_width_px", soft.line_width_px},
            {"ink_matched_px", soft.matched_px},
            {"ink_misplaced_px", soft.misplaced_px},
            {"ink_surplus_px", soft.surplus_px},
            {"ink_missing_px", soft.missing_px}};
}

Json scored_json(const score::Score& s, const std::optional<score::SoftScore>& soft) {
    Json result = Json::object();
    for (const auto& [name, value] : numbers_of(s))
        result[name] = value;
    // The names of before.
    result["surplus"] = s.unmatched_duplicates;
    result["off_line"] = s.false_positives;
    result["lost"] = s.unmatched_truth;
    result["missing"] = s.false_negatives;
    result["mean_width"] = or_null(mean_width(s));
    result["classes"] = Json::object();
    result["class_names"] = Json::object();
    for (const score::ClassCount& c : s.classes) {
        const std::string label = std::to_string(c.label);
        result["classes"][label] = {{"k", c.k}, {"n_truth", c.n_truth}};
        result["class_names"][label] = given_images::label_text(c.label);
    }
    if (!soft) return result;
    for (const auto& [name, value] : numbers_of(*soft))
        result[name] = value;
    return result;
}

/// As in all tables; nothing for null.
std::string csv_text(const Json& value) {
    if (value.is_null()) return "";
    return value.is_number_float() ? fmt::format("{}", value.get<double>()) : value.dump();
}

std::string ink_lines(const score::SoftScore& soft) {
    return fmt::format(
        "\n  soft F      {:>6}   of grey lines {} px wide; in px^2:\n"
        "  {:.1f} drawn = {:.1f} matched + {:.1f} misplaced + {:.1f} surplus\n"
        "  {:.1f} true = {:.1f} matched + {:.1f} misplaced + {:.1f} missing\n",
        four_places(soft.f()),
        soft.line_width_px,
        soft.drawn_px(),
        soft.matched_px,
        soft.misplaced_px,
        soft.surplus_px,
        soft.true_px(),
        soft.matched_px,
        soft.misplaced_px,
        soft.missing_px);
}

}  // namespace

std::string score_json(const given_images::FilesScore& scored) {
    Json result = scored_json(scored.score, scored.soft);
    result["polarity"] = scored.is_inverted ? "dark" : "light";
    result["band"] = scored.options.band_px;
    result["ignore"] =
        scored.options.ignore_label ? Json(*scored.options.ignore_label) : Json(nullptr);
    result["notes"] = scored.notes;
    result["doubts"] = scored.doubts;
    return result.dump(2) + "\n";
}

std::string score_table(const std::filesystem::path& prediction,
                        const std::string& truth_name,
                        const given_images::FilesScore& scored) {
    const score::Score& s = scored.score;
    const score::ScoreOptions& options = scored.options;
    std::string text = fmt::format("{} against {}\n", prediction.filename().string(), truth_name);
    text += fmt::format("within {} px, {}, edge response {} and above, {}",
                        options.tolerance_px,
                        scored.is_inverted ? "dark lines on light" : "light lines on dark",
                        options.threshold,
                        options.thin ? "thinned" : "not thinned");
    if (options.band_px > 0) text += fmt::format(", {} px of the frame left out", options.band_px);
    if (options.ignore_label) text += fmt::format(", {} ignored", *options.ignore_label);
    if (!scored.notes.empty()) text += fmt::format("\nread as: {}", fmt::join(scored.notes, "; "));
    text += fmt::format("\n\n  F           {:>6}\n", four_places(s.f_of_truth()));
    text += fmt::format(
        "  precision   {:>6}   {} predicted = {} matched + {} unmatched duplicates + {} false "
        "positives\n",
        four_places(s.precision()),
        s.n_pred,
        s.k,
        s.unmatched_duplicates,
        s.false_positives);
    text += fmt::format(
        "  recall      {:>6}   {} true = {} matched + {} unmatched truth + {} false negatives\n",
        four_places(s.recall()),
        s.n_truth,
        s.k,
        s.unmatched_truth,
        s.false_negatives);
    text += fmt::format("  mean width  {:>6} px\n",
                        s.mean_width_px > 0 ? fmt::format("{:.2f}", s.mean_width_px) : "-");
    if (scored.soft) text += ink_lines(*scored.soft);
    if (s.classes.empty()) return text;
    text += fmt::format("\n  {:<16} {:>6} {:>9} {:>9}\n", "class", "recall", "matched", "true");
    for (const score::ClassCount& c : s.classes) {
        text += fmt::format("  {:<16} {:>6.4f} {:>9} {:>9}\n",
                            given_images::label_text(c.label),
                            static_cast<double>(c.k) / static_cast<double>(c.n_truth),
                            c.k,
                            c.n_truth);
    }
    return text;
}

std::string folder_table(const std::vector<given_images::FolderScore>& scores, bool is_markdown) {
    const char* const item = is_markdown ? "- " : "";
    core::Cells cells{{"image", "F", "precision", "recall", "predicted", "true"}};
    std::map<std::string, std::string> read_as;  // the images by how they were read
    std::string unscored;
    for (const given_images::FolderScore& each : scores) {
        if (!each.score) {
            unscored += fmt::format("{}no score: {}: {}\n", item, each.name, each.status);
            continue;
        }
        if (!each.notes.empty()) {
            std::string& names = read_as[fmt::format("{}", fmt::join(each.notes, "; "))];
            names += (names.empty() ? "" : ", ") + each.name;
        }
        cells.push_back({each.name,
                         four_places(each.score->f()),
                         four_places(each.score->precision()),
                         four_places(each.score->recall()),
                         std::to_string(each.score->n_pred),
                         std::to_string(each.score->n_truth)});
    }
    const score::CurveCount all = given_images::pooled(scores);
    cells.push_back({"all, pooled",
                     four_places(given_images::pooled_f(scores)),
                     "",
                     "",
                     std::to_string(all.n_pred),
                     std::to_string(all.n_truth)});
    std::string text = is_markdown ? core::markdown(cells) + "\n" : core::aligned(cells);
    text += unscored;
    for (const auto& [how, names] : read_as)
        text += fmt::format("{}read as {}: {}\n", item, how, names);
    return text;
}

std::string folder_json(const std::vector<given_images::FolderScore>& scores,
                        const std::vector<std::string>& unmatched) {
    Json result = {{"images", Json::object()}};
    for (const given_images::FolderScore& each : scores) {
        Json image = each.score ? scored_json(*each.score, each.soft) : Json::object();
        image["status"] = each.status;
        if (each.score) {
            image["notes"] = each.notes;
            image["doubts"] = each.doubts;
        }
        result["images"][each.name] = std::move(image);
    }
    const score::CurveCount all = given_images::pooled(scores);
    result["pooled"] = {{"k", all.k},
                        {"n_pred", all.n_pred},
                        {"n_truth", all.n_truth},
                        {"f", or_null(given_images::pooled_f(scores))}};
    result["unmatched"] = unmatched;
    return result.dump(2) + "\n";
}

std::string folder_csv(const std::vector<given_images::FolderScore>& scores) {
    const bool has_ink =
        std::ranges::any_of(scores, [](const auto& each) { return each.soft.has_value(); });
    const auto numbers_of_all = [&](const given_images::FolderScore& each) {
        Numbers numbers = numbers_of(each.score.value_or(score::Score{}));
        if (!has_ink) return numbers;
        for (auto& number : numbers_of(each.soft.value_or(score::SoftScore{})))
            numbers.push_back(each.soft ? std::move(number) : std::pair(number.first, Json()));
        return numbers;
    };
    std::string text = "image,status";
    for (const auto& [name, value] : numbers_of_all({}))
        text += fmt::format(",{}", name);
    text += "\n";
    for (const given_images::FolderScore& each : scores) {
        text += core::csv_field(each.name) + "," + core::csv_field(each.status);
        for (const auto& [name, value] : numbers_of_all(each))
            text += "," + (each.score ? csv_text(value) : "");
        text += "\n";
    }
    return text;
}

}  // namespace ink::cli
