#include "core/scratch_folder.h"

#include <cstdlib>
#include <system_error>

#include "core/error.h"

namespace ink::core {
namespace {

namespace fs = std::filesystem;

fs::path made(const std::string& purpose) {
    std::string name = (fs::temp_directory_path() / ("inkbench-" + purpose + "-XXXXXX")).string();
    if (mkdtemp(name.data()) == nullptr)
        throw Error(name, "this folder cannot be made", "a temporary folder with space");
    return name;
}

void remove_all_of(const fs::path& path) {
    std::error_code ignored;
    fs::remove_all(path, ignored);
}

}  // namespace

ScratchFolder::ScratchFolder(const std::string& purpose)
    : path_(made(purpose)), ends_with_us_([path = path_] { remove_all_of(path); }) {}

ScratchFolder::~ScratchFolder() {
    remove_all_of(path_);
}

}  // namespace ink::core
