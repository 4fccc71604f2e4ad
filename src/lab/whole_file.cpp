#include "lab/whole_file.h"

#include <unistd.h>

#include <cerrno>
#include <cstdio>
#include <string>
#include <system_error>

#include "core/error.h"

namespace ink::lab {
namespace {

/// The errno of writing `text` to a new file, or 0.
int write_new(const std::filesystem::path& path, std::string_view text) {
    std::FILE* file = std::fopen(path.c_str(), "wb");
    if (file == nullptr) return errno;
    int problem = std::fwrite(text.data(), 1, text.size(), file) == text.size() ? 0 : errno;
    // A full disk may show only when the last buffer goes out.
    if (std::fclose(file) != 0 && problem == 0) problem = errno;
    return problem;
}

}  // namespace

void write_whole_file(const std::filesystem::path& path, std::string_view text) {
    std::filesystem::path waiting = path;
    waiting += "." + std::to_string(::getpid()) + ".part";
    std::error_code failure(write_new(waiting, text), std::generic_category());
    if (!failure) std::filesystem::rename(waiting, path, failure);
    if (!failure) return;
    std::error_code ignored;
    std::filesystem::remove(waiting, ignored);
    throw core::Error(path.string(),
                      "cannot be written: " + failure.message(),
                      "a file name in a folder that can be written to");
}

}  // namespace ink::lab
