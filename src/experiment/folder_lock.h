#pragma once

#include <filesystem>

namespace ink::experiment {

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
