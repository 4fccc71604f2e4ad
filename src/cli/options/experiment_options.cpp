#include "cli/options/experiment_options.h"

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <glob.h>

#include <algorithm>
#include <filesystem>

#include "catalogue/catalogue.h"
#include "cli/name_list.h"
#include "cli/options/command_rows.h"
#include "core/error.h"
#include "core/named.h"
#include "experiment/experiment.h"
#include "experiment/options/option_table.h"
#include "harness/images/view_images.h"
#include "methods/registry.h"

namespace ink::cli {
namespace {

/// How messages call the option of a row: "--axes" of "--axes,--axis".
std::string flag_of(const std::string& row) {
    const experiment::OptionTable& table = experiment::option_table();
    return called(table.options[table.row(row)].flag);
}

/// The names of all registered methods.
std::vector<std::string> method_words() {
    return core::names_of(methods::registry());
}

/// As help has it; nothing for what has no value.
std::string usual_text(const experiment::Experiment& usual, std::size_t row) {
    const std::vector<std::string> texts = experiment::option_table().texts(usual, row);
    return texts.size() == 1 ? texts.front() : "";
}

std::string type_of(const core::Param& param) {
    if (param.kind != core::ParamKind::choice) return param.unit;
    return fmt::format("{}", fmt::join(param.choices, "|"));
}

std::string comma_joined(const std::vector<std::string>& names) {
    return fmt::format("{}", fmt::join(names, ","));
}

constexpr const char* kGroups[] = {"train", "heldout", "catalogue"};
constexpr const char* kType = "SCENES";
constexpr const char* kOneType = "SCENE";

bool is_file(const std::string& text) {
    std::error_code ignored;
    return std::filesystem::is_regular_file(text, ignored);
}

std::vector<std::string> files_fitting(const std::string& pattern) {
    glob_t found{};
    std::vector<std::string> files;
    if (glob(pattern.c_str(), 0, nullptr, &found) == 0)
        files.assign(found.gl_pathv, found.gl_pathv + found.gl_pathc);
    globfree(&found);
    return files;
}

/// Adds what one part of a list means.
void add_part(const std::string& part, const Names& names, NameList& list) {
    if (is_glob(part)) {
        std::vector<std::string> found = fitting(part, core::names_of(catalogue::catalogue()));
        if (found.empty()) found = files_fitting(part);
        if (found.empty()) refuse_name(names, part);
        for (const std::string& name : found)
            list.add_implied(name);
        return;
    }
    const auto meant = experiment::scenes_called(part);
    if (meant != std::vector{part}) {
        for (const std::string& name : meant)
            list.add_implied(name);
        return;
    }
    // A path that leads nowhere is told when it is opened, with the formats that can be read.
    const bool is_path = part.find_first_of("./") != std::string::npos;
    const auto& known = names.known;
    const bool is_known = std::find(known.begin(), known.end(), part) != known.end();
    if (!is_known && !is_path && !std::filesystem::exists(part)) refuse_name(names, part);
    list.add(part);
}

void add_texts(const std::vector<std::string>& texts, const Names& names, NameList& list) {
    for (const std::string& text : texts) {
        const auto parts = is_file(text) ? std::vector<std::string>{text} : list_parts({text});
        for (const std::string& part : parts) {
            if (is_file(part)) {
                list.add(part);
            } else {
                add_part(part, names, list);
            }
        }
        if (parts.empty()) {
            throw core::Error(names.option,
                              fmt::format("'{}' names no scene", text),
                              "built-in scenes (see inkbench list scenes) or model files");
        }
    }
}

}  // namespace

void ExperimentOptions::add_to(CLI::App& command,
                               const std::vector<std::string>& rows,
                               const std::string& doc) {
    const experiment::OptionTable& table = experiment::option_table();
    for (const std::string& name : rows) {
        const std::size_t row = table.row(name);
        const core::Param& param = table.param(row);
        const std::string& flag = table.options[row].flag;
        const std::string help = doc.empty() ? param.doc : doc;
        std::vector<std::string>& given = given_[row];
        if (param.kind == core::ParamKind::flag) {
            const std::string value = flag.starts_with("--no-") ? "false" : "true";
            command.add_flag_callback(
                flag, [&given, value] { given = {value}; }, help);
        } else if (param.kind == core::ParamKind::list && !table.options[row].is_once) {
            CommandRows(command).list(flag, given, type_of(param), help);
        } else {
            command.add_option(flag, given, help)
                ->type_name(type_of(param))
                ->expected(1)
                ->allow_extra_args(false)  // what follows is an argument of its own
                ->default_str(usual_text(usual_, row));
        }
    }
}

experiment::Experiment ExperimentOptions::read() const {
    const experiment::OptionTable& table = experiment::option_table();
    experiment::Experiment experiment = usual_;
    for (const auto& [row, texts] : given_) {
        if (texts.empty()) continue;
        const std::string where = flag_of(table.param(row).name);
        const std::string& noun = table.options[row].noun;
        const std::vector<std::string> named =
            noun.empty() ? texts : listed_names(texts, {where, noun, table.param(row).choices});
        std::vector<core::GivenText> given;
        for (const std::string& text : named)
            given.push_back({text, where});
        table.rows.set(experiment, row, given, "it");
    }
    experiment::settle_views(experiment.view_request);
    return experiment;
}

const std::vector<std::string>& ExperimentOptions::given(const std::string& row) const {
    static const std::vector<std::string> kNothing;
    const auto found = given_.find(experiment::option_table().row(row));
    return found == given_.end() ? kNothing : found->second;
}

const std::vector<std::string>& truth_rows() {
    static const std::vector<std::string> rows = {
        "measure.crease_deg", "measure.weld_epsilon", "measure.intersections"};
    return rows;
}

void add_method_options(CLI::App& command,
                        std::vector<std::string>& texts,
                        const std::string& usual) {
    CommandRows(command).list(
        "--methods,--method",
        texts,
        "METHODS",
        fmt::format(
            "Methods a,b or globs such as 'mote*' (see inkbench list methods) (default: {})",
            usual));
}

void add_one_method_option(CLI::App& command,
                           std::vector<std::string>& texts,
                           const std::string& usual,
                           const std::string& doc) {
    CommandRows(command).list("--method,--methods", texts, "METHOD", doc)->default_str(usual);
}

std::string method_list(const std::vector<std::string>& texts) {
    return comma_joined(listed_names(texts, {"--methods", "method", method_words()}));
}

std::string one_method(const std::vector<std::string>& texts,
                       const std::string& usual,
                       const std::string& option) {
    if (texts.empty()) return usual;
    const auto names = listed_names(texts, {option, "method", method_words()});
    if (names.size() == 1) return names.front();
    throw core::Error(option,
                      fmt::format("'{}' is not one method", comma_joined(names)),
                      "one name of inkbench list methods");
}

void add_set_option(CLI::App& command, std::vector<std::string>& settings, const std::string& doc) {
    CommandRows(command).list(
        "--set", settings, "KEY=VALUE", doc + "; may be given again (see inkbench list params)");
}

// Arguments are in capitals: since 2.4, CLI11 refuses one that is called like an option without its
// dashes.

void add_scene_options(CLI::App& command, SceneOptions& options, const std::string& doc) {
    CommandRows rows(command);
    rows.text(kType, options.named, kType, doc + "; the same as --scenes");
    rows.list("--scenes,--scene",
              options.listed,
              kType,
              "Built-in scenes and model files a,b; train, heldout or catalogue; globs such as "
              "'c*' (see inkbench list scenes)");
}

void add_one_scene_options(CLI::App& command, SceneOptions& options) {
    CommandRows rows(command);
    // As a list, so that a second scene is refused in our own words.
    rows.text(kOneType, options.named, kOneType, "A built-in scene or a model file")
        ->option_text(kOneType);
    rows.list("--scene,--scenes", options.listed, kOneType, "The same, as an option");
}

std::vector<std::string> scene_words() {
    std::vector<std::string> words = core::names_of(catalogue::catalogue());
    words.insert(words.end(), std::begin(kGroups), std::end(kGroups));
    return words;
}

std::vector<std::string> scene_names(const SceneOptions& options) {
    NameList list;
    add_texts(options.listed, {"--scenes", "scene", scene_words()}, list);
    add_texts(options.named, {kType, "scene", scene_words()}, list);
    return list.names();
}

std::string name_after(const std::vector<std::string>& scenes, const std::string& otherwise) {
    if (scenes.empty() || scenes.size() > 3) return otherwise;
    std::vector<std::string> names;
    for (const std::string& scene : scenes)
        names.push_back(std::filesystem::path(scene).stem().string());
    return harness::file_name(fmt::format("{}", fmt::join(names, "_")));
}

std::string one_scene(const SceneOptions& options, const std::string& command) {
    const std::vector<std::string> names = scene_names(options);
    if (names.size() == 1) return names.front();
    throw core::Error(command,
                      names.empty() ? std::string("the scene is missing")
                                    : fmt::format("it takes one scene, these are {}: {}",
                                                  names.size(),
                                                  fmt::join(names, ", ")),
                      "one built-in scene (see inkbench list scenes) or model file");
}

}  // namespace ink::cli
