#include "experiment/experiment_run.h"

#include <fmt/format.h>

#include <algorithm>
#include <chrono>

#include "core/error.h"
#include "core/interrupt.h"
#include "core/parse_number.h"
#include "core/whole_file.h"
#include "experiment/block_store.h"
#include "experiment/block_work.h"
#include "experiment/run_data.h"
#include "summary/summary_csv.h"

namespace ink::experiment {
namespace {

namespace fs = std::filesystem;
using Clock = std::chrono::steady_clock;

constexpr int kMostShards = 100'000;

/// A folder that holds results, but none that this program could tell apart.
bool holds_unknown_results(const fs::path& folder) {
    for (const char* name : {"rows.csv", "report.html", "plan.toml"})
        if (fs::exists(folder / name)) return true;
    return false;
}

bool is_complete(const RunRecord& record, const fs::path& folder) {
    return record.state != RunState::unfinished &&
           std::all_of(record.tables.begin(), record.tables.end(), [&](const RecordedTable& table) {
               return fs::is_regular_file(folder / table.name);
           });
}

/// Of a finished run that is asked by another rule for the answer: writes what depends on it.
RunRecord answered_anew(RunRecord record, const RunRecord& mine, const fs::path& folder) {
    const RunTables tables = read_run(folder).tables;
    if (fs::exists(folder / "summary.csv")) {
        summary::Comparison comparison = summary::compare_methods(tables.rows, mine.answer);
        summary::add_curves(tables.curves, comparison.summaries);
        core::write_whole_file(folder / "summary.csv",
                               summary::summary_csv(tables.rows, comparison));
    }
    record.asked = mine.asked;
    record.answer = mine.answer;
    record.command = mine.command;
    write_record(record, folder);
    return record;
}

}  // namespace

Shard parse_shard(const std::string& text) {
    Shard shard;
    const std::size_t slash = std::min(text.find('/'), text.size());
    shard.i = core::parse_number<int>(text.substr(0, slash)).value_or(0);
    shard.n = core::parse_number<int>(text.substr(std::min(slash + 1, text.size()))).value_or(0);
    if (shard.i < 1 || shard.i > shard.n || shard.n > kMostShards) {
        throw core::Error(
            "--shard", fmt::format("'{}' is no shard", text), "i/n with 1 <= i <= n, such as 2/4");
    }
    return shard;
}

void clear_run_folder(const fs::path& folder) {
    std::error_code ignored;
    for (const char* name : {"blocks", "images", "figures"})
        fs::remove_all(folder / name, ignored);
    for (const char* name : {"report.html", "stress.html", "verdict.md", "run.toml", "plan.toml"})
        fs::remove(folder / name, ignored);
    std::vector<fs::path> tables;
    for (const auto& entry : fs::directory_iterator(folder, ignored))
        if (entry.path().extension() == ".csv") tables.push_back(entry.path());
    for (const fs::path& table : tables)
        fs::remove(table, ignored);
}

void take_folder(const fs::path& out, const RunRecord& mine, bool is_forced) {
    if (is_forced) {
        clear_run_folder(out);
        return;
    }
    if (const auto there = read_record(out)) {
        refuse_other_run(out, *there, mine);
    } else if (holds_unknown_results(out)) {
        throw core::Error(out.string(),
                          "it holds results without a run.toml",
                          "another --out, or --force to throw them away");
    }
}

RunOutcome write_run(const BlockStore& store,
                     RunRecord record,
                     const std::vector<std::string>& missing) {
    record.missing_blocks = missing;
    record.blocks_done = 0;
    record.work_s = 0;
    record.faults.clear();
    for (const auto& [name, text] : finished_tables(record, store))
        core::write_whole_file(store.folder() / name, text);
    for (const std::size_t i : store.indices()) {
        const auto block = store.read(i);
        if (!block) continue;
        store.release_images(i);
        ++record.blocks_done;
        record.work_s += block->seconds;
        record.faults.insert(record.faults.end(), block->faults.begin(), block->faults.end());
    }
    const bool is_whole = record.blocks_done == record.blocks;
    record.state = !is_whole               ? RunState::unfinished
                   : record.faults.empty() ? RunState::finished
                                           : RunState::invalid;
    write_record(record, store.folder());
    if (is_whole) store.clear();
    return {false, std::move(record)};
}

/// What a run that has begun leaves of itself, and a shard: its finished blocks, and how many they
/// are.
RunOutcome write_shard(const BlockStore& store,
                       RunRecord record,
                       const std::vector<std::string>& missing) {
    record.missing_blocks = missing;
    record.blocks_done = record.blocks - static_cast<int>(missing.size());
    write_record(record, store.folder());
    return {false, std::move(record)};
}

RunOutcome run_experiment(const Plan& plan, const RunOptions& options) {
    const auto start = Clock::now();
    const BlockStore store(options.out);
    std::error_code ignored;
    fs::create_directories(options.out, ignored);
    const FolderLock lock(options.out, !options.shard.is_all());
    RunRecord mine = record_of(plan);
    take_folder(options.out, mine, options.is_forced);
    if (options.shard.is_all()) store.remove_leftovers();
    const auto there = read_record(options.out);
    if (there && is_complete(*there, options.out)) {
        store.clear();
        options.say(fmt::format("{}: all {} cells are done", plan.name, plan.cells()));
        return {false,
                there->answer == mine.answer ? *there : answered_anew(*there, mine, options.out)};
    }
    store.make_folder();
    BlockWork work(plan, store, shard_blocks(plan, options.shard.i, options.shard.n));
    (void)write_shard(store, mine, work.missing_of_plan());
    for (const auto& [name, text] : plan.files)
        core::write_whole_file(options.out / name, text);
    options.say(work.heading(options.shard));
    const auto write_up = [&] {
        const auto write = options.shard.is_all() ? write_run : write_shard;
        return write(store, mine, work.missing_of_plan());
    };
    const core::InterruptGuard guard({}, [&] {
        (void)write_up();
        options.cut_off();
    });
    const bool is_done = work.run(options.lanes, options.say);
    RunOutcome outcome;
    core::write_unless_cut_off([&] { outcome = write_up(); });
    outcome.is_interrupted = !is_done;
    if (is_done) {
        const double elapsed_s = std::chrono::duration<double>(Clock::now() - start).count();
        options.say(fmt::format("done in {}{}", duration_text(elapsed_s), work.lanes_text()));
    }
    return outcome;
}

}  // namespace ink::experiment
