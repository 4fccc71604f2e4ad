#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "experiment/experiment_plan.h"

namespace ink::experiment {

/// A finished block as it was kept, without its images: these stay on disk until the run ends.
struct KeptBlock {
    std::string key;
    double seconds = 0;  ///< that it took
    std::vector<std::string> faults;
};

/// The finished blocks of a run in `folder`/blocks: a folder each, `000012`, with block.toml, a
/// part of every table and the images. A block is written beside its place and renamed into it, so
/// that kill -9 at any moment leaves whole blocks and nothing else.
class BlockStore {
  public:
    /// Of the run in `folder`; nothing is made yet.
    explicit BlockStore(std::filesystem::path folder);

    /// Makes the folders. Throws core::Error if that cannot be.
    void make_folder() const;

    /// Writes block `index`. Throws core::Error if the disk is full; finished blocks stay.
    void write(std::size_t index, const KeptBlock& block, const BlockResult& result) const;
    /// The block at `index` if it is there, with its parts of the tables as they were written.
    [[nodiscard]] std::optional<KeptBlock> read(std::size_t index) const;
    /// Its part of `table`: lines without a heading, "" if it has none.
    [[nodiscard]] std::string lines(std::size_t index, const std::string& table) const;
    /// Which blocks are there, ascending.
    [[nodiscard]] std::vector<std::size_t> indices() const;

    /// Copies block `index` of another store into this one.
    void adopt(std::size_t index, const BlockStore& other) const;
    /// Moves the images of a block to where the run keeps them; those that are there already stay.
    void release_images(std::size_t index) const;

    /// Removes what a killed run left half-written.
    void remove_leftovers() const;
    /// Removes all blocks.
    void clear() const;

    [[nodiscard]] const std::filesystem::path& folder() const { return folder_; }

  private:
    [[nodiscard]] std::filesystem::path place_of(std::size_t index) const;

    std::filesystem::path folder_;
    std::filesystem::path blocks_;
};

/// Holds a folder against other runs for as long as it lives; gone with the process, however that
/// ends, and leaves no file.
class FolderLock {
  public:
    /// Several may share a folder, or one has it alone. Throws core::Error (where = the folder) if
    /// another run has it.
    FolderLock(const std::filesystem::path& folder, bool is_shared);
    ~FolderLock();
    FolderLock(const FolderLock&) = delete;
    FolderLock& operator=(const FolderLock&) = delete;

  private:
    int handle_ = -1;
};

}  // namespace ink::experiment
