#include "experiment/dictionary.h"

#include <fmt/format.h>

#include "harness/rows/methods_table.h"
#include "harness/rows/row_table.h"
#include "harness/rows/side_tables.h"
#include "linear_code/cancellation.h"
#include "studies/axis_rows.h"
#include "studies/axis_summary.h"
#include "studies/motion_study.h"
#include "summary/cost_model.h"
#include "summary/paired_differences.h"
#include "summary/summary_csv.h"

namespace ink::experiment {
namespace {

core::TableInfo run_record() {
    return {
        "run.toml",
        "What was asked of the run, and which build and machine answered. Not a table: these are "
        "its keys.",
        {{"name", "", "of the run"},
         {"kind", "", "compare, stress, animation or tune"},
         {"command", "", "as typed, without the options that say where results go"},
         {"identity", "", "hash of all that rows depend on, the build included"},
         {"build", "", "version and commit of the program"},
         {"times", "", "false: fields of times are left empty"},
         {"one_place", "", "true: one size and one number of threads"},
         {"progress",
          "",
          "state (unfinished, finished, invalid), blocks and cells done, what is "
          "missing, why it is invalid"},
         {"finding", "", "what a search for better settings came to, in a line"},
         {"built", "", "version, commit, compiler, flags and libraries of the program"},
         {"machine", "", "cpu, and the instruction set that the kernels ran on"},
         {"tables", "", "the files of the run and their headings"},
         {"asked", "", "every option and, under methods, every parameter of every method"}}};
}

/// Its columns differ from run to run: one stands here for all swept parameters.
core::TableInfo sweep() {
    core::TableInfo table = harness::sweep_table({.parameters = {"PARAMETER"}, .has_ink = true});
    for (core::Column& column : table.columns) {
        if (column.name == "PARAMETER")
            column.doc =
                "one column per swept parameter, under its own name; empty if the method "
                "has none of that name";
    }
    return table;
}

}  // namespace

core::TableInfo evaluations_table(const std::vector<std::string>& searched) {
    core::TableInfo table{
        "evaluations.csv",
        "A line per evaluation of the tuner, in the order in which they were made.",
        {{"evaluation", "", "its number within the search; the random search counts from 1 again"},
         {"phase", "", "start, global, local or random"}}};
    for (const std::string& name : searched)
        table.columns.push_back(
            {name, "", "one column per searched parameter, under its own name"});
    table.columns.push_back({"e_train", "0..1", "what the search lowers, over training views"});
    table.columns.push_back(
        {"drawn_by", "", "method, or planes: drawn from planes made once per view"});
    table.columns.push_back({"draw_ms", "ms", "median, where there is a time budget", true});
    return table;
}

std::vector<core::TableInfo> dictionary() {
    return {run_record(),
            harness::methods_table(),
            harness::rows_table(),
            summary::summary_table(),
            summary::kinds_table(),
            summary::differences_table(),
            summary::soft_differences_table(),
            summary::unscored_table(),
            harness::curves_table(),
            harness::tolerances_table(),
            harness::bins_table(),
            sweep(),
            harness::cost_table(),
            summary::cost_fit_table(),
            summary::predictions_table(),
            linear_code::cancellation_table(),
            studies::axes_table(),
            studies::axis_summary_table(true),
            studies::faults_table(),
            studies::motion_table(),
            studies::ink_motion_table(),
            studies::lives_table(),
            evaluations_table({"PARAMETER"})};  // one stands here for all that are searched
}

std::string dictionary_markdown() {
    std::string text =
        "# The tables of a run folder\n\n"
        "Made by `inkbench list columns --markdown`; a test compares this page with the "
        "program.\n\n"
        "`rows.csv` has one line per cell and is complete in itself. Every other table names a "
        "cell of it by its number in `cell`. Files are CSV (RFC 4180, UTF-8, \"\\n\"). Numbers "
        "have the shortest form that reads back to the same value. A field is empty where nothing "
        "was measured. Two runs of one plan differ only in columns marked *time*.\n";
    for (const core::TableInfo& table : dictionary())
        text += fmt::format("\n{}", core::dictionary_section(table));
    return text;
}

std::string dictionary_text() {
    std::string text = "columns (of the files of a run folder; --markdown for a page)\n";
    for (const core::TableInfo& table : dictionary()) {
        text += fmt::format("  {}\n", table.file);
        for (const core::Column& column : table.columns) {
            text += fmt::format("    {:<22} {:<12} {}\n", column.name, column.unit, column.doc);
        }
    }
    return text;
}

}  // namespace ink::experiment
