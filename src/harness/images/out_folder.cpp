#include "harness/images/out_folder.h"

#include <string>
#include <system_error>

#include "core/error.h"

namespace ink::harness {

void make_out_folder(const std::filesystem::path& folder) {
    std::error_code failure;
    std::filesystem::create_directories(folder, failure);
    if (failure || !std::filesystem::is_directory(folder)) {
        throw core::Error(
            folder.string(),
            "this folder cannot be made" + (failure ? ": " + failure.message() : std::string()),
            "a place that can be written");
    }
}

}  // namespace ink::harness
