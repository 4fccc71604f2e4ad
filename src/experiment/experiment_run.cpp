#include "experiment/experiment_run.h"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <chrono>
#include <numeric>
#include <regex>

#include "core/error.h"
#include "core/progress.h"
#include "experiment/block_store.h"
#include "experiment/experiment_tables.h"
#include "experiment/folder_lock.h"
#include "harness/interrupt.h"

namespace ink::experiment {
namespace {

namespace fs = std::filesystem;
using Clock = std::chrono::steady_clock;

constexpr int kMostShards = 100'000;

std::string duration_text(double seconds) {
    if (seconds < 90) return fmt::format("{:.0f} s", std::max(1.0, seconds));
    if (seconds < 90 * 60) return fmt::format("{:.0f} min", seconds / 60);
    return fmt::format("{:.1f} h", seconds / 3600);
}

/// Half-written files of a run that was killed.
void remove_leftovers(const fs::path& folder) {
    static const std::regex kLeftover(R"(.*\.[0-9a-f]{16}\.part)");
    std::error_code ignored;
    for (const fs::path& place : {folder, folder / "blocks"}) {
        for (const auto& entry : fs::directory_iterator(place, ignored)) {
            if (std::regex_match(entry.path().filename().string(), kLeftover))
                fs::remove(entry.path(), ignored);
        }
    }
}

/// The blocks of a run: which are wanted, which are there.
class Work {
  public:
    Work(const Plan& plan, const BlockStore& store, std::vector<std::size_t> wanted)
        : plan_(plan), store_(store), wanted_(std::move(wanted)) {
        for (const std::size_t i : wanted_) {
            const auto kept = store_.read(i, plan_.blocks[i].key);
            if (!kept) {
                missing_.push_back(i);
                continue;
            }
            note(i, kept->seconds);
        }
    }

    [[nodiscard]] std::string heading(const Shard& shard) const {
        const auto cells_in = [&](const std::vector<std::size_t>& blocks) {
            return std::accumulate(blocks.begin(), blocks.end(), 0, [&](int sum, std::size_t i) {
                return sum + plan_.blocks[i].cells;
            });
        };
        const int cells = cells_in(wanted_);
        std::string text =
            fmt::format("{}: {} cells in {} blocks", plan_.name, cells, wanted_.size());
        if (!shard.is_all()) {
            text += fmt::format(" (shard {}/{} of {} cells)", shard.i, shard.n, plan_.cells());
        }
        if (missing_.size() < wanted_.size())
            text += fmt::format(", {} cells done", cells - cells_in(missing_));
        if (!missing_.empty()) text += ", " + estimate();
        return text;
    }

    /// "about 3 min ...", and what it goes by.
    [[nodiscard]] std::string estimate() const {
        double left = 0;
        for (const std::size_t i : missing_)
            left += plan_.blocks[i].work;
        if (known_work_ <= 0) {
            return fmt::format("about {} by the size of scenes and pictures, on two idle cores",
                               duration_text(left));
        }
        return fmt::format("about {} by the {} finished blocks",
                           duration_text(left * known_s_ / known_work_),
                           wanted_.size() - missing_.size());
    }

    /// Computes what is missing; false if an end was asked for before all was there.
    bool run(const std::function<void(const std::string&)>& say) {
        core::Progress progress(plan_.name, static_cast<int>(wanted_.size()));
        bool has_said = known_work_ > 0;
        const auto start = Clock::now();
        while (!missing_.empty()) {
            if (harness::is_interrupted()) return false;
            const std::size_t i = missing_.front();
            const Block& block = plan_.blocks[i];
            progress.report(static_cast<int>(wanted_.size() - missing_.size()), block.key);
            const auto begin = Clock::now();
            KeptBlock kept{block.run(), 0};
            if (block.may_be_cut && harness::is_interrupted()) return false;
            kept.seconds = std::chrono::duration<double>(Clock::now() - begin).count();
            store_.write(i, block.key, kept);
            missing_.erase(missing_.begin());
            note(i, kept.seconds);
            const double elapsed_s = std::chrono::duration<double>(Clock::now() - start).count();
            if (!has_said && elapsed_s > kFirstWord_s && !missing_.empty()) {
                has_said = true;
                say(fmt::format("still {}", estimate()));
            }
        }
        return true;
    }

