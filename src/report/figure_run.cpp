#include "report/figure_run.h"

#include <fmt/format.h>

#include <algorithm>
#include <fstream>
#include <map>
#include <set>
#include <sstream>

#include "catalogue/catalogue.h"
#include "core/error.h"
#include "experiment/summary.h"
#include "harness/csv_table.h"
#include "harness/row_reader.h"

namespace ink::report {
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

std::vector<harness::Row> read_run(const std::filesystem::path& folder) {
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
    std::vector<harness::Row> rows =
        harness::read_rows(harness::split_csv(text_of(path), path.string()), path.string());
    if (rows.empty()) throw core::Error(path.string(), "it has no rows", kRunFolder);
    refuse_settings(rows, path);
    return rows;
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

std::vector<harness::Entrant> entrants_of(const std::vector<harness::Row>& rows) {
    std::vector<harness::Entrant> entrants;
    for (const harness::Row& row : rows) {
        const bool is_known =
            std::any_of(entrants.begin(), entrants.end(), [&](const harness::Entrant& e) {
                return e.info->name == row.method;
            });
        if (is_known || harness::is_bracket(row.method)) continue;
        harness::Entrant entrant{&methods::find_method(row.method), values_of(row.params)};
        static_cast<void>(
            entrant.info->complete(entrant.settings));  // throws for what it knows not
        entrants.push_back(std::move(entrant));
    }
    return entrants;
}

}  // namespace ink::report
