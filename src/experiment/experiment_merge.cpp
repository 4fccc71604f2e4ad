#include <fmt/format.h>

#include <map>
#include <optional>

#include "core/error.h"
#include "core/whole_file.h"
#include "experiment/block_store.h"
#include "experiment/experiment_run.h"

namespace ink::experiment {
namespace {

namespace fs = std::filesystem;

/// The shards as they come together.
class Gathering {
  public:
    /// Notes the blocks of a folder. Throws core::Error if they do not belong to the others.
    void add(const fs::path& folder) {
        const RunRecord record = shard_record(folder);
        if (!record_) {
            record_ = record;
            first_ = folder;
            missing_ = record.missing_blocks;
        }
        if (record.identity != record_->identity) refuse_foreign(folder, record);
        const BlockStore store(folder);
        for (const std::size_t i : store.indices()) {
            const auto block = store.read(i);
            if (!block || i >= static_cast<std::size_t>(record_->blocks)) continue;
            if (const auto other = from_.find(i); other != from_.end()) {
                throw core::Error(
                    folder.string(),
                    fmt::format("block '{}' is in {} too", block->key, other->second.string()),
                    "every shard once");
            }
            from_[i] = folder;
            std::erase(missing_, block->key);
        }
    }

    /// Throws core::Error (where = `out`) if there are not all blocks.
    void check_complete(const fs::path& out) const {
        const auto all = static_cast<std::size_t>(record_->blocks);
        if (from_.size() == all) return;
        throw core::Error(out.string(),
                          fmt::format("{} of {} blocks are missing, the first is '{}'",
                                      all - from_.size(),
                                      all,
                                      missing_.empty() ? "unknown" : missing_.front()),
                          "all shards, each run to its end");
    }

    /// Keys of the blocks that no folder has.
    [[nodiscard]] const std::vector<std::string>& missing() const { return missing_; }
    [[nodiscard]] const RunRecord& record() const { return *record_; }
    [[nodiscard]] const fs::path& first() const { return first_; }
    [[nodiscard]] const std::map<std::size_t, fs::path>& blocks() const { return from_; }

  private:
    static RunRecord shard_record(const fs::path& folder) {
        const auto record = read_record(folder);
        if (record && record->state == RunState::unfinished) return *record;
        throw core::Error(
            folder.string(),
            record ? "it holds a whole run that is finished" : "there is no shard in it",
            "folders of inkbench compare or run with --shard i/n");
    }

    [[noreturn]] void refuse_foreign(const fs::path& folder, const RunRecord& record) const {
        throw core::Error(folder.string(),
                          fmt::format("it is a shard of another run than {}: '{}' by build {}, "
                                      "against '{}' by build {}",
                                      first_.string(),
                                      record.name,
                                      record.build,
                                      record_->name,
                                      record_->build),
                          "shards of one experiment with the same settings, made by one build");
    }

    std::optional<RunRecord> record_;
    fs::path first_;
    std::map<std::size_t, fs::path> from_;
    std::vector<std::string> missing_;  ///< keys
};

}  // namespace

RunOutcome merge_shards(const std::vector<fs::path>& folders,
                        const fs::path& out,
                        bool is_partial) {
    if (folders.empty()) {
        throw core::Error("merge", "there are no folders to merge", "one folder of a shard each");
    }
    Gathering gathering;
    for (const fs::path& folder : folders)
        gathering.add(folder);
    if (!is_partial) gathering.check_complete(out);
    const BlockStore store(out);
    store.make_folder();
    const FolderLock lock(out, false);
    if (const auto there = read_record(out)) refuse_other_run(out, *there, gathering.record());
    for (const auto& [index, folder] : gathering.blocks())
        store.adopt(index, BlockStore(folder));
    for (const char* name : {"methods.csv", "axes.csv"}) {
        if (!fs::exists(gathering.first() / name)) continue;
        fs::copy_file(gathering.first() / name, out / name, fs::copy_options::overwrite_existing);
    }
    return write_run(store, gathering.record(), gathering.missing());
}

}  // namespace ink::experiment
