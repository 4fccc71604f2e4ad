#include "cli/run_status.h"

#include <fmt/format.h>

#include <cstdio>
#include <map>
#include <optional>
#include <set>
#include <system_error>

#include "experiment/block_store.h"
#include "experiment/run_record.h"

namespace ink::cli {
namespace {

namespace fs = std::filesystem;

/// "3-of-16" as 3 and 16.
std::optional<std::pair<int, int>> share_of(const std::string& name) {
    int i = 0;
    int n = 0;
    int used = 0;
    if (std::sscanf(name.c_str(), "%d-of-%d%n", &i, &n, &used) != 2) return std::nullopt;
    if (used != static_cast<int>(name.size()) || i < 1 || i > n) return std::nullopt;
    return std::pair(i, n);
}

/// The shares beside a run, in the order of their numbers.
std::map<std::pair<int, int>, fs::path> shares_beside(const fs::path& out) {
    std::map<std::pair<int, int>, fs::path> shares;
    std::error_code failure;
    for (const auto& entry : fs::directory_iterator(out.string() + ".parts", failure)) {
        const auto share = share_of(entry.path().filename().string());
        if (share) shares.emplace(*share, entry.path());
    }
    return shares;
}

/// What a folder has done of a plan.
struct Progress {
    std::set<std::size_t> done;
    bool is_finished = false;
    std::string problem = {};  ///< why its blocks do not count, or ""
};

Progress progress_of(const experiment::Plan& plan, const fs::path& folder) {
    Progress progress;
    const auto record = experiment::read_record(folder);
    if (!record) return progress;
    if (record->identity != plan.identity) {
        progress.problem =
            fmt::format("holds another run ('{}' by build {})", record->name, record->build);
        return progress;
    }
    progress.is_finished = record->state != experiment::RunState::unfinished;
    for (const std::size_t block : experiment::BlockStore(folder).indices())
        progress.done.insert(block);
    return progress;
}

}  // namespace

std::string run_status(const experiment::Plan& plan, const fs::path& out) {
    const std::size_t all = plan.blocks.size();
    const Progress whole = progress_of(plan, out);
    if (whole.is_finished)
        return fmt::format("{}: finished, {} blocks in {}\n", plan.name, all, out.string());
    std::set<std::size_t> done = whole.done;
    std::string lines;
    if (!whole.problem.empty()) lines += fmt::format("  {} {}\n", out.string(), whole.problem);
    for (const auto& [share, folder] : shares_beside(out)) {
        const Progress part = progress_of(plan, folder);
        const std::size_t asked = experiment::shard_blocks(plan, share.first, share.second).size();
        done.insert(part.done.begin(), part.done.end());
        lines += fmt::format("  {}: {}\n",
                             folder.string(),
                             part.problem.empty()
                                 ? fmt::format("{} of {} blocks", part.done.size(), asked)
                                 : part.problem);
    }
    return fmt::format("{}: {} of {} blocks are done\n", plan.name, done.size(), all) + lines;
}

}  // namespace ink::cli
