#pragma once

#include <filesystem>
#include <string>

#include "core/interrupt.h"

namespace ink::core {

/// A new folder among the temporary ones, which is gone with this, or with the program.
class ScratchFolder {
  public:
    /// Called "inkbench-" + `purpose` and some letters. Throws Error if it cannot be made.
    explicit ScratchFolder(const std::string& purpose);
    ~ScratchFolder();
    ScratchFolder(const ScratchFolder&) = delete;
    ScratchFolder& operator=(const ScratchFolder&) = delete;

    [[nodiscard]] const std::filesystem::path& path() const { return path_; }

  private:
    std::filesystem::path path_;
    CutOffGuard ends_with_us_;
};

}  // namespace ink::core
