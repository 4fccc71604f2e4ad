#include "core/whole_file.h"

#include <fmt/format.h>

#include <cctype>
#include <cerrno>
#include <cstdio>
#include <fstream>
#include <iterator>
#include <random>
#include <system_error>

#include "core/error.h"

namespace ink::core {
namespace {

/// The errno of writing `bytes` to a file that must not exist yet, or 0.
int write_new(const std::filesystem::path& path, std::string_view bytes) {
    std::FILE* file = std::fopen(path.c_str(), "wbx");
    if (file == nullptr) return errno;
    int problem = std::fwrite(bytes.data(), 1, bytes.size(), file) == bytes.size() ? 0 : errno;
    // A full disk may show only when the last buffer goes out.
    if (std::fclose(file) != 0 && problem == 0) problem = errno;
    return problem;
}

}  // namespace

std::string system_reason(int error) {
    if (error == 0) return "unknown reason";
    std::string words = std::generic_category().message(error);
    if (!words.empty())
        words[0] = static_cast<char>(std::tolower(static_cast<unsigned char>(words[0])));
    return error == ENOSPC ? "disk full (" + words + ")" : words;
}

Error refused_path(const std::filesystem::filesystem_error& error) {
    return {error.path1().string(), system_reason(error.code().value()), "a path that can be used"};
}

std::optional<std::string> read_whole_file(const std::filesystem::path& path) {
    std::error_code failure;
    if (std::filesystem::is_directory(path, failure)) return std::nullopt;
    std::ifstream stream(path, std::ios::binary);
    if (!stream) return std::nullopt;
    std::string bytes{std::istreambuf_iterator<char>(stream), std::istreambuf_iterator<char>()};
    if (stream.bad()) return std::nullopt;
    return bytes;
}

void write_whole_file(const std::filesystem::path& path, std::string_view bytes) {
    std::random_device random;
    std::filesystem::path waiting = path;
    waiting += fmt::format(".{:08x}{:08x}.part", random(), random());
    std::error_code failure(write_new(waiting, bytes), std::generic_category());
    if (!failure) std::filesystem::rename(waiting, path, failure);
    if (!failure) return;
    std::error_code ignored;
    std::filesystem::remove(waiting, ignored);
    throw Error(path.string(),
                "cannot be written: " + system_reason(failure.value()),
                failure == std::errc::no_space_on_device
                    ? "a disk with room for it"
                    : "a file name in a folder that can be written to");
}

}  // namespace ink::core
