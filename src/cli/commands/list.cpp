#include <fmt/args.h>
#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <memory>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "catalogue/catalogue.h"
#include "cli/commands/commands.h"
#include "cli/help_format.h"
#include "cli/json_values.h"
#include "cli/options/command_rows.h"
#include "cli/shader_counts.h"
#include "core/error.h"
#include "core/named.h"
#include "core/param.h"
#include "experiment/dictionary.h"
#include "harness/rows/methods_table.h"
#include "harness/rows/row_table.h"
#include "methods/antialias.h"
#include "methods/method_configs.h"
#include "methods/registry.h"
#include "raster/skips.h"
#include "shade/shading.h"
#include "studies/axis.h"

namespace ink::cli {
namespace {

using Json = nlohmann::ordered_json;

constexpr std::size_t kListWidth = 80;
constexpr std::size_t kMostNames = 100;  ///< of one topic in the overview

Json params_json(const std::vector<core::Param>& params) {
    return list_of<Json>(params, [](const core::Param& param) -> Json {
        return {{"name", param.name},
                {"default", core::format_param(param, param.default_value)},
                {"accepted", core::accepted_values(param)},
                {"min", param.min},
                {"max", param.max},
                {"unit", param.unit},
                {"doc", param.doc}};
    });
}

Json methods_json() {
    return list_of<Json>(methods::registry(), [](const method::MethodInfo& info) -> Json {
        return {{"name", info.name},
                {"summary", info.summary},
                {"source", info.source},
                {"cost", method::cost_sentence(info.make({})->cost())},
                {"shader_instructions", shader_json(info.name)}};
    });
}

Json scenes_json() {
    return list_of<Json>(catalogue::catalogue(),
                         [](const catalogue::CatalogueEntry& entry) -> Json {
                             const scene::Scene made = entry.make();
                             return {{"name", entry.name},
                                     {"split", scene::split_name(entry.split)},
                                     {"kind", entry.kind},
                                     {"triangles", scene::triangle_count(made)},
                                     {"views", made.cameras.size()},
                                     {"summary", entry.summary}};
                         });
}

Json method_params_json() {
    return list_of<Json>(methods::registry(), [](const method::MethodInfo& info) -> Json {
        return {{"method", info.name}, {"params", params_json(info.params)}};
    });
}

Json columns_of(const core::TableInfo& table) {
    return list_of<Json>(table.columns, [](const core::Column& c) -> Json {
        return {{"name", c.name}, {"unit", c.unit}, {"doc", c.doc}, {"is_time", c.is_time}};
    });
}

Json tables_json() {
    return list_of<Json>(experiment::dictionary(), [](const core::TableInfo& table) -> Json {
        return {{"name", table.file}, {"doc", table.doc}, {"columns", columns_of(table)}};
    });
}

Json skips_json() {
    return list_of<Json>(raster::skip_infos(), [](const raster::SkipInfo& info) -> Json {
        return {{"name", info.name}, {"unit", info.unit}, {"summary", info.summary}};
    });
}

Json shadings_json() {
    return list_of<Json>(shade::shadings(), [](const shade::ShadingInfo& info) -> Json {
        return {{"name", info.name},
                {"summary", info.summary},
                {"source", info.source},
                {"params", params_json(info.params)}};
    });
}

Json axes_json() {
    return list_of<Json>(studies::stress_axes(), [](const studies::Axis& axis) -> Json {
        return {{"name", axis.name},
                {"title", axis.title},
                {"unit", axis.unit},
                {"values", axis.values},
                {"sentence", axis.sentence}};
    });
}

/// The entry's texts and counts where `format` has their names.
std::string filled(const char* format, const Json& entry) {
    fmt::dynamic_format_arg_store<fmt::format_context> fields;
    for (const auto& [key, value] : entry.items()) {
        if (value.is_string()) fields.push_back(fmt::arg(key.c_str(), value.get<std::string>()));
        if (value.is_number_unsigned())
            fields.push_back(fmt::arg(key.c_str(), value.get<std::size_t>()));
    }
    return fmt::vformat(format, fields);
}

constexpr const char* kNameLines = "  {name:<10} {summary}\n             source: {source}\n";

std::string method_lines(const Json& entry) {
    const std::string shader = shader_text(entry.at("name").get<std::string>());
    return filled(kNameLines, entry) + filled("             cost: {cost}\n", entry) +
           (shader.empty() ? "" : fmt::format("             shader: {}\n", shader));
}

std::string scene_line(const Json& entry) {
    return filled(
        "  {name:<16} {split:<8} {kind:<12} {triangles:>6} triangles, {views} views  {summary}\n",
        entry);
}

std::string param_lines(const std::string& owner, const Json& params) {
    std::string text = fmt::format("  {}\n", owner);
    for (Json param : params) {
        const auto unit = param.at("unit").get<std::string>();
        param["in_unit"] = unit.empty() ? "" : ", " + unit;
        text += filled("    {name:<16} {default:<10} {accepted}{in_unit}  {doc}\n", param);
    }
    return text;
}

std::string params_of_method(const Json& entry) {
    return param_lines(entry.at("method").get<std::string>(), entry.at("params"));
}

std::string column_line(const Json& entry) {
    return filled("  {name:<22} {unit:<10} {doc}\n", entry);
}

std::string skip_line(const Json& entry) {
    return filled("  {name:<18} {unit:<10} {summary}\n", entry);
}

std::string shading_lines(const Json& entry) {
    return filled(kNameLines, entry) +
           param_lines(filled("parameters of {name}", entry), entry.at("params"));
}

std::string axis_lines(const Json& entry) {
    const auto name = entry.at("name").get<std::string>();
    const studies::Axis& axis = *core::find_named(studies::stress_axes(), name);
    return filled("  {name:<14} {title}: ", entry) +
           fmt::format("{} .. {}, {} points\n",
                       studies::format_value(axis, axis.values.front()),
                       studies::format_value(axis, axis.values.back()),
                       axis.values.size()) +
           filled("                 {sentence}\n", entry);
}

/// What the program knows of one kind of thing.
struct Topic {
    std::string_view name;
    const char* title;
    const char* use;                          ///< by which options
    Json (*list)();                           ///< objects, with `name` first but for params
    std::string (*lines)(const Json& entry);  ///< for a terminal
};
// clang-format off
constexpr Topic kTopics[] = {
    {"methods", "Methods", "methods (inkbench compare --methods a,b)", methods_json, method_lines},
    {"scenes", "Scenes", "scenes (inkbench compare --scenes a,b)", scenes_json, scene_line},
    {"params", "Parameters of methods", "parameters (--set key=value, or --set method.key=value)",
     method_params_json, params_of_method},
    {"metrics", "Columns of rows.csv", "columns of rows.csv",
     [] { return columns_of(harness::rows_table()); }, column_line},
    {"columns", "Tables of a run folder", "", tables_json, nullptr},
    {"skips", "Skips", "skips (--no-skip a,b or all; the image is the same)", skips_json, skip_line},
    {"shadings", "Shadings", "shadings (inkbench draw --shading NAME --set-shade key=value)",
     shadings_json, shading_lines},
    {"axes", "Axes of difficulty", "axes of difficulty (inkbench stress --axes a,b)",
     axes_json, axis_lines},
};
// clang-format on

std::string text_of(const Topic& topic) {
    if (topic.lines == nullptr) return experiment::dictionary_text();
    std::string text = std::string(topic.use) + "\n";
    for (const Json& entry : topic.list())
        text += topic.lines(entry);
    return text;
}

/// For a terminal: of one topic, or of all but the columns, with units, ranges and defaults.
std::string listing(const std::string& what) {
    std::string text;
    for (const Topic& topic : kTopics)
        if (what == topic.name || (what == "all" && topic.lines != nullptr)) text += text_of(topic);
    return text;
}

/// Every name of a topic once, in order.
std::vector<std::string> names_of(const Json& list) {
    std::vector<std::string> names;
    std::set<std::string> known;
    const auto add = [&](const Json& entry) {
        if (auto name = entry.at("name").get<std::string>(); known.insert(name).second)
            names.push_back(std::move(name));
    };
    for (const Json& entry : list) {
        if (!entry.contains("method")) {
            add(entry);
            continue;
        }
        for (const Json& param : entry.at("params"))
            add(param);
    }
    return names;
}

/// The same for programs: an object with one array per topic; params are objects of `method` and
/// its `params`.
Json listing_json(const std::string& what) {
    Json json = Json::object();
    for (const Topic& topic : kTopics)
        if (what == "all" || what == topic.name) json[std::string(topic.name)] = topic.list();
    return json;
}

/// Throws unless there is a topic of that name, or it is "all".
void check_known(const std::string& what) {
    std::vector<std::string> known = core::names_of(kTopics);
    known.insert(known.begin(), "all");
    if (std::find(known.begin(), known.end(), what) != known.end()) return;
    throw core::Error(
        "list", fmt::format("there is no list of '{}'", what), core::known_names(known, what));
}

/// The names of everything, a few lines per topic, and where more is said.
std::string list_overview() {
    std::string text;
    for (const Topic& topic : kTopics) {
        auto names = names_of(topic.list());
        const std::size_t count = names.size();
        names.resize(std::min(count, kMostNames));
        if (count > kMostNames) names.push_back(fmt::format("and {} more", count - kMostNames));
        text += fmt::format("{}, {} (inkbench list {})\n  {}\n\n",
                            topic.title,
                            count,
                            topic.name,
                            wrapped(fmt::format("{}", fmt::join(names, ", ")), kListWidth, 2));
    }
    return text + "inkbench list all: everything with units, ranges and defaults\n";
}

struct ListArgs {
    std::string what;
    bool is_json = false;
    bool is_csv = false;
    bool is_markdown = false;
};

/// Throws unless `flag` is for the topic it is asked for.
void check_topic(bool is_asked, const char* flag, const std::string& what, const char* topic) {
    if (!is_asked || what == topic) return;
    throw core::Error(flag,
                      fmt::format("it is not for '{}'", what.empty() ? "all" : what),
                      fmt::format("inkbench list {} {}", topic, flag));
}

std::string list_text(const ListArgs& args) {
    check_topic(args.is_csv, "--csv", args.what, "methods");
    check_topic(args.is_markdown, "--markdown", args.what, "columns");
    if (args.is_csv) {
        return harness::methods_csv(methods::at_each_antialias(
            methods::make_configs("", {}), {methods::Antialias::none}, 1));
    }
    if (args.is_markdown) return experiment::dictionary_markdown();
    if (!args.what.empty()) check_known(args.what);
    if (args.is_json) return listing_json(args.what.empty() ? "all" : args.what).dump(2) + "\n";
    return args.what.empty() ? list_overview() : listing(args.what);
}

}  // namespace

void add_list_command(CLI::App& app) {
    auto args = std::make_shared<ListArgs>();
    auto* command = app.add_subcommand(
        "list", "List methods, scenes, parameters, metrics, columns, skips, shadings and axes");
    CommandRows rows(*command);
    // clang-format off
    rows.text("what", args->what, "all|methods|scenes|params|metrics|columns|skips|shadings|axes",
              "The topic (default: the names of all)");
    rows.flag("--json", args->is_json, "Print JSON instead of text");
    rows.flag("--csv", args->is_csv, "Methods as methods.csv has them");
    rows.flag("--markdown", args->is_markdown,
              "Columns as the data dictionary of a run folder (experiments/columns.md)");
    // clang-format on
    command->footer(
        "Example: inkbench list params\n"
        "Exit codes: 0 done, 2 bad input.");
    command->callback([args] { fmt::print("{}", list_text(*args)); });
}

}  // namespace ink::cli
