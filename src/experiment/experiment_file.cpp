#include <fmt/format.h>

#include <algorithm>
#include <set>

#include "catalogue/catalogue.h"
#include "core/error.h"
#include "core/whole_file.h"
#include "experiment/entrants/entrant.h"
#include "experiment/experiment.h"
#include "experiment/toml_reader.h"
#include "methods/registry.h"

namespace ink::experiment {
namespace {

constexpr std::int64_t kMostRepetitions = 10000;
constexpr std::int64_t kMostViews = 360;

/// Runs `read`; an error of it names the line of the file instead of an option.
template <class Read>
void at_line(const std::string& where, Read read) {
    try {
        read();
    } catch (const core::Error& error) {
        throw core::Error(where, error.what_happened(), error.accepted());
    }
}

void check_scene(const TomlReader& reader, const TomlText& scene) {
    std::vector<std::string> known = {"catalogue", "train", "heldout"};
    for (const catalogue::CatalogueEntry& entry : catalogue::catalogue())
        known.push_back(entry.name);
    if (std::find(known.begin(), known.end(), scene.text) != known.end()) return;
    std::error_code error;  // a name that is too long is no file either
    if (std::filesystem::is_regular_file(scene.text, error)) return;
    throw core::Error(reader.where_line(scene.line),
                      fmt::format("there is no scene, and no file, called '{}'", scene.text),
                      core::known_names(known, scene.text));
}

/// Adds names that are not there yet.
void add_new(const std::vector<std::string>& names, std::vector<std::string>& all) {
    for (const std::string& name : names) {
        if (std::find(all.begin(), all.end(), name) == all.end()) all.push_back(name);
    }
}

std::vector<std::string> methods_called(const std::string& name) {
    if (name != "all") return {methods::find_method(name).name};
    std::vector<std::string> names;
    for (const method::MethodInfo& info : methods::registry())
        names.push_back(info.name);
    return names;
}

void read_scenes(TomlReader& grid, Experiment& experiment) {
    const auto scenes = grid.texts("scenes");
    if (!scenes) return;
    experiment.scenes.clear();
    for (const TomlText& scene : *scenes) {
        check_scene(grid, scene);
        add_new(scenes_called(scene.text), experiment.scenes);
    }
}

void read_methods(TomlReader& grid, Experiment& experiment) {
    const std::vector<TomlText> all = {{"all", 0}};
    for (const TomlText& method : grid.texts("methods").value_or(all)) {
        at_line(grid.where_line(method.line),
                [&] { add_new(methods_called(method.text), experiment.methods); });
    }
}

/// "NAME=PATH" each; their paths are read as they stand.
void read_entrants(TomlReader& grid, Experiment& experiment) {
    const auto entrants = grid.texts("entrants");
    if (!entrants) return;
    for (const TomlText& entrant : *entrants) {
        at_line(grid.where_line(entrant.line), [&] { (void)parse_entrant(entrant.text); });
        experiment.entrants.push_back(entrant.text);
    }
}

void read_sizes(TomlReader& grid, Experiment& experiment) {
    const std::vector<TomlText> usual = {{"640x360", 0}};
    for (const TomlText& size : grid.texts("sizes").value_or(usual)) {
        experiment.sizes.push_back(parse_image_size(size.text, grid.where_line(size.line)));
    }
}

void read_threads(TomlReader& grid, Experiment& experiment) {
    const auto threads = grid.texts("threads");
    if (!threads) return;
    experiment.threads.clear();
    for (const TomlText& text : *threads) {
        const core::Param param{
            "threads", core::ParamKind::integer, 1, 256, 1, {}, "", "of a method"};
        const std::string where = grid.where_line(text.line);
        experiment.threads.push_back(static_cast<int>(core::parse_param(param, text.text, where)));
    }
}

void read_grid(TomlReader& grid, Experiment& experiment) {
    std::vector<std::string> known = {"methods", "sizes"};
    if (experiment.kind == ExperimentKind::compare) {
        known.emplace_back("entrants");
        read_entrants(grid, experiment);
    }
    if (experiment.kind != ExperimentKind::stress) {
        known.emplace_back("seams");
        if (const auto seams = grid.text("seams"))
            experiment.view_request.model.material_seams =
                harness::parse_seams(*seams, grid.where("seams"));
    }
    read_methods(grid, experiment);
    read_sizes(grid, experiment);
    if (experiment.kind != ExperimentKind::stress) {
        known.emplace_back("threads");  // of stress they are an axis
        read_threads(grid, experiment);
    } else if (experiment.sizes.size() > 1) {
        throw core::Error(grid.where("sizes"), "stress has several sizes", "one size");
    }
    switch (experiment.kind) {
        case ExperimentKind::compare:
            known.insert(known.end(), {"scenes", "views"});
            experiment.scenes = scenes_called("catalogue");
            read_scenes(grid, experiment);
            experiment.views = static_cast<int>(grid.whole("views", 1, kMostViews).value_or(0));
            break;
        case ExperimentKind::stress:
            known.insert(known.end(), {"axes", "points"});
            experiment.points = static_cast<int>(grid.whole("points", 2, 1000).value_or(0));
            for (const TomlText& axis : grid.texts("axes").value_or(std::vector<TomlText>{}))
                experiment.axes.push_back(axis.text);
            break;
        case ExperimentKind::animation:
            known.insert(known.end(), {"scenes", "frames", "roll"});
            read_scenes(grid, experiment);
            experiment.frames =
                static_cast<int>(grid.whole("frames", 2, 10000).value_or(experiment.frames));
            experiment.roll = grid.flag("roll").value_or(true);
            break;
        case ExperimentKind::bound:
            break;  // asked for on the command line alone
    }
    grid.refuse_unknown(known);
}

void read_measure(TomlReader& measure, Experiment& experiment) {
    std::vector<std::string> known = {"times", "crease_deg", "intersections"};
    experiment.times = measure.flag("times").value_or(true);
    experiment.crease_deg = measure.number("crease_deg", 0, 180).value_or(experiment.crease_deg);
    if (const auto intersections = measure.text("intersections")) {
        experiment.intersections =
            score::parse_intersections(*intersections, measure.where("intersections"));
    }
    if (experiment.kind != ExperimentKind::animation) {
        known.insert(known.end(), {"repetitions", "budget_ms"});
        experiment.repetitions = static_cast<int>(
            measure.whole("repetitions", 1, kMostRepetitions).value_or(experiment.repetitions));
        experiment.budget_s =
            measure.number("budget_ms", 0, 1e6).value_or(experiment.budget_s * 1e3) * 1e-3;
    }
    if (experiment.kind == ExperimentKind::compare) {
        known.insert(known.end(), {"full_scores", "crosscheck", "entrant_seconds"});
        experiment.entrant_s =
            measure.number("entrant_seconds", 0.01, 86400).value_or(experiment.entrant_s);
        experiment.full_scores = measure.flag("full_scores").value_or(true);
        experiment.crosscheck = measure.flag("crosscheck").value_or(true);
    }
    measure.refuse_unknown(known);
}

std::string one_text(TomlReader& reader, const std::string& key) {
    const auto texts = reader.texts(key);
    if (texts->size() == 1) return texts->front().text;
    throw core::Error(reader.where(key),
                      fmt::format("{} has {} values", key, texts->size()),
                      "one value; several belong into [sweep.METHOD]");
}

std::string all_methods(const Experiment& experiment) {
    return fmt::format("{}", fmt::join(experiment.methods, ","));
}

void read_settings(TomlReader& settings, Experiment& experiment) {
    const auto add = [&](TomlReader& table, const std::string& prefix, const std::string& key) {
        const std::string text = prefix + key + "=" + one_text(table, key);
        at_line(table.where(key),
                [&] { (void)harness::make_configs(all_methods(experiment), {text}); });
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

SettingGrid read_setting_grid(TomlReader& table, const std::string& method) {
    SettingGrid grid{method, {}};
    for (const std::string& key : table.keys()) {
        std::vector<std::string> values;
        const auto texts = table.texts(key);
        for (const TomlText& value : *texts) {
            at_line(table.where_line(value.line), [&] {
                (void)harness::make_configs(method, {method + "." + key + "=" + value.text});
            });
            values.push_back(value.text);
        }
        grid.axes.emplace_back(key, std::move(values));
    }
    return grid;
}

void read_sweep(TomlReader& sweep, Experiment& experiment) {
    if (experiment.kind != ExperimentKind::compare) {
        throw core::Error(sweep.where(), "this kind of experiment has no sweep", "kind = compare");
    }
    experiment.own_sweep_views =
        static_cast<int>(sweep.whole("own_views", 0, kMostViews).value_or(0));
    for (const std::string& key : sweep.keys()) {
        if (key == "own_views") continue;
        const auto& names = experiment.methods;
        if (std::find(names.begin(), names.end(), key) == names.end()) {
            std::vector<std::string> known = names;
            known.emplace_back("own_views");
            throw core::Error(sweep.where(key),
                              fmt::format("no method that takes part is called '{}'", key),
                              core::known_names(known, key));
        }
        auto table = sweep.table(key);
        experiment.grids.push_back(read_setting_grid(*table, key));
    }
}

ExperimentKind read_kind(TomlReader& file) {
    const std::string kind = file.text("kind").value_or("");
    if (kind == "compare") return ExperimentKind::compare;
    if (kind == "stress") return ExperimentKind::stress;
    if (kind == "animation") return ExperimentKind::animation;
    throw core::Error(file.where("kind"),
                      kind.empty() ? "there is no kind" : fmt::format("kind cannot be {}", kind),
                      "compare | stress | animation");
}

std::string read_name(TomlReader& file) {
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
    const toml::table root = parse_toml(text, file);
    TomlReader reader(root, file, "");
    reader.refuse_unknown({"name", "kind", "seed", "grid", "measure", "settings", "sweep"});
    Experiment experiment;
    experiment.where = file.string();
    experiment.name = read_name(reader);
    experiment.kind = read_kind(reader);
    experiment.seed = static_cast<std::uint64_t>(reader.whole("seed", 0, INT64_MAX).value_or(0));
    const toml::table none;
    const auto part = [&](const char* name) {
        return reader.table(name).value_or(TomlReader(none, file, name));
    };
    TomlReader grid = part("grid");
    read_grid(grid, experiment);
    TomlReader measure = part("measure");
    read_measure(measure, experiment);
    TomlReader settings = part("settings");
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
