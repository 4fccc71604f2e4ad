#include "harness/out_folder.h"

#include "core/error.h"

namespace ink::harness {

void make_out_folder(const std::filesystem::path& folder) {
    std::error_code failure;
    std::filesystem::create_directories(folder, failure);
    if (failure || !std::filesystem::is_directory(folder)) {
        throw core::Error(
            folder.string(), "this folder cannot be made", "a writable place for --out");
    }
}

}  // namespace ink::harness
