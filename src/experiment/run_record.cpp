#include "experiment/run_record.h"

#include <fmt/format.h>

#include <array>
#include <regex>
#include <sstream>

#include "core/error.h"
#include "core/provenance.h"
#include "core/toml_document.h"
#include "core/whole_file.h"
#include "experiment/diff/run_diff.h"

namespace ink::experiment {
namespace {

namespace fs = std::filesystem;

constexpr const char* kFile = "run.toml";

std::optional<RunState> state_called(const std::string& word) {
    for (const RunState state : {RunState::unfinished, RunState::finished, RunState::invalid})
        if (name(state) == word) return state;
    return std::nullopt;
}

toml::table built() {
    const core::Provenance& p = core::provenance();
    toml::table libraries;
    for (const auto& [name, version] : p.libraries)
        libraries.insert(name, version);
    return toml::table{{"version", p.version},
                       {"commit", p.commit},
                       {"changed", p.dirty},
                       {"compiler", p.compiler},
                       {"flags", p.flags},
                       {"libraries", std::move(libraries)}};
}

toml::table machine() {
    const core::Provenance& p = core::provenance();
    return toml::table{{"cpu", p.cpu}, {"simd", p.simd}};
}

toml::table progress_of(const RunRecord& record) {
    toml::table progress{{"state", name(record.state)},
                         {"blocks", record.blocks},
                         {"blocks_done", record.blocks_done},
                         {"cells", record.cells}};
    if (record.times) progress.insert("work_s", record.work_s);
    if (!record.missing_blocks.empty())
        progress.insert("missing", core::array_of(record.missing_blocks));
    if (!record.faults.empty()) progress.insert("faults", core::array_of(record.faults));
    return progress;
}

toml::array tables_of(const std::vector<ModelFacts>& models) {
    toml::array tables;
    for (const ModelFacts& model : models) {
        const glm::dvec3& o = model.origin;
        tables.push_back(toml::table{{"scene", model.scene},
                                     {"origin", toml::array{o.x, o.y, o.z}},
                                     {"not_heeded", core::array_of(model.notes)}});
    }
    return tables;
}

std::vector<ModelFacts> models_of(const toml::node_view<const toml::node>& node) {
    std::vector<ModelFacts> models;
    const toml::array* tables = node.as_array();
    for (std::size_t i = 0; tables != nullptr && i < tables->size(); ++i) {
        const auto table = node[i];
        ModelFacts model{
            table["scene"].value_or(std::string()), {}, core::texts_of(table["not_heeded"])};
        for (int axis = 0; axis < 3; ++axis)
            model.origin[axis] = table["origin"][static_cast<std::size_t>(axis)].value_or(0.0);
        models.push_back(std::move(model));
    }
    return models;
}

/// The first value that two runs were asked differently, "there a = 1, here a = 2"; "" if none is.
std::string first_difference(const std::string& there, const std::string& mine) {
    const std::vector<AskedChange> changes = asked_changes(there, mine);
    if (changes.empty()) return "";
    const auto& [key, of_there, of_mine] = changes.front();
    const auto shown = [&](const std::string& value) {
        if (value == "-") return std::string("nothing");
        static const std::regex kLineBreak("\n *");  // of a long list
        return fmt::format("{} = {}", key, std::regex_replace(value, kLineBreak, " "));
    };
    return fmt::format("there {}, here {}", shown(of_there), shown(of_mine));
}

}  // namespace

std::string_view name(RunState state) {
    constexpr std::array<std::string_view, 3> kNames = {"unfinished", "finished", "invalid"};
    return kNames.at(static_cast<std::size_t>(state));
}

RunRecord record_of(const Plan& plan) {
    RunRecord record{plan};
    record.blocks = static_cast<int>(plan.blocks.size());
    record.cells = plan.cells();
    return record;
}

std::optional<RunRecord> read_record(const fs::path& folder) {
    const fs::path file = folder / kFile;
    const auto text = core::read_whole_file(file);
    if (!text) return std::nullopt;
    const toml::table root = core::parse_toml(*text, file);
    RunRecord record;
    record.name = root["name"].value_or(std::string());
    record.kind = root["kind"].value_or(std::string());
    record.command = root["command"].value_or(std::string());
    record.identity = root["identity"].value_or(std::string());
    record.build = root["build"].value_or(std::string());
    const summary::AnswerRule usual;
    const auto answer = root["asked"]["answer"];
    record.answer = {answer["f_margin"].value_or(usual.f_margin),
                     answer["budget_ms"].value_or(usual.budget_ms)};
    record.times = root["times"].value_or(true);
    record.one_place = root["one_place"].value_or(true);
    const auto names = core::texts_of(root["tables"]["names"]);
    const auto headings = core::texts_of(root["tables"]["headings"]);
    record.models = models_of(toml::node_view<const toml::node>(root["models"]));
    const auto progress = root["progress"];
    const auto state = state_called(progress["state"].value_or(std::string()));
    record.blocks = progress["blocks"].value_or(0);
    record.blocks_done = progress["blocks_done"].value_or(0);
    record.cells = progress["cells"].value_or(0);
    record.work_s = progress["work_s"].value_or(0.0);
    record.missing_blocks = core::texts_of(progress["missing"]);
    record.faults = core::texts_of(progress["faults"]);
    record.finding = root["finding"].value_or(std::string());
    const toml::table* asked = root["asked"].as_table();
    if (record.identity.empty() || !state || asked == nullptr || names.size() != headings.size()) {
        throw core::Error(
            file.string(), "this is no record of a run", "an unchanged file of inkbench");
    }
    record.state = *state;
    for (std::size_t i = 0; i < names.size(); ++i)
        record.tables.push_back({names[i], headings[i]});
    std::ostringstream asked_text;
    asked_text << *asked;
    record.asked = asked_text.str();
    return record;
}

void write_record(const RunRecord& record, const fs::path& folder) {
    toml::array names;
    toml::array headings;
    for (const RecordedTable& table : record.tables) {
        names.push_back(table.name);
        headings.push_back(table.heading);
    }
    toml::table root{{"name", record.name},
                     {"kind", record.kind},
                     {"command", record.command},
                     {"identity", record.identity},
                     {"build", record.build},
                     {"times", record.times},
                     {"one_place", record.one_place},
                     {"progress", progress_of(record)},
                     {"built", built()},
                     {"machine", machine()},
                     {"tables", toml::table{{"names", names}, {"headings", headings}}},
                     {"asked", core::parse_toml(record.asked, folder / kFile)}};
    if (!record.models.empty()) root.insert("models", tables_of(record.models));
    if (!record.finding.empty()) root.insert("finding", record.finding);
    std::ostringstream text;
    text << "# What was asked of this run, and what answered. Written and read by inkbench.\n"
         << root << '\n';
    core::write_whole_file(folder / kFile, text.str());
}

void refuse_other_run(const fs::path& folder, const RunRecord& there, const RunRecord& mine) {
    if (there.identity == mine.identity) return;
    std::string what;
    if (there.build != mine.build) {
        what = fmt::format(
            "it holds a run of another build ({}; this is {})", there.build, mine.build);
    } else {
        std::string difference = first_difference(there.asked, mine.asked);
        if (difference.empty() && there.command != mine.command)
            difference = fmt::format("there {}, here {}", there.command, mine.command);
        if (difference.empty()) difference = "a model file has changed";
        what = fmt::format("it holds another run, '{}': {}", there.name, difference);
    }
    throw core::Error(folder.string(), what, "another --out, or --force to throw that run away");
}

}  // namespace ink::experiment
