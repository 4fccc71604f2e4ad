#include <fmt/format.h>

#include <optional>

#include "core/error.h"
#include "experiment/block_store.h"
#include "experiment/experiment_run.h"
#include "experiment/experiment_tables.h"
#include "experiment/folder_lock.h"

namespace ink::experiment {
namespace {

namespace fs = std::filesystem;

/// The shards as they come together.
class Gathering {
  public:
    /// Adds the blocks of a folder. Throws core::Error if they do not belong to the others.
    void add(const fs::path& folder) {
        const BlockStore store(folder);
        const PlanRecord record = shard_record(store);
        if (!plan_) {
            plan_ = record;
            first_ = folder;
            found_.resize(record.keys.size());
            from_.resize(record.keys.size());
        }
        if (record.identity != plan_->identity) refuse_foreign(folder, record);
        for (const std::size_t i : store.indices()) {
            if (i >= plan_->keys.size()) continue;
            auto block = store.read(i, plan_->keys[i]);
            if (!block) continue;
            if (found_[i]) {
                throw core::Error(
                    folder.string(),
                    fmt::format("block '{}' is in {} too", plan_->keys[i], from_[i].string()),
                    "every shard once");
            }
            found_[i] = std::move(block);
            from_[i] = folder;
        }
    }

    /// All blocks in plan order. Throws core::Error (where = `out`) if there are not all.
    [[nodiscard]] std::vector<KeptBlock> take(const fs::path& out) {
        std::vector<KeptBlock> blocks;
        std::vector<std::string> missing;
        for (std::size_t i = 0; i < found_.size(); ++i) {
            if (found_[i]) {
                blocks.push_back(std::move(*found_[i]));
            } else {
                missing.push_back(plan_->keys[i]);
            }
        }
        if (missing.empty()) return blocks;
        throw core::Error(out.string(),
                          fmt::format("{} of {} blocks are missing, the first is '{}'",
                                      missing.size(),
                                      found_.size(),
                                      missing.front()),
                          "all shards, each run to its end");
    }

    [[nodiscard]] const PlanRecord& plan() const { return *plan_; }

  private:
    static PlanRecord shard_record(const BlockStore& store) {
        const auto record = store.read_plan();
        if (record && !record->is_finished) return *record;
        throw core::Error(
            store.folder().string(),
            record ? "it holds a whole run that is finished" : "there is no shard in it",
            "folders of inkbench run --shard i/n");
    }

    [[noreturn]] void refuse_foreign(const fs::path& folder, const PlanRecord& record) const {
        throw core::Error(
            folder.string(),
            fmt::format("its plan is not that of {}: '{}' by build {}, against '{}' by build {}",
                        first_.string(),
                        record.name,
                        record.build,
                        plan_->name,
                        plan_->build),
            "shards of one experiment with the same settings, made by one build");
    }

    std::optional<PlanRecord> plan_;
    fs::path first_;
    std::vector<std::optional<KeptBlock>> found_;
    std::vector<fs::path> from_;
};

}  // namespace

RunOutcome merge_shards(const std::vector<fs::path>& folders, const fs::path& out) {
    if (folders.empty()) {
        throw core::Error("merge", "there are no folders to merge", "one folder of a shard each");
    }
    Gathering gathering;
    for (const fs::path& folder : folders)
        gathering.add(folder);
    const std::vector<KeptBlock> blocks = gathering.take(out);
    const BlockStore store(out);
    store.make_folder();
    const FolderLock lock(out, false);
    if (const auto there = store.read_plan()) refuse_other_plan(store, *there, gathering.plan());
    return finish_run(store, gathering.plan(), blocks);
}

}  // namespace ink::experiment
