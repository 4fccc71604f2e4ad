#include "report/figure_run.h"

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <set>
#include <sstream>

#include "catalogue/catalogue.h"
#include "core/error.h"
#include "experiment/run_data.h"
#include "experiment/summary/summary.h"

namespace ink::report {
namespace {

constexpr const char* kRunFolder = "the --out folder of a finished inkbench compare or run";

/// Several rows of one method on one view would be drawn as if they were one method.
void refuse_settings(const std::vector<harness::Row>& rows, const std::filesystem::path& path) {
    std::map<std::pair<std::string, harness::Place>, std::string> params_of;
    for (const harness::Row& row : rows) {
        const auto [known, is_new] =
            params_of.emplace(std::pair(row.method, harness::place_of(row)), row.params);
        if (is_new) continue;
        throw core::Error(
            path.string(),
            fmt::format("{} has more than one row on {} {}", row.method, row.scene, row.view),
            "a run of one setting a method");
    }
}

/// "key=value;key=value" as values.
core::ParamValues values_of(const std::string& params) {
    core::ParamValues values;
    std::istringstream stream(params);
    for (std::string part; std::getline(stream, part, ';');) {
        const auto equals = part.find('=');
        if (equals != std::string::npos) values[part.substr(0, equals)] = part.substr(equals + 1);
    }
    return values;
}

}  // namespace

std::vector<harness::Row> rows_to_draw(const std::filesystem::path& folder) {
    if (!std::filesystem::is_directory(folder))
        throw core::Error(folder.string(), "there is no such folder", kRunFolder);
    experiment::RunData run = experiment::read_run(folder);
    if (run.record.state == experiment::RunState::unfinished)
        throw core::Error(folder.string(), "its run is not finished", kRunFolder);
    if (run.tables.rows.empty())
        throw core::Error((folder / "rows.csv").string(), "it has no rows", kRunFolder);
    refuse_settings(run.tables.rows, folder / "rows.csv");
    return std::move(run.tables.rows);
}

std::vector<std::string> drawable_scenes(const std::vector<harness::Row>& rows, std::size_t most) {
    std::set<std::string> built_in;
    for (const catalogue::CatalogueEntry& entry : catalogue::catalogue())
        built_in.insert(entry.name);
    std::vector<std::string> scenes;
    for (const harness::Row& row : rows) {
        const bool is_known = std::find(scenes.begin(), scenes.end(), row.scene) != scenes.end();
        if (!is_known && built_in.count(row.scene) != 0) scenes.push_back(row.scene);
    }
    const std::size_t count = std::min(most, scenes.size());
    std::vector<std::string> chosen;
    for (std::size_t i = 0; i < count; ++i)
        chosen.push_back(scenes[i * scenes.size() / count]);
    return chosen;
}

std::vector<harness::MethodConfig> configs_of(const std::vector<harness::Row>& rows) {
    std::vector<harness::MethodConfig> configs;
    for (const harness::Row& row : rows) {
        const bool is_known =
            std::any_of(configs.begin(), configs.end(), [&](const harness::MethodConfig& e) {
                return e.info->name == row.method;
            });
        if (is_known || harness::is_baseline(row.method)) continue;
        harness::MethodConfig config{&methods::find_method(row.method), values_of(row.params)};
        static_cast<void>(config.info->complete(config.settings));  // throws for what it knows not
        configs.push_back(std::move(config));
    }
    return configs;
}

}  // namespace ink::report
