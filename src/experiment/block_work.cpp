#include "experiment/block_work.h"

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <numeric>
#include <utility>

#include "core/disturbance.h"
#include "core/interrupt.h"
#include "core/parallel.h"

namespace ink::experiment {
namespace {

using Clock = std::chrono::steady_clock;

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

}  // namespace

std::string duration_text(double seconds) {
    if (seconds < 90) return fmt::format("{:.0f} s", std::max(1.0, seconds));
    if (seconds < 90 * 60) return fmt::format("{:.0f} min", seconds / 60);
    return fmt::format("{:.1f} h", seconds / 3600);
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
