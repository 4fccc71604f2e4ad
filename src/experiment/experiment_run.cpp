#include "experiment/experiment_run.h"

#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <map>
#include <numeric>
#include <utility>

#include "core/disturbance.h"
#include "core/error.h"
#include "core/interrupt.h"
#include "core/parallel.h"
#include "core/parse_number.h"
#include "core/whole_file.h"
#include "experiment/block_store.h"
#include "experiment/run_data.h"
#include "summary/summary_csv.h"

namespace ink::experiment {
namespace {

/// "8 s", "4 min", "1.5 h".
std::string duration_text(double seconds) {
    if (seconds < 90) return fmt::format("{:.0f} s", std::max(1.0, seconds));
    if (seconds < 90 * 60) return fmt::format("{:.0f} min", seconds / 60);
    return fmt::format("{:.1f} h", seconds / 3600);
}

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

/// After so long it is worth saying how fast this machine is.
constexpr double kFirstWord_s = 10;

double seconds_since(Clock::time_point begin) {
    return std::chrono::duration<double>(Clock::now() - begin).count();
}

/// How many groups may run at a time: each drawing has cores of its own. One on many threads needs
/// those of all others while it is timed.
int most_lanes(const Plan& plan) {
    if (plan.times && plan.timed_threads > 1) return 1;
    return std::max(1, core::hardware_threads() / std::max(1, plan.timed_threads));
}

/// What every run folder may hold: removed before another run takes the folder.
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

BlockWork::BlockWork(const Plan& plan, const BlockStore& store, std::vector<std::size_t> wanted)
    : plan_(plan), store_(store), wanted_(std::move(wanted)), lanes_(most_lanes(plan)) {
    for (const std::size_t i : wanted_) {
        const auto kept = store_.read(i);
        if (!kept) {
            missing_.push_back(i);
            continue;
        }
        note(i, kept->seconds);
    }
}

std::string BlockWork::heading(const Shard& shard) const {
    const auto cells_in = [&](const std::vector<std::size_t>& blocks) {
        return std::accumulate(blocks.begin(), blocks.end(), 0, [&](int sum, std::size_t i) {
            return sum + plan_.blocks[i].cells;
        });
    };
    const int cells = cells_in(wanted_);
    std::string text = fmt::format("{}: {} cells in {} blocks", plan_.name, cells, wanted_.size());
    if (!shard.is_all()) {
        text += fmt::format(" (shard {}/{} of {} cells)", shard.i, shard.n, plan_.cells());
    }
    if (missing_.size() < wanted_.size())
        text += fmt::format(", {} cells done", cells - cells_in(missing_));
    if (!missing_.empty()) text += ", " + estimate();
    return text;
}

/// "about 3 min ...", and what it goes by.
std::string BlockWork::estimate() const {
    const double left = work_of(missing_);
    if (known_work_ <= 0) {
        constexpr double kFolder_s = 1;  // models are read, tables and page written
        return fmt::format("about {} by the size of scenes and images, on two idle cores",
                           duration_text(left + kFolder_s));
    }
    return fmt::format("about {} by the {} finished blocks",
                       duration_text(left * known_s_ / known_work_),
                       wanted_.size() - missing_.size());
}

double BlockWork::work_of(const std::vector<std::size_t>& blocks) const {
    return std::accumulate(blocks.begin(), blocks.end(), 0.0, [&](double sum, std::size_t i) {
        return sum + plan_.blocks[i].work;
    });
}

/// The longest first, so that lanes end at about the same time.
std::vector<BlockWork::Group> BlockWork::missing_groups() const {
    std::map<std::size_t, Group> by_number;
    for (const std::size_t i : missing_)
        if (const auto& group = plan_.blocks[i].group) by_number[*group].blocks.push_back(i);
    std::vector<Group> groups;
    for (auto& [number, blocks] : by_number)
        groups.push_back(std::move(blocks));
    std::stable_sort(groups.begin(), groups.end(), [&](const Group& a, const Group& b) {
        return work_of(a.blocks) > work_of(b.blocks);
    });
    return groups;
}

/// One lane where others would be noticed by what is timed.
void BlockWork::try_neighbours() {
    if (lanes_ == 1) return;
    if (!plan_.times || core::measure_disturbance(lanes_ - 1) <= core::kNoDisturbance) return;
    lanes_ = 1;
    lanes_text_ = ", one scene at a time: others would spoil the times on this machine";
}

bool BlockWork::run(int lanes, const std::function<void(const std::string&)>& say) {
    core::Progress progress(plan_.name, static_cast<int>(wanted_.size()));
    progress_ = &progress;
    say_ = &say;
    has_said_ = known_work_ > 0;
    start_ = Clock::now();
    std::vector<Group> groups = missing_groups();
    std::size_t shared = 0;
    for (const Group& group : groups)
        shared += group.blocks.size();
    lanes_ = lanes > 0 ? std::min(lanes, lanes_) : lanes_;
    lanes_ = std::clamp(lanes_, 1, std::max(1, static_cast<int>(shared)));
    is_stopped_ = false;
    try_neighbours();
    core::run_lanes(lanes_, [&] { work_through(groups); });
    const std::vector<std::size_t> alone = missing_;
    for (const std::size_t i : alone)
        if (is_stopped_ || !compute(i)) return false;
    return missing_.empty();
}

/// The group whose next block a lane takes: its own, one that nobody has begun, or the one of which
/// most blocks are left; null if all are taken.
BlockWork::Group* BlockWork::next_group(std::vector<Group>& groups, Group* mine) const {
    if (mine != nullptr && !mine->is_taken()) return mine;
    const auto fresh = std::find_if(
        groups.begin(), groups.end(), [](const Group& group) { return group.taken == 0; });
    if (fresh != groups.end()) return &*fresh;
    const auto left = [](const Group& group) { return group.blocks.size() - group.taken; };
    const auto most =
        std::max_element(groups.begin(), groups.end(), [&](const Group& a, const Group& b) {
            return left(a) < left(b);
        });
    return most == groups.end() || most->is_taken() ? nullptr : &*most;
}

/// Takes one block after the other, until all are taken or an end was asked for.
void BlockWork::work_through(std::vector<Group>& groups) {
    for (Group* mine = nullptr;;) {
        std::size_t block = 0;
        {
            const std::lock_guard lock(mutex_);
            mine = next_group(groups, mine);
            if (is_stopped_ || mine == nullptr) return;
            block = mine->blocks[mine->taken++];
        }
        bool goes_on = false;
        try {
            goes_on = compute(block);
        } catch (...) {
            const std::lock_guard lock(mutex_);
            is_stopped_ = true;
            throw;
        }
        const std::lock_guard lock(mutex_);
        if (!goes_on) is_stopped_ = true;
        if (++mine->done == mine->blocks.size() && plan_.release)
            plan_.release(*plan_.blocks[block].group);
    }
}

/// Computes and keeps a block; false if an end was asked for.
bool BlockWork::compute(std::size_t i) {
    const Block& block = plan_.blocks[i];
    {
        const std::lock_guard lock(mutex_);
        if (is_stopped_ || core::is_interrupted()) return false;
        progress_->report(static_cast<int>(wanted_.size() - missing_.size()), block.key);
    }
    const auto begin = Clock::now();
    const BlockResult result = block.run();
    if (block.may_be_cut && core::is_interrupted()) return false;
    const double seconds = seconds_since(begin);
    store_.write(i, {block.key, seconds, result.faults}, result);
    const std::lock_guard lock(mutex_);
    std::erase(missing_, i);
    note(i, seconds);
    if (!has_said_ && seconds_since(start_) > kFirstWord_s && !missing_.empty()) {
        has_said_ = true;
        (*say_)(fmt::format("still {}", estimate()));
    }
    return true;
}

std::vector<std::string> BlockWork::missing_of_plan() const {
    std::vector<std::string> missing;
    const std::vector<std::size_t> there = store_.indices();
    for (std::size_t i = 0; i < plan_.blocks.size(); ++i) {
        if (!std::binary_search(there.begin(), there.end(), i))
            missing.push_back(plan_.blocks[i].key);
    }
    return missing;
}

/// A block of a group takes its part of the lanes' time only.
void BlockWork::note(std::size_t i, double seconds) {
    known_work_ += plan_.blocks[i].work;
    known_s_ += seconds / (plan_.blocks[i].group ? lanes_ : 1);
}

}  // namespace ink::experiment
