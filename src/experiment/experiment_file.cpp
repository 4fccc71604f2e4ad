#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <optional>
#include <sstream>

#include "core/error.h"
#include "core/named.h"
#include "core/split_list.h"
#include "core/toml_document.h"
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
/// `others` are keys that are read elsewhere. A list that run.toml has without values was not
/// asked for.
void read_options(core::TomlReader& table,
                  const std::string& name,
                  const std::vector<std::string>& others,
                  bool is_record,
                  Experiment& experiment) {
    const OptionTable& all = option_table();
    std::vector<std::string> known = others;
    for (std::size_t row = 0; row < all.options.size(); ++row) {
        const core::Param& param = all.param(row);
        const auto [of, key] = place_of(param);
        if (of != name || !all.has_kind(row, experiment.kind)) continue;
        known.push_back(key);
        if (table.has(key) && !(is_record && table.is_empty(key)))
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

/// Adds "key=value" that was given at a place.
void add_setting(const core::GivenText& setting, Experiment& experiment) {
    at_place(setting.where, [&] {
        (void)methods::make_configs(
            all_methods(experiment), {setting.text}, experiment.compare.presets);
    });
    experiment.settings.push_back(setting.text);
}

/// A table, of values or of tables of methods; or a list, as run.toml has it.
void read_settings(core::TomlReader& file, Experiment& experiment) {
    if (!file.has("settings")) return;
    if (!file.is_table("settings")) {
        const auto texts = file.texts("settings");
        for (const core::TomlText& text : *texts)
            add_setting({text.text, file.where_line(text.line)}, experiment);
        return;
    }
    const auto add =
        [&](core::TomlReader& table, const std::string& prefix, const std::string& key) {
            add_setting({prefix + key + "=" + one_text(table, key), table.where(key)}, experiment);
        };
    auto settings = file.table("settings");
    for (const std::string& key : settings->keys()) {
        if (!settings->is_table(key)) {
            add(*settings, "", key);
            continue;
        }
        auto of_method = settings->table(key);
        for (const std::string& own : of_method->keys())
            add(*of_method, key + ".", own);
    }
}

SettingGrid read_setting_grid(core::TomlReader& table,
                              const std::string& method,
                              const std::vector<std::string>& keys) {
    SettingGrid grid{method, {}};
    for (const std::string& key : keys) {
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

/// The grids as run.toml has them: `order` is that of the parameters, of which a table has none.
void read_recorded_grids(core::TomlReader& sweep, std::vector<SettingGrid>& grids) {
    for (core::TomlReader& grid : sweep.tables("grids")) {
        core::TomlReader parameters = grid.table_or_empty("parameters");
        std::vector<std::string> keys;
        if (const auto order = grid.texts("order"))
            for (const core::TomlText& key : *order)
                keys.push_back(key.text);
        grids.push_back(read_setting_grid(
            parameters, grid.needed_text("method", "method, order, parameters"), keys));
    }
}

/// The grids of methods; the table's own keys are options.
void read_sweep(core::TomlReader& sweep, bool is_record, Experiment& experiment) {
    if (experiment.kind != ExperimentKind::compare) {
        throw core::Error(sweep.where(), "this kind of experiment has no sweep", "kind = compare");
    }
    std::vector<SettingGrid>& grids = experiment.compare.grids;
    if (is_record) {
        read_recorded_grids(sweep, grids);
        return read_options(sweep, "sweep", {"grids"}, is_record, experiment);
    }
    for (const std::string& key : sweep.keys()) {
        const auto& names = experiment.methods;
        if (std::find(names.begin(), names.end(), key) == names.end()) continue;
        auto table = sweep.table(key);
        grids.push_back(read_setting_grid(*table, key, table->keys()));
    }
    read_options(sweep, "sweep", experiment.methods, is_record, experiment);
}

ExperimentKind read_kind(core::TomlReader& file) {
    const std::string kind = file.text("kind").value_or("");
    using enum ExperimentKind;
    for (const ExperimentKind each : {compare, stress, animation})
        if (name(each) == kind) return each;
    throw core::Error(file.where("kind"),
                      kind.empty() ? "there is no kind" : fmt::format("kind cannot be {}", kind),
                      "compare | stress | animation");
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

/// Three numbers of a table; nothing if the key is not there.
std::optional<glm::dvec3> read_point(const core::TomlReader& table, const std::string& key) {
    if (!table.has(key)) return std::nullopt;
    const std::vector<double> numbers = table.numbers(key);
    const auto is_finite = [](double number) { return std::isfinite(number); };
    if (numbers.size() == 3 && std::ranges::all_of(numbers, is_finite))
        return glm::dvec3(numbers[0], numbers[1], numbers[2]);
    throw core::Error(table.where(key), fmt::format("{} is no point", key), "[X, Y, Z]");
}

std::optional<double> read_number(const core::TomlReader& table, const std::string& key) {
    if (!table.has(key)) return std::nullopt;
    const std::vector<double> numbers = table.numbers(key);
    if (numbers.size() == 1) return numbers.front();
    throw core::Error(table.where(key), fmt::format("{} is no number", key), "a number");
}

harness::CameraRequest read_camera(const core::TomlReader& table) {
    table.refuse_unknown({"eye", "target", "up", "fov_deg", "parallel_height"});
    harness::CameraRequest camera;
    const auto eye_world = read_point(table, "eye");
    if (!eye_world) throw core::Error(table.where(), "a camera has no eye", "eye = [X, Y, Z]");
    camera.eye_world = *eye_world;
    camera.target_world = read_point(table, "target");
    if (const auto up_world = read_point(table, "up"))
        camera.up_world = checked_direction(*up_world, {"up", table.where("up")});
    if (const auto fov_deg = read_number(table, "fov_deg"))
        camera.fov_deg =
            at_place(table.where("fov_deg"), [&] { return harness::checked_fov_deg(*fov_deg); });
    if (const auto height_world = read_number(table, "parallel_height"))
        camera.height_world = at_place(table.where("parallel_height"),
                                       [&] { return harness::checked_height(*height_world); });
    return camera;
}

/// Cameras, and the options of views, of kinds that have these.
void read_views(core::TomlReader& views, bool is_record, Experiment& experiment) {
    const OptionTable& all = option_table();
    std::vector<std::string> others;
    if (all.has_kind(all.row("views.fit"), experiment.kind)) {
        others = {"cameras"};
        for (const core::TomlReader& camera : views.tables("cameras"))
            experiment.view_request.cameras.push_back(read_camera(camera));
    }
    read_options(views, "views", others, is_record, experiment);
    at_place(views.where(), [&] { settle_views(experiment.view_request); });
}

toml::array point(const glm::dvec3& p) {
    return toml::array{p.x, p.y, p.z};
}

toml::array cameras_of(const harness::ViewRequest& request) {
    toml::array cameras;
    for (const harness::CameraRequest& camera : request.cameras) {
        toml::table table{{"eye", point(camera.eye_world)},
                          {"up", point(camera.up_world)},
                          {"fov_deg", camera.fov_deg}};
        if (camera.target_world) table.insert("target", point(*camera.target_world));
        if (camera.height_world) table.insert("parallel_height", *camera.height_world);
        cameras.push_back(std::move(table));
    }
    return cameras;
}

toml::table methods_of(const Experiment& experiment) {
    toml::table methods;
    for (const method::MethodConfig& config : configs_of(experiment)) {
        toml::table parameters;
        for (const auto& [name, value] : config.info->complete(config.settings))
            parameters.insert(name, value);
        methods.insert(config.info->name, std::move(parameters));
    }
    return methods;
}

toml::array grids_of(const Experiment& experiment) {
    toml::array grids;
    for (const SettingGrid& grid : experiment.compare.grids) {
        toml::table axes;
        toml::array order;  // of which a table keeps nothing
        for (const auto& [key, values] : grid.axes) {
            axes.insert(key, core::array_of(values));
            order.push_back(key);
        }
        grids.push_back(toml::table{
            {"method", grid.method}, {"parameters", std::move(axes)}, {"order", std::move(order)}});
    }
    return grids;
}

/// Adds the value of an option; one that is out of its range, such as no limit, is not asked for,
/// and of views only what is asked for.
void add_option(const Experiment& experiment, std::size_t row, toml::table& asked) {
    const core::Param& param = option_table().param(row);
    const std::vector<std::string> texts = option_table().texts(experiment, row);
    const auto [of, key] = place_of(param);
    toml::table* table =
        of.empty() ? &asked : asked.emplace<toml::table>(of).first->second.as_table();
    if (of == "views" && texts == option_table().texts(Experiment{}, row)) return;
    if (param.kind == core::ParamKind::list) {
        table->insert(key, core::array_of(texts));
        return;
    }
    if (texts.empty()) return;
    switch (param.kind) {
        case core::ParamKind::integer:
            table->insert(key, static_cast<std::int64_t>(std::stod(texts.front())));
            break;
        case core::ParamKind::real:
            table->insert(key, std::stod(texts.front()));
            break;
        case core::ParamKind::flag:
            table->insert(key, texts.front() == "true");
            break;
        default:
            table->insert(key, texts.front());
    }
}

}  // namespace

Experiment parse_experiment(const std::string& text, const std::filesystem::path& file) {
    core::TomlReader whole(text, file);
    Experiment experiment;
    experiment.where = file.string();
    experiment.name = read_name(whole);
    experiment.kind = read_kind(whole);
    if (experiment.kind == ExperimentKind::compare) experiment.scenes = scenes_called("catalogue");
    experiment.sizes = {{640, 360}};
    const bool is_record = whole.is_table("asked");
    core::TomlReader reader = is_record ? *whole.table("asked") : whole;
    // Of methods run.toml has every parameter, those that were set in `settings` too.
    const std::string others = "kind, settings, sweep, views, grid, measure, answer, study, ";
    read_options(reader,
                 "",
                 core::split_list(others + (is_record ? "methods" : "name")),
                 is_record,
                 experiment);
    for (const char* name : {"grid", "measure", "answer", "study"}) {
        core::TomlReader table = reader.table_or_empty(name);
        read_options(table, name, {}, is_record, experiment);
    }
    core::TomlReader views = reader.table_or_empty("views");
    read_views(views, is_record, experiment);
    if (experiment.methods.empty() && !is_record)
        option_table().rows.set(
            experiment, option_table().row("grid.methods"), {{"all", file.string()}}, "");
    if (!is_record) cover_named_ink(experiment);
    read_settings(reader, experiment);
    if (auto sweep = reader.table("sweep")) read_sweep(*sweep, is_record, experiment);
    return experiment;
}

Experiment read_experiment(const std::filesystem::path& file) {
    const auto text = core::read_whole_file(file);
    if (!text) throw core::Error(file.string(), "it cannot be read", "an experiment's TOML file");
    return parse_experiment(*text, file);
}

std::string asked_text(const Experiment& experiment) {
    toml::table asked;
    for (std::size_t row = 0; row < option_table().options.size(); ++row)
        if (option_table().has_kind(row, experiment.kind)) add_option(experiment, row, asked);
    toml::table& views = *asked.emplace<toml::table>("views").first->second.as_table();
    if (!experiment.view_request.cameras.empty())
        views.insert("cameras", cameras_of(experiment.view_request));
    if (!experiment.settings.empty()) asked.insert("settings", core::array_of(experiment.settings));
    asked.insert("methods", methods_of(experiment));
    if (experiment.kind == ExperimentKind::compare)
        asked["sweep"].as_table()->insert("grids", grids_of(experiment));
    std::ostringstream text;
    text << asked;
    return text.str();
}

}  // namespace ink::experiment
