#include <fmt/format.h>

#include <algorithm>
#include <set>

#include "core/error.h"
#include "core/toml_reader.h"
#include "core/whole_file.h"
#include "experiment/experiment.h"
#include "experiment/options/option_table.h"
#include "methods/method_configs.h"

namespace ink::experiment {
namespace {

/// The texts of a key, of the type that the option has, each with its line.
std::vector<core::GivenText> given_texts(core::TomlReader& table,
                                         const std::string& key,
                                         const core::Param& param) {
    std::vector<core::GivenText> given;
    if (param.kind == core::ParamKind::list) {
        const auto texts = table.texts(key);
        for (const core::TomlText& text : *texts)
            given.push_back({text.text, table.where_line(text.line)});
    } else {
        given.push_back({table.scalar(key, param), table.where(key)});
    }
    return given;
}

/// Reads the options of a table, "" for the top of the file, in the order of the option table.
/// `others` are keys that are read elsewhere.
void read_options(core::TomlReader& table,
                  const std::string& name,
                  const std::vector<std::string>& others,
                  Experiment& experiment) {
    const OptionTable& all = option_table();
    std::vector<std::string> known = others;
    for (std::size_t row = 0; row < all.options.size(); ++row) {
        const core::Param& param = all.param(row);
        const auto [of, key] = place_of(param);
        if (of != name || !all.has_kind(row, experiment.kind)) continue;
        known.push_back(key);
        if (table.has(key))
            all.rows.set(experiment, row, given_texts(table, key, param), param.name);
    }
    table.refuse_unknown(known);
}

std::string one_text(core::TomlReader& reader, const std::string& key) {
    const auto texts = reader.texts(key);
    if (texts->size() == 1) return texts->front().text;
    throw core::Error(reader.where(key),
                      fmt::format("{} has {} values", key, texts->size()),
                      "one value; several belong into [sweep.METHOD]");
}

std::string all_methods(const Experiment& experiment) {
    return fmt::format("{}", fmt::join(experiment.methods, ","));
}

void read_settings(core::TomlReader& settings, Experiment& experiment) {
    const auto add =
        [&](core::TomlReader& table, const std::string& prefix, const std::string& key) {
            const std::string text = prefix + key + "=" + one_text(table, key);
            at_place(table.where(key),
                     [&] { (void)methods::make_configs(all_methods(experiment), {text}); });
            experiment.settings.push_back(text);
        };
    for (const std::string& key : settings.keys()) {
        if (!settings.is_table(key)) {
            add(settings, "", key);
            continue;
        }
        auto of_method = settings.table(key);
        for (const std::string& own : of_method->keys())
            add(*of_method, key + ".", own);
    }
}

SettingGrid read_setting_grid(core::TomlReader& table, const std::string& method) {
    SettingGrid grid{method, {}};
    for (const std::string& key : table.keys()) {
        std::vector<std::string> values;
        const auto texts = table.texts(key);
        for (const core::TomlText& value : *texts) {
            at_place(table.where_line(value.line), [&] {
                (void)methods::make_configs(method, {method + "." + key + "=" + value.text});
            });
            values.push_back(value.text);
        }
        grid.axes.emplace_back(key, std::move(values));
    }
    return grid;
}

/// The grids of methods; the table's own keys are options.
void read_sweep(core::TomlReader& sweep, Experiment& experiment) {
    if (experiment.kind != ExperimentKind::compare) {
        throw core::Error(sweep.where(), "this kind of experiment has no sweep", "kind = compare");
    }
    for (const std::string& key : sweep.keys()) {
        const auto& names = experiment.methods;
        if (std::find(names.begin(), names.end(), key) == names.end()) continue;
        auto table = sweep.table(key);
        experiment.grids.push_back(read_setting_grid(*table, key));
    }
    read_options(sweep, "sweep", experiment.methods, experiment);
}

ExperimentKind read_kind(core::TomlReader& file) {
    const std::string kind = file.text("kind").value_or("");
    using enum ExperimentKind;
    for (const ExperimentKind each : {compare, stress, animation, hardest})
        if (name(each) == kind) return each;
    throw core::Error(file.where("kind"),
                      kind.empty() ? "there is no kind" : fmt::format("kind cannot be {}", kind),
                      "compare | stress | animation | hardest");
}

std::string read_name(core::TomlReader& file) {
    const std::string name = file.text("name").value_or("");
    const bool is_good = !name.empty() && std::all_of(name.begin(), name.end(), [](char c) {
        return std::isalnum(static_cast<unsigned char>(c)) != 0 || c == '_' || c == '-';
    });
    if (!is_good) {
        throw core::Error(
            file.where("name"),
            name.empty() ? "there is no name" : fmt::format("name cannot be '{}'", name),
            "letters, digits, _ and -: it names a folder");
    }
    return name;
}

}  // namespace

Experiment parse_experiment(const std::string& text, const std::filesystem::path& file) {
    core::TomlReader reader(text, file);
    Experiment experiment;
    experiment.where = file.string();
    experiment.name = read_name(reader);
    experiment.kind = read_kind(reader);
    if (experiment.kind == ExperimentKind::compare) experiment.scenes = scenes_called("catalogue");
    if (experiment.kind == ExperimentKind::hardest) experiment.times = false;
    experiment.sizes = {{640, 360}};
    const std::vector<std::string> tables = {
        "name", "kind", "grid", "measure", "answer", "study", "search", "settings", "sweep"};
    read_options(reader, "", tables, experiment);
    for (const char* name : {"grid", "measure", "answer", "study", "search"}) {
        core::TomlReader table = reader.table_or_empty(name);
        read_options(table, name, {}, experiment);
    }
    if (experiment.kind == ExperimentKind::hardest) add_searched_methods(experiment);
    if (experiment.methods.empty())
        option_table().rows.set(
            experiment, option_table().row("grid.methods"), {{"all", file.string()}}, "");
    core::TomlReader settings = reader.table_or_empty("settings");
    read_settings(settings, experiment);
    if (auto sweep = reader.table("sweep")) read_sweep(*sweep, experiment);
    return experiment;
}

Experiment read_experiment(const std::filesystem::path& file) {
    const auto text = core::read_whole_file(file);
    if (!text) throw core::Error(file.string(), "it cannot be read", "an experiment's TOML file");
    return parse_experiment(*text, file);
}

}  // namespace ink::experiment
