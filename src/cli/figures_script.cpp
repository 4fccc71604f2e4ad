#include "cli/figures_script.h"

#include <fmt/format.h>
#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cerrno>
#include <cstdlib>
#include <cstring>
#include <filesystem>

#include "core/error.h"

namespace ink::cli {
namespace {

namespace fs = std::filesystem;

constexpr const char* kScript = "figures.py";
constexpr const char* kPackages =
    "Python 3.11 with pandas and matplotlib, on Debian: apt-get install python3 python3-pandas "
    "python3-matplotlib; INKBENCH_PYTHON names another Python";

std::string python() {
    const char* named = std::getenv("INKBENCH_PYTHON");
    return named != nullptr && *named != '\0' ? named : "/usr/bin/python3";
}

/// What is installed beside the program comes first: the tree it was built from may be gone, or
/// another version by now.
fs::path script() {
    std::error_code error;
    const fs::path program = fs::read_symlink("/proc/self/exe", error);
    const fs::path installed =
        program.parent_path() / INK_SHARE_FROM_PROGRAM / "notebooks" / kScript;
    for (const fs::path& file : {installed, fs::path(INK_SOURCE_NOTEBOOKS) / kScript})
        if (fs::is_regular_file(file, error)) return file.lexically_normal();
    throw core::Error("inkbench figures",
                      fmt::format("the script {} is not there", kScript),
                      fmt::format("{} or {}",
                                  installed.lexically_normal().string(),
                                  (fs::path(INK_SOURCE_NOTEBOOKS) / kScript).string()));
}

/// As exec takes them; valid as long as `words` is.
std::vector<char*> pointers_to(std::vector<std::string>& words) {
    std::vector<char*> pointers;
    for (std::string& word : words)
        pointers.push_back(word.data());
    pointers.push_back(nullptr);
    return pointers;
}

}  // namespace

int run_figures_script(const std::vector<std::string>& arguments) {
    const std::string program = python();
    // -B: no compiled files beside the script.
    std::vector<std::string> words = {program, "-B", script().string()};
    words.insert(words.end(), arguments.begin(), arguments.end());
    pid_t child = -1;
    const int failure =
        posix_spawnp(&child, program.c_str(), nullptr, nullptr, pointers_to(words).data(), environ);
    if (failure != 0) {
        throw core::Error(
            program, fmt::format("it cannot be started ({})", std::strerror(failure)), kPackages);
    }
    int status = 0;
    while (waitpid(child, &status, 0) < 0 && errno == EINTR) {
    }
    return WIFSIGNALED(status) ? 128 + WTERMSIG(status) : WEXITSTATUS(status);
}

}  // namespace ink::cli