  private:
    /// After so long it is worth saying how fast this machine is.
    static constexpr double kFirstWord_s = 10;

    void note(std::size_t i, double seconds) {
        known_work_ += plan_.blocks[i].work;
        known_s_ += seconds;
    }

    const Plan& plan_;
    const BlockStore& store_;
    std::vector<std::size_t> wanted_;
    std::vector<std::size_t> missing_;
    double known_work_ = 0;
    double known_s_ = 0;
};

bool has_all_tables(const PlanRecord& record, const fs::path& folder) {
    return record.is_finished &&
           std::all_of(record.tables.begin(), record.tables.end(), [&](const PlannedTable& table) {
               return fs::is_regular_file(folder / table.name);
           });
}

std::vector<KeptBlock> read_all(const BlockStore& store, const PlanRecord& record) {
    std::vector<KeptBlock> blocks;
    for (std::size_t i = 0; i < record.keys.size(); ++i) {
        auto kept = store.read(i, record.keys[i]);
        if (!kept) {
            throw core::Error(store.folder().string(),
                              fmt::format("block '{}' is gone", record.keys[i]),
                              "a folder that nobody else writes to");
        }
        blocks.push_back(std::move(*kept));
    }
    return blocks;
}

}  // namespace

Shard parse_shard(const std::string& text) {
    Shard shard;
    const char* end = text.data() + text.size();
    const auto first = std::from_chars(text.data(), end, shard.i);
    bool is_good = first.ec == std::errc{} && first.ptr < end && *first.ptr == '/';
    if (is_good) {
        const auto second = std::from_chars(first.ptr + 1, end, shard.n);
        is_good = second.ec == std::errc{} && second.ptr == end && shard.n >= 1 &&
                  shard.n <= kMostShards && shard.i >= 1 && shard.i <= shard.n;
    }
    if (!is_good) {
        throw core::Error(
            "--shard", fmt::format("'{}' is no shard", text), "i/n with 1 <= i <= n, such as 2/4");
    }
    return shard;
}

RunOutcome run_experiment(const Plan& plan, const RunOptions& options) {
    const harness::InterruptGuard guard;
    const auto start = Clock::now();
    const BlockStore store(options.out);
    store.make_folder();
    const FolderLock lock(options.out, !options.shard.is_all());
    const PlanRecord mine = record_of(plan);
    if (options.shard.is_all()) remove_leftovers(options.out);
    if (options.is_fresh) {
        store.clear();
        store.make_folder();
    }
    const auto there = options.is_fresh ? std::nullopt : store.read_plan();
    if (there) refuse_other_plan(store, *there, mine);
    if (there && has_all_tables(*there, options.out)) {
        store.clear();
        options.say(fmt::format("{}: all {} cells are done", plan.name, plan.cells()));
        RunOutcome outcome;
        for (const PlannedTable& table : there->tables)
            outcome.tables.push_back(options.out / table.name);
        return outcome;
    }
    store.write_plan(mine);

    Work work(plan, store, shard_blocks(plan, options.shard.i, options.shard.n));
    options.say(work.heading(options.shard));
    RunOutcome outcome;
    if (!work.run(options.say)) {
        outcome.is_interrupted = true;
        return outcome;
    }
    if (options.shard.is_all()) outcome = finish_run(store, mine, read_all(store, mine));
    const double elapsed_s = std::chrono::duration<double>(Clock::now() - start).count();
    options.say(fmt::format("done after {}", duration_text(elapsed_s)));
    return outcome;
}

}  // namespace ink::experiment
