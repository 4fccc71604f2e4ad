#include "tests/fuzz/scratch_file.h"

#include <fstream>
#include <stdexcept>

#include "tests/core/temp_folder.h"

namespace ink::fuzz {

std::filesystem::path scratch_file(const std::string& name, Bytes bytes) {
    static const core::TempFolder folder;
    const std::filesystem::path path = folder / name;
    std::ofstream file(path, std::ios::binary);
    file.write(reinterpret_cast<const char*>(bytes.data()),
               static_cast<std::streamsize>(bytes.size()));
    if (!file.flush()) throw std::runtime_error("no room for a file");
    return path;
}

}  // namespace ink::fuzz
