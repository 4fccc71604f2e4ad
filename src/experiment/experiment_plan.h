#pragma once

#include <cstdint>
#include <functional>
#include <glm/vec3.hpp>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "core/tables/table.h"
#include "experiment/experiment.h"
#include "harness/truths/tracing.h"
#include "summary/answer.h"

namespace ink::experiment {

/// A table of a run folder.
struct RecordedTable {
    std::string name;     ///< "rows.csv"
    std::string heading;  ///< the columns, joined by commas

    friend bool operator==(const RecordedTable&, const RecordedTable&) = default;
};

/// What a block came to.
struct BlockResult {
    std::map<std::string, std::string> lines;  ///< by table, every line ended; none: no entry
    std::map<std::string, std::string> files;  ///< images: path inside the run folder, bytes
    std::vector<std::string> faults;           ///< why the whole run would be invalid
};

/// What a block takes of two lanes' time: they wait for each other now and then.
inline constexpr double kShareOfTwoLanes = 0.55;

/// What is computed together: the cells of one view, whose drawings take turns (A B C A B C), so
/// that a machine that slows down slows all alike. Blocks depend on nothing but the plan.
struct Block {
    std::string key;  ///< what it is, for people; no two of a plan are equal
    int cells = 0;    ///< images it will score, baselines and settings counted
    double work = 0;  ///< its part of a run of seconds on two cores of 2022, to weigh blocks by
    /// Ctrl-C may cut it short; it is then done again.
    bool may_be_cut = false;
    std::function<BlockResult()> run;
    /// Blocks of one group share what they make ready: they run one after the other, beside those
    /// of other groups. A block without a group has the machine to itself.
    std::optional<std::size_t> group = std::nullopt;
};

/// What a model file has beside what is drawn of it, for run.toml and the terminal.
struct ModelFacts {
    std::string scene;
    glm::dvec3 origin{0};            ///< Scene::origin
    std::vector<std::string> notes;  ///< what of the file does not count here

    friend bool operator==(const ModelFacts&, const ModelFacts&) = default;
};

/// Version and commit of this program, for messages.
[[nodiscard]] std::string build_text();

/// What was asked of a run, and which build answers.
struct RunHead {
    std::string name;
    std::string kind;      ///< "compare", "stress", "animation", "tune"
    std::string command;   ///< as the user typed it, less what says where results go; may be ""
    std::string identity;  ///< hash of all that rows depend on, the build included
    std::string build = build_text();
    std::string asked;                ///< a TOML document: every option, method and parameter
    summary::AnswerRule answer = {};  ///< as `asked` has it
    bool times = true;
    bool one_place = true;  ///< one size and one number of threads: summaries mean something
    std::vector<RecordedTable> tables;
    std::vector<ModelFacts> models;  ///< of which there is something to say

    void add_table(const core::TableInfo& table);
    /// Notes in `models` what there is to say of the scene.
    void add_model(const scene::Scene& scene);
};

/// An experiment taken apart: the order of blocks is the order of lines in every table.
struct Plan : RunHead {
    int timed_threads = 1;                     ///< the most that a timed drawing of a group uses
    std::map<std::string, std::string> files;  ///< known before any block: methods.csv, axes.csv
    std::vector<Block> blocks;
    /// Lets go what the blocks of a group shared, when the last of them has run.
    std::function<void(std::size_t group)> release = {};
    std::int64_t rows = 0;  ///< lines of rows.csv that the blocks so far will have

    [[nodiscard]] int cells() const;

    /// The first of `count` new numbers for the column `cell` of rows.csv.
    [[nodiscard]] std::int64_t take_cells(std::int64_t count);
};

/// How truths are traced: on all processors, as nothing of a truth is timed; `cache` is the folder
/// of traced truths, empty for none.
[[nodiscard]] harness::TraceOptions trace_of(const Experiment& experiment,
                                             const std::filesystem::path& cache);

/// Loads the scenes and lists the blocks; `cache` is the folder of traced truths, empty for none.
/// Throws core::Error for scenes that cannot be loaded, and where = what asks if nothing is left to
/// do.
[[nodiscard]] Plan make_plan(const Experiment& experiment, const std::filesystem::path& cache);

/// The indices of the blocks that shard `i` of `n` (1..n) computes: heaviest first, each goes to
/// the shard that has least to do, so that shards take about as long as each other. Every block
/// belongs to one shard, the same on every machine.
[[nodiscard]] std::vector<std::size_t> shard_blocks(const Plan& plan, int i, int n);

/// What a kind of experiment adds to its plan: tables and blocks.
void plan_compare(const Experiment& experiment, const harness::TraceOptions& trace, Plan& plan);
void plan_animation(const Experiment& experiment, const harness::TraceOptions& trace, Plan& plan);
void plan_stress(const Experiment& experiment, const harness::TraceOptions& trace, Plan& plan);

}  // namespace ink::experiment
