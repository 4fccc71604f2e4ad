#include "experiment/gzip_file.h"

#include <zlib.h>

#include <array>
#include <memory>

#include "core/error.h"

namespace ink::experiment {

std::optional<std::string> read_gzip_file(const std::filesystem::path& path) {
    if (!std::filesystem::is_regular_file(path)) return std::nullopt;
    const std::unique_ptr<gzFile_s, int (*)(gzFile)> file(gzopen(path.c_str(), "rb"), gzclose);
    std::string text;
    std::array<char, 1 << 16> part{};
    int count = file ? gzread(file.get(), part.data(), part.size()) : -1;
    // zlib hands on what is no gzip file as it is.
    const bool is_packed = file && gzdirect(file.get()) == 0;
    while (is_packed && count > 0) {
        text.append(part.data(), static_cast<std::size_t>(count));
        count = gzread(file.get(), part.data(), part.size());
    }
    int problem = Z_OK;
    if (file) gzerror(file.get(), &problem);
    if (count < 0 || !is_packed || problem != Z_OK) {
        throw core::Error(path.string(), "it is no whole gzip file", "a table as it was packed");
    }
    return text;
}

}  // namespace ink::experiment
