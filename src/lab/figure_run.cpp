#include "lab/figure_run.h"

#include <fmt/format.h>

#include <algorithm>
#include <fstream>
#include <map>
#include <set>
#include <sstream>

#include "core/error.h"
#include "lab/csv_table.h"
#include "lab/row_reader.h"
#include "lab/summary.h"
#include "scene/catalogue.h"

namespace ink::lab {
namespace {

constexpr const char* kRunFolder = "the --out folder of a finished inkbench compare or run";

std::string text_of(const std::filesystem::path& path) {
    std::ifstream file(path, std::ios::binary);
    std::ostringstream text;
    text << file.rdbuf();
    if (!file) throw core::Error(path.string(), "it cannot be read", kRunFolder);
    return text.str();
}

/// Several rows of one method on one view would be drawn as if they were one method.
void refuse_settings(const std::vector<Row>& rows, const std::filesystem::path& path) {
    std::map<std::pair<std::string, Place>, std::string> params_of;
    for (const Row& row : rows) {
        const auto [known, is_new] =
            params_of.emplace(std::pair(row.method, place_of(row)), row.params);
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

std::vector<Row> read_run(const std::filesystem::path& folder) {
    if (!std::filesystem::is_directory(folder))
        throw core::Error(folder.string(), "there is no such folder", kRunFolder);
    const std::filesystem::path path = folder / "rows.csv";
    if (!std::filesystem::is_regular_file(path)) {
        const bool is_part = std::filesystem::exists(path.string() + ".part");
        throw core::Error(
            folder.string(),
            is_part ? "its run is not finished: it has rows.csv.part alone" : "it has no rows.csv",
            kRunFolder);
    }
    std::vector<Row> rows = read_rows(split_csv(text_of(path), path.string()), path.string());
    if (rows.empty()) throw core::Error(path.string(), "it has no rows", kRunFolder);
    refuse_settings(rows, path);
    return rows;
}

std::vector<std::string> drawable_scenes(const std::vector<Row>& rows, std::size_t most) {
    std::set<std::string> built_in;
    for (const scene::CatalogueEntry& entry : scene::catalogue())
        built_in.insert(entry.name);
    std::vector<std::string> scenes;
    for (const Row& row : rows) {
        const bool is_known = std::find(scenes.begin(), scenes.end(), row.scene) != scenes.end();
        if (!is_known && built_in.count(row.scene) != 0) scenes.push_back(row.scene);
    }
    const std::size_t count = std::min(most, scenes.size());
    std::vector<std::string> chosen;
    for (std::size_t i = 0; i < count; ++i)
        chosen.push_back(scenes[i * scenes.size() / count]);
    return chosen;
}

std::vector<Entrant> entrants_of(const std::vector<Row>& rows) {
    std::vector<Entrant> entrants;
    for (const Row& row : rows) {
        const bool is_known = std::any_of(entrants.begin(), entrants.end(), [&](const Entrant& e) {
            return e.info->name == row.method;
        });
        if (is_known || is_bracket(row.method)) continue;
        Entrant entrant{&methods::find_method(row.method), values_of(row.params)};
        static_cast<void>(
            entrant.info->complete(entrant.settings));  // throws for what it knows not
        entrants.push_back(std::move(entrant));
    }
    return entrants;
}

}  // namespace ink::lab
