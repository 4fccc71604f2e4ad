#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "experiment/experiment_plan.h"

namespace ink::experiment {

/// What a folder of results says of the plan that it belongs to: its plan.toml.
struct PlanRecord {
    std::string name;
    std::string identity;
    std::string build;
    bool times = true;
    bool one_place = true;
    bool is_finished = false;  ///< the tables are there
    std::vector<PlannedTable> tables;
    std::vector<std::string> keys;  ///< of the blocks, in plan order
};

[[nodiscard]] PlanRecord record_of(const Plan& plan);

class BlockStore;

/// Throws core::Error (where = the folder) unless `there`, the plan of its results, is `mine`.
void refuse_other_plan(const BlockStore& store, const PlanRecord& there, const PlanRecord& mine);

/// A finished block as it was kept.
struct KeptBlock {
    BlockResult result;
    double seconds = 0;  ///< that it took
};

/// The finished blocks of an experiment in a folder: a file each, written whole and moved to its
/// name, so that kill -9 at any moment leaves whole blocks and nothing else. A file whose checksum
/// is wrong (the machine lost power) counts as not there.
class BlockStore {
  public:
    /// Of the results in `folder`; nothing is made yet.
    explicit BlockStore(std::filesystem::path folder);

    /// The plan that the folder belongs to; nothing if there is none. Throws core::Error for a
    /// plan.toml that cannot be read.
    [[nodiscard]] std::optional<PlanRecord> read_plan() const;
    /// Makes the folder. Throws core::Error if that cannot be.
    void make_folder() const;
    /// Writes plan.toml into the folder, which is there.
    void write_plan(const PlanRecord& record) const;

    /// Writes block `index`. Throws core::Error if the disk is full; finished blocks stay.
    void write(std::size_t index, const std::string& key, const KeptBlock& block) const;
    /// The block at `index` if it is there, whole, and called `key`.
    [[nodiscard]] std::optional<KeptBlock> read(std::size_t index, const std::string& key) const;
    /// Which files of blocks are there, whatever they hold, by index.
    [[nodiscard]] std::vector<std::size_t> indices() const;

    /// Removes all blocks, and what a killed run left half-written.
    void clear() const;

    [[nodiscard]] const std::filesystem::path& folder() const { return folder_; }

  private:
    [[nodiscard]] std::filesystem::path file_of(std::size_t index) const;

    std::filesystem::path folder_;
    std::filesystem::path blocks_;
};

}  // namespace ink::experiment
