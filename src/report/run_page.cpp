#include "report/run_page.h"

#include <fmt/format.h>

#include <algorithm>
#include <nlohmann/json.hpp>

#include "bake/bake.h"
#include "core/escape.h"
#include "core/parallel.h"
#include "core/provenance.h"
#include "core/toml_document.h"
#include "core/vocabulary.h"
#include "core/whole_file.h"
#include "experiment/dictionary.h"
#include "experiment/diff/run_diff.h"
#include "experiment/experiment.h"
#include "report/live_page.h"
#include "report/packed_run.h"
#include "report/page_template.h"
#include "report/text/verdict.h"
#include "summary/summary_csv.h"

namespace ink::report {
namespace {

namespace fs = std::filesystem;

// The catalogue's page stays under 12 MB; tables and scripts take the rest.
constexpr std::size_t kImageBudget_bytes = 7'000'000;

using Json = nlohmann::ordered_json;

/// What came of a run that compares nothing, as a heading and what stands below it; null of others.
Json finding_json(const studies::Finding& finding) {
    if (finding.first.empty()) return nullptr;
    return {{"first", finding.first}, {"rest", finding.rest}};
}

Json home_json(const TakeHome& home) {
    return {{"method", home.method}, {"address", home.address}, {"commands", home.commands}};
}

/// What the page says of a comparison, word for word as verdict.md; null of another run.
Json words_json(const experiment::RunData& run, const fs::path& page_folder) {
    if (run.comparison.summaries.empty()) return nullptr;
    const VerdictWords words =
        verdict_words(experiment::rows_of_one_place(run.tables.rows), run.comparison);
    return {{"first", words.answer.first},
            {"rest", words.answer.rest},
            {"extent", words.extent},
            {"paper", words.paper},
            {"interval", words.interval},
            {"warnings", words.warnings},
            {"home", home_json(take_home(run, page_folder))}};
}

/// How run `b` differs from run `a`, by method.
Json diff_json(const experiment::RunData& a, const experiment::RunData& b) {
    const experiment::RunDiff diff =
        experiment::diff_runs(a, b, a.tables.rows.empty() ? 0 : a.tables.rows.front().seed);
    const auto range = [](const experiment::FDiff& f) -> Json {
        if (!f.range) return nullptr;
        return {{"low", f.range->low}, {"high", f.range->high}};
    };
    Json methods = Json::object();
    for (const experiment::MethodDiff& method : diff.methods) {
        methods[method.method] = {
            {"f_2px", range(method.f)},
            {"soft_f", range(method.soft_f)},
            {"time_ratio", method.time_ratio ? Json(*method.time_ratio) : Json()}};
    }
    return methods;
}

/// What each run differs from each other one by: diffs[first][second].
Json diffs_json(const std::vector<experiment::RunData>& runs) {
    Json diffs = Json::array();
    if (runs.size() < 2) return diffs;
    std::vector<experiment::RunData> kept(runs.size());
    for (std::size_t i = 0; i < runs.size(); ++i) {
        kept[i].record = runs[i].record;
        kept[i].tables.rows = experiment::rows_of_one_place(runs[i].tables.rows);
    }
    for (const experiment::RunData& a : kept) {
        Json& of_first = diffs.emplace_back(Json::array());
        for (const experiment::RunData& b : kept)
            of_first.push_back(&a == &b ? Json::object() : diff_json(a, b));
    }
    return diffs;
}

Json record_json(const experiment::RunData& run) {
    const experiment::RunRecord& record = run.record;
    return {{"name", record.name},
            {"kind", record.kind},
            {"command", record.command},
            {"identity", record.identity},
            {"build", record.build},
            {"asked", record.asked},
            {"times", record.times},
            {"measure", summary::name(run.comparison.measure())},
            {"f_margin", record.answer.f_margin},
            {"budget_ms", record.answer.budget_ms},
            {"state", experiment::name(record.state)},
            {"blocks", record.blocks},
            {"blocks_done", record.blocks_done},
            {"cells", record.cells},
            {"work_s", record.work_s},
            {"missing_blocks", record.missing_blocks},
            {"faults", record.faults}};
}

/// Addresses of the live pages of a run's scenes, seen from a folder.
Json live_json(const experiment::RunData& run, const fs::path& page_folder) {
    Json pages = Json::object();
    for (const harness::Row& row : run.tables.rows) {
        const fs::path page = run.folder / live_page_path(row.scene);
        if (!pages.contains(row.scene) && fs::exists(page))
            pages[row.scene] = fs::relative(page, page_folder).generic_string();
    }
    return pages;
}

/// summary.csv and its like of a run of several sizes or numbers of threads, which has none:
/// those of the first.
experiment::CsvTables missing_summaries(const experiment::RunData& run) {
    if (run.comparison.summaries.empty() || run.csv.contains("summary.csv")) return {};
    return experiment::split_tables(
        summary::comparison_tables(experiment::rows_of_one_place(run.tables.rows), run.comparison),
        run.folder);
}

Json tables_json(const experiment::RunData& run) {
    const experiment::CsvTables summed = missing_summaries(run);
    std::vector<std::pair<std::string, const core::CsvTable*>> given;
    for (const experiment::CsvTables* of : {&run.csv, &summed})
        for (const auto& [name, table] : *of)
            given.emplace_back(name, &table);
    std::vector<Json> packed(given.size());
    core::parallel_for(packed.size(), core::hardware_threads(), [&](std::size_t i) {
        packed[i] = packed_table(*given[i].second);
    });
    Json tables = Json::object();
    for (std::size_t i = 0; i < given.size(); ++i)
        tables[given[i].first] = std::move(packed[i]);
    return tables;
}

Json run_json(const experiment::RunData& run,
              const std::string& label,
              const fs::path& page_folder) {
    return {{"label", label},
            {"record", record_json(run)},
            {"words", words_json(run, page_folder)},
            {"finding", finding_json(run.finding)},
            {"live", live_json(run, page_folder)},
            {"tables", tables_json(run)}};
}

/// Unit and meaning of every column of the tables that the runs have.
Json column_docs(const std::vector<experiment::RunData>& runs) {
    Json tables = Json::object();
    for (const core::TableInfo& table : experiment::dictionary()) {
        const bool is_there =
            std::ranges::any_of(runs, [&](auto& run) { return run.csv.contains(table.file); });
        if (!is_there) continue;
        Json& columns = tables[table.file] = Json::object();
        for (const core::Column& column : table.columns)
            columns[column.name] = {{"unit", column.unit}, {"doc", column.doc}};
    }
    return tables;
}

/// What each run is called: the end of its folder's path that tells it from the others.
std::vector<std::string> labels_of(const std::vector<experiment::RunData>& runs) {
    std::vector<fs::path> whole;
    for (const experiment::RunData& run : runs) {
        const fs::path path = fs::absolute(run.folder).lexically_normal();
        whole.push_back(path.has_filename() ? path : path.parent_path());
    }
    std::vector<std::string> labels;
    for (const fs::path& path : whole) {
        fs::path label = path.filename();
        fs::path above = path.parent_path();
        const auto is_shared = [&] {
            int count = 0;
            for (const fs::path& other : whole) {
                const std::string end = (fs::path("/") / label).string();
                count += other.string().ends_with(end) ? 1 : 0;
            }
            return count > 1;
        };
        while (is_shared() && above.has_filename()) {
            label = above.filename() / label;
            above = above.parent_path();
        }
        labels.push_back(label.string());
    }
    return labels;
}

std::string title_of(const std::vector<std::string>& labels) {
    return fmt::format("Inkbench: {}", fmt::join(labels, ", "));
}

/// What the run draws first: a model file if it has one, else a scene; as it was asked for.
std::string first_model(const experiment::RunData& run) {
    const toml::table asked = core::parse_toml(run.record.asked, run.folder);
    const auto names = core::texts_of(asked["grid"]["scenes"]);
    const auto file = std::ranges::find_if(
        names, [](const std::string& name) { return fs::path(name).has_extension(); });
    if (file != names.end()) return *file;
    return names.empty() ? "MODEL" : experiment::scenes_called(names.front()).front();
}

/// What of a model file is baked for the method: its codes, else the edges.
std::string baked_for(const std::string& method) {
    for (const auto codes : {methods::BakedMethod::surface8, methods::BakedMethod::label8})
        if (method.starts_with(bake::name(codes))) return "--codes " + bake::name(codes);
    return "--edges";
}

}  // namespace

RunPage run_page(const std::vector<experiment::RunData>& runs, fs::path page_folder) {
    if (page_folder.empty()) page_folder = runs.front().folder;
    const std::vector<std::string> labels = labels_of(runs);
    Json data = {{"version", core::provenance().version},
                 {"vocabulary", Json::parse(core::vocabulary().json)},
                 {"columns", column_docs(runs)},
                 {"diffs", diffs_json(runs)},
                 {"runs", Json::array()}};
    for (std::size_t i = 0; i < runs.size(); ++i)
        data["runs"].push_back(run_json(runs[i], labels[i], page_folder));
    PackedImages images = packed_images(runs, page_folder, kImageBudget_bytes);
    std::string html = filled(page_files().index,
                              {{"title", core::escape(title_of(labels))},
                               {"style", std::string(page_files().style)},
                               {"d3", std::string(page_files().d3)},
                               {"scripts", std::string(page_files().scripts)},
                               {"data", page_json(data)},
                               {"images", images.json}});
    return {std::move(html), std::move(images.beside)};
}

void write_run_page(const std::vector<experiment::RunData>& runs, const fs::path& file) {
    const RunPage page = run_page(runs, fs::absolute(file).parent_path());
    for (const auto& [path, script] : page.beside)
        core::write_whole_file(path, script);
    core::write_whole_file(file, page.html);
}

TakeHome take_home(const experiment::RunData& run, const fs::path& page_folder) {
    const summary::MethodSummary* answer = run.comparison.answer().method;
    if (answer == nullptr) return {};
    TakeHome home;
    home.method = experiment::method_fact(run, answer->method, "summary");
    const std::string preset_of = experiment::method_fact(run, answer->method, "preset_of");
    const std::string name = preset_of.empty() ? answer->method : preset_of;
    const fs::path page = fs::path(INK_SOURCE_METHODS) / name / (name + ".md");
    if (fs::exists(page)) home.address = fs::relative(page, page_folder).generic_string();

    const std::string model = first_model(run);
    const fs::path file = fs::path(model).has_extension() ? model : "MODEL.glb";
    const std::string shown = core::shell_word(model);
    const std::string folder = core::shell_word(run.folder.string());
    home.commands = {{"live page", fmt::format("inkbench page {} --run {}", shown, folder)},
                     {"glTF file",
                      fmt::format("inkbench bake {} -o {} {}",
                                  core::shell_word(file.string()),
                                  core::shell_word(file.stem().string() + ".ink.glb"),
                                  baked_for(answer->method))},
                     {"advice", "inkbench advise " + shown},
                     {"figures", "inkbench figures " + folder}};
    return home;
}

}  // namespace ink::report
