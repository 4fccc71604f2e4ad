#include "tests/fuzz/scratch_file.h"

#include <stdlib.h>

#include <fstream>
#include <stdexcept>

namespace ink::fuzz {
namespace {

namespace fs = std::filesystem;

class ScratchFolder {
  public:
    ScratchFolder() {
        std::string pattern = (fs::temp_directory_path() / "inkbench_fuzz_XXXXXX").string();
        if (mkdtemp(pattern.data()) == nullptr) throw std::runtime_error("no folder for files");
        path_ = pattern;
    }
    ~ScratchFolder() {
        std::error_code failure;
        fs::remove_all(path_, failure);
    }
    ScratchFolder(const ScratchFolder&) = delete;
    ScratchFolder& operator=(const ScratchFolder&) = delete;

    [[nodiscard]] const fs::path& path() const { return path_; }

  private:
    fs::path path_;
};

}  // namespace

fs::path scratch_file(const std::string& name, Bytes bytes) {
    static const ScratchFolder folder;
    const fs::path path = folder.path() / name;
    std::ofstream file(path, std::ios::binary);
    file.write(reinterpret_cast<const char*>(bytes.data()),
               static_cast<std::streamsize>(bytes.size()));
    if (!file.flush()) throw std::runtime_error("no room for a file");
    return path;
}

}  // namespace ink::fuzz
