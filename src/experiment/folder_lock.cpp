#include "experiment/folder_lock.h"

#include <fcntl.h>
#include <sys/file.h>
#include <unistd.h>

#include <cerrno>

#include "core/error.h"

namespace ink::experiment {

FolderLock::FolderLock(const std::filesystem::path& folder, bool is_shared)
    : handle_(open(folder.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC)) {
    if (handle_ < 0) return;
    // A file system without locks is no reason not to run.
    const int failed = flock(handle_, (is_shared ? LOCK_SH : LOCK_EX) | LOCK_NB);
    if (failed != 0 && errno == EWOULDBLOCK) {
        close(handle_);
        throw core::Error(folder.string(), "another run is at work here", "another --out");
    }
}

FolderLock::~FolderLock() {
    if (handle_ >= 0) close(handle_);
}

}  // namespace ink::experiment
