#include <unistd.h>

#include <array>
#include <csignal>
#include <cstdlib>
#include <filesystem>
#include <functional>
#include <map>
#include <memory>
#include <string>
#include <vector>

namespace ink::import {
namespace {

void eat_memory() {
    constexpr std::size_t kBite = 16 << 20;
    std::vector<std::vector<char>> eaten;
    while (true)
        eaten.emplace_back(kBite, 'x');
}

void spin() {
    volatile bool forever = true;
    while (forever) {
    }
}

void flood(int fd) {
    const std::vector<char> junk(1 << 16, '?');
    while (write(fd, junk.data(), junk.size()) > 0) {
    }
}

}  // namespace

void provoke_fault(const std::string& path, int output_fd);

/// Misbehaves as the stem of `path` asks, in the test build of the import child only: `crash`,
/// `abort`, `hang`, `sleep`, `hungry` (memory), `quit` (an exit without an answer), `babble`
/// (nonsense for an answer), `flood` (an endless answer), `linger` (closes its answer and stays).
/// Else returns.
void provoke_fault(const std::string& path, int output_fd) {
    const std::map<std::string, std::function<void()>> faults{
        {"crash", [] { raise(SIGSEGV); }},
        {"abort", [] { std::abort(); }},
        {"hang", spin},
        {"sleep",
         [] {
             while (true)
                 pause();
         }},
        {"hungry", eat_memory},
        {"quit", [] { _exit(3); }},
        {"babble",
         [=] {
             if (write(output_fd, "hello", 5) == 5) _exit(0);
         }},
        {"flood", [=] { flood(output_fd); }},
        {"linger",
         [=] {
             close(output_fd);
             while (true)
                 pause();
         }},
    };
    const auto fault = faults.find(std::filesystem::path(path).stem().string());
    if (fault != faults.end()) fault->second();
}

}  // namespace ink::import
