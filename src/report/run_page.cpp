#include "report/run_page.h"

#include <fmt/format.h>

#include <map>
#include <set>

#include "core/escape.h"
#include "core/parallel.h"
#include "core/provenance.h"
#include "core/vocabulary.h"
#include "core/whole_file.h"
#include "experiment/dictionary.h"
#include "experiment/diff/run_diff.h"
#include "report/live_page.h"
#include "report/packed_run.h"
#include "report/page_files.h"
#include "report/page_template.h"
#include "report/text/take_home.h"
#include "report/text/verdict.h"
#include "summary/comparison.h"

namespace ink::report {
namespace {

namespace fs = std::filesystem;

// The catalogue's page stays under 12 MB; tables and scripts take the rest.
constexpr std::size_t kImageBudget_bytes = 7'000'000;

std::string json_texts(const std::vector<std::string>& texts) {
    std::vector<std::string> quoted;
    for (const std::string& text : texts)
        quoted.push_back(json_text(text));
    return fmt::format("[{}]", fmt::join(quoted, ","));
}

/// Of the first size and number of threads.
std::vector<harness::Row> rows_shown(const experiment::RunData& run) {
    experiment::RunTables kept;
    kept.rows = run.tables.rows;
    experiment::keep_one_place(kept);
    return kept.rows;
}

/// What came of a run that compares nothing, as a heading and what stands below it; null of others.
std::string finding_json(const studies::Finding& finding) {
    if (finding.first.empty()) return "null";
    return fmt::format(
        R"({{"first":{},"rest":{}}})", json_text(finding.first), json_text(finding.rest));
}

std::string home_json(const TakeHome& home) {
    std::vector<std::string> commands;
    for (const NextCommand& command : home.commands)
        commands.push_back(json_texts({command.what, command.line}));
    return fmt::format(R"({{"method":{},"address":{},"commands":[{}]}})",
                       json_text(home.method),
                       json_text(home.address),
                       fmt::join(commands, ","));
}

/// What the page says of a comparison, word for word as verdict.md; null of another run.
std::string words_json(const experiment::RunData& run, const fs::path& page_folder) {
    if (run.comparison.summaries.empty()) return "null";
    const VerdictWords words = verdict_words(rows_shown(run), run.comparison);
    return fmt::format(
        R"({{"first":{},"rest":{},"extent":{},"paper":{},"interval":{},"warnings":{},"home":{}}})",
        json_text(words.answer.first),
        json_text(words.answer.rest),
        json_text(words.extent),
        json_text(words.paper),
        json_text(words.interval),
        json_texts(words.warnings),
        home_json(take_home(run, page_folder)));
}

/// How run `b` differs from run `a`, by method.
std::string diff_json(const experiment::RunData& a, const experiment::RunData& b) {
    std::vector<std::string> methods;
    const experiment::RunDiff diff =
        experiment::diff_runs(a, b, a.tables.rows.empty() ? 0 : a.tables.rows.front().seed);
    const auto number = [](const std::optional<double>& value) {
        return value ? fmt::format("{}", *value) : "null";
    };
    const auto range = [](const experiment::FDiff& f) {
        return f.range ? fmt::format(R"({{"low":{},"high":{}}})", f.range->low, f.range->high)
                       : "null";
    };
    for (const experiment::MethodDiff& method : diff.methods) {
        methods.push_back(fmt::format(R"({}:{{"f_2px":{},"soft_f":{},"time_ratio":{}}})",
                                      json_text(method.method),
                                      range(method.f),
                                      range(method.soft_f),
                                      number(method.time_ratio)));
    }
    return fmt::format("{{{}}}", fmt::join(methods, ","));
}

/// What each run differs from each other one by: diffs[first][second].
std::string diffs_json(const std::vector<experiment::RunData>& runs) {
    if (runs.size() < 2) return "[]";
    std::vector<experiment::RunData> kept(runs.size());
    for (std::size_t i = 0; i < runs.size(); ++i) {
        kept[i].record = runs[i].record;
        kept[i].tables.rows = rows_shown(runs[i]);
    }
    std::vector<std::string> lines;
    for (const experiment::RunData& a : kept) {
        std::vector<std::string> diffs;
        for (const experiment::RunData& b : kept)
            diffs.push_back(&a == &b ? "{}" : diff_json(a, b));
        lines.push_back(fmt::format("[{}]", fmt::join(diffs, ",")));
    }
    return fmt::format("[{}]", fmt::join(lines, ","));
}

std::string record_json(const experiment::RunData& run) {
    const experiment::RunRecord& record = run.record;
    return fmt::format(
        R"({{"name":{},"kind":{},"command":{},"identity":{},"build":{},"asked":{},"times":{},)"
        R"("measure":"{}","f_margin":{},"budget_ms":{},)"
        R"("state":{},"blocks":{},"blocks_done":{},"cells":{},"work_s":{},"missing_blocks":{},)"
        R"("faults":{}}})",
        json_text(record.name),
        json_text(record.kind),
        json_text(record.command),
        json_text(record.identity),
        json_text(record.build),
        json_text(record.asked),
        record.times,
        summary::name(run.comparison.measure()),
        record.answer.f_margin,
        record.answer.budget_ms,
        json_text(experiment::name(record.state)),
        record.blocks,
        record.blocks_done,
        record.cells,
        record.work_s,
        json_texts(record.missing_blocks),
        json_texts(record.faults));
}

/// Addresses of the live pages of a run's scenes, seen from a folder.
std::string live_json(const experiment::RunData& run, const fs::path& page_folder) {
    std::set<std::string> scenes;
    for (const harness::Row& row : run.tables.rows)
        scenes.insert(row.scene);
    std::vector<std::string> entries;
    for (const std::string& scene : scenes) {
        const fs::path page = run.folder / live_page_path(scene);
        if (!fs::exists(page)) continue;
        const std::string address = fs::relative(page, page_folder).generic_string();
        entries.push_back(json_text(scene) + ":" + json_text(address));
    }
    return fmt::format("{{{}}}", fmt::join(entries, ","));
}

/// summary.csv and its like of a run of several sizes or numbers of threads, which has none:
/// those of the first.
experiment::CsvTables missing_summaries(const experiment::RunData& run) {
    if (run.comparison.summaries.empty() || run.csv.contains("summary.csv")) return {};
    return experiment::split_tables(summary::comparison_tables(rows_shown(run), run.comparison),
                                    run.folder);
}

std::string run_json(const experiment::RunData& run,
                     const std::string& label,
                     const fs::path& page_folder) {
    std::vector<std::pair<std::string, const core::CsvTable*>> given;
    for (const auto& [name, table] : run.csv)
        given.emplace_back(name, &table);
    const experiment::CsvTables summed = missing_summaries(run);
    for (const auto& [name, table] : summed)
        given.emplace_back(name, &table);
    std::vector<std::string> tables(given.size());
    core::parallel_for(tables.size(), core::hardware_threads(), [&](std::size_t i) {
        const auto& [name, table] = given[i];
        tables[i] = json_text(name) + ":" + packed_table(*table);
    });
    return fmt::format(
        R"({{"label":{},"record":{},"words":{},"finding":{},"live":{},"tables":{{{}}}}})",
        json_text(label),
        record_json(run),
        words_json(run, page_folder),
        finding_json(run.finding),
        live_json(run, page_folder),
        fmt::join(tables, ","));
}

/// Unit and meaning of every column of the tables that the runs have.
std::string column_docs(const std::vector<experiment::RunData>& runs) {
    std::set<std::string> files;
    for (const experiment::RunData& run : runs)
        for (const auto& [name, table] : run.csv)
            files.insert(name);
    std::vector<std::string> tables;
    for (const core::TableInfo& table : experiment::dictionary()) {
        if (!files.contains(table.file)) continue;
        std::vector<std::string> columns;
        for (const core::Column& column : table.columns)
            columns.push_back(fmt::format(R"({}:{{"unit":{},"doc":{}}})",
                                          json_text(column.name),
                                          json_text(column.unit),
                                          json_text(column.doc)));
        tables.push_back(fmt::format("{}:{{{}}}", json_text(table.file), fmt::join(columns, ",")));
    }
    return fmt::format("{{{}}}", fmt::join(tables, ","));
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

}  // namespace

RunPage run_page(const std::vector<experiment::RunData>& runs, fs::path page_folder) {
    if (page_folder.empty()) page_folder = runs.front().folder;
    const std::vector<std::string> labels = labels_of(runs);
    std::vector<std::string> packed;
    for (std::size_t i = 0; i < runs.size(); ++i)
        packed.push_back(run_json(runs[i], labels[i], page_folder));
    PackedImages images = packed_images(runs, page_folder, kImageBudget_bytes);
    std::string html = filled(
        page_files().index,
        {{"title", core::escape(title_of(labels))},
         {"style", std::string(page_files().style)},
         {"d3", std::string(page_files().d3)},
         {"scripts", std::string(page_files().scripts)},
         {"data",
          fmt::format(R"({{"version":{},"vocabulary":{},"columns":{},"diffs":{},"runs":[{}]}})",
                      json_text(core::provenance().version),
                      core::vocabulary().json,
                      column_docs(runs),
                      diffs_json(runs),
                      fmt::join(packed, ","))},
         {"images", images.json}});
    return {std::move(html), std::move(images.beside)};
}

void write_run_page(const std::vector<experiment::RunData>& runs, const fs::path& file) {
    const RunPage page = run_page(runs, fs::absolute(file).parent_path());
    for (const auto& [path, script] : page.beside)
        core::write_whole_file(path, script);
    core::write_whole_file(file, page.html);
}

}  // namespace ink::report
