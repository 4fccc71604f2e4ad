#include "cli/options/experiment_options.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "cli/name_list.h"
#include "cli/options/command_rows.h"
#include "experiment/options/option_table.h"

namespace ink::cli {
namespace {

/// As help has it; nothing for what has no value.
std::string usual_text(const experiment::Experiment& usual, std::size_t row) {
    const std::vector<std::string> texts = experiment::option_table().texts(usual, row);
    return texts.size() == 1 ? texts.front() : "";
}

std::string type_of(const core::Param& param) {
    if (param.kind != core::ParamKind::choice) return param.unit;
    return fmt::format("{}", fmt::join(param.choices, "|"));
}

}  // namespace

void ExperimentOptions::add_to(CLI::App& command,
                               const std::vector<std::string>& rows,
                               const std::string& doc) {
    const experiment::OptionTable& table = experiment::option_table();
    for (const std::string& name : rows) {
        const std::size_t row = table.row(name);
        const core::Param& param = table.param(row);
        const std::string& flag = table.options[row].flag;
        const std::string help = doc.empty() ? param.doc : doc;
        std::vector<std::string>& given = given_[row];
        if (param.kind == core::ParamKind::flag) {
            const std::string value = flag.starts_with("--no-") ? "false" : "true";
            command.add_flag_callback(
                flag, [&given, value] { given = {value}; }, help);
        } else if (param.kind == core::ParamKind::list && !table.options[row].is_once) {
            CommandRows(command).list(flag, given, type_of(param), help);
        } else {
            command.add_option(flag, given, help)
                ->type_name(type_of(param))
                ->expected(1)
                ->allow_extra_args(false)  // what follows is an argument of its own
                ->default_str(usual_text(usual_, row));
        }
    }
}

experiment::Experiment ExperimentOptions::read() const {
    const experiment::OptionTable& table = experiment::option_table();
    experiment::Experiment experiment = usual_;
    for (const auto& [row, texts] : given_) {
        if (texts.empty()) continue;
        const std::string where = flag_of(table.param(row).name);
        const std::string& noun = table.options[row].noun;
        const std::vector<std::string> named =
            noun.empty() ? texts : listed_names(texts, {where, noun, table.param(row).choices});
        std::vector<core::GivenText> given;
        for (const std::string& text : named)
            given.push_back({text, where});
        table.rows.set(experiment, row, given, "it");
    }
    experiment::settle_views(experiment.view_request);
    return experiment;
}

const std::vector<std::string>& ExperimentOptions::given(const std::string& row) const {
    static const std::vector<std::string> kNothing;
    const auto found = given_.find(experiment::option_table().row(row));
    return found == given_.end() ? kNothing : found->second;
}

std::string flag_of(const std::string& row) {
    const experiment::OptionTable& table = experiment::option_table();
    return called(table.options[table.row(row)].flag);
}

const std::vector<std::string>& truth_rows() {
    static const std::vector<std::string> rows = {
        "measure.crease_deg", "measure.weld_epsilon", "measure.intersections"};
    return rows;
}

}  // namespace ink::cli
