#include <sched.h>
#include <unistd.h>

#include <atomic>
#include <cerrno>
#include <chrono>
#include <cstdio>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <string>
#include <vector>

#include "bench/benchmarks.h"
#include "core/parallel.h"

namespace ink::bench {

namespace {

constexpr const char* kName = "ink_bench";

std::vector<int> allowed_cores() {
    cpu_set_t set;
    CPU_ZERO(&set);
    std::vector<int> cores;
    if (sched_getaffinity(0, sizeof set, &set) != 0) return cores;
    for (int core = 0; core < CPU_SETSIZE; ++core) {
        if (CPU_ISSET(core, &set)) cores.push_back(core);
    }
    return cores;
}

/// Names a physical core; two hardware threads of one have the same. Empty if the system is silent.
std::string siblings_of(int core) {
    std::ifstream file("/sys/devices/system/cpu/cpu" + std::to_string(core) +
                       "/topology/thread_siblings_list");
    std::string line;
    std::getline(file, line);
    return line;
}

/// The last core that is not `first`, preferably one that shares nothing with it; -1 if none.
int second_core(const std::vector<int>& cores, int first) {
    int sibling = -1;
    for (auto core = cores.rbegin(); core != cores.rend(); ++core) {
        if (*core == first) continue;
        const std::string name = siblings_of(*core);
        if (name.empty() || name != siblings_of(first)) return *core;
        if (sibling < 0) sibling = *core;
    }
    return sibling;
}

bool pin(pid_t thread, int core) {
    cpu_set_t set;
    CPU_ZERO(&set);
    CPU_SET(core, &set);
    return sched_setaffinity(thread, sizeof set, &set) == 0;
}

/// Has oneTBB count the cores and make its worker before either is pinned: two bodies that wait for
/// each other cannot be run by one thread. They wait a second at most.
void wake_worker() {
    using Clock = std::chrono::steady_clock;
    const auto end = Clock::now() + std::chrono::seconds(1);
    std::atomic<int> arrived{0};
    core::parallel_for(2, 2, [&](std::size_t) {
        ++arrived;
        while (arrived < 2 && Clock::now() < end) {
        }
    });
}

bool pin_others(int core) {
    bool is_done = true;
    for (const auto& entry : std::filesystem::directory_iterator("/proc/self/task")) {
        const auto thread = static_cast<pid_t>(std::stol(entry.path().filename().string()));
        if (thread != getpid()) is_done = pin(thread, core) && is_done;
    }
    return is_done;
}

}  // namespace

void pin_to_cores() {
    const std::vector<int> cores = allowed_cores();
    const int first = cores.empty() ? -1 : cores.back();
    const int second = second_core(cores, first);
    if (second < 0) {
        std::fprintf(stderr, "%s: one core only: threads:2 will show no gain\n", kName);
    } else {
        wake_worker();
        if (siblings_of(first) == siblings_of(second) && !siblings_of(first).empty())
            std::fprintf(stderr, "%s: threads:2 shares one physical core\n", kName);
        if (!pin_others(second))
            std::fprintf(stderr, "%s: a worker is not pinned: %s\n", kName, std::strerror(errno));
    }
    if (first < 0 || !pin(0, first))
        std::fprintf(stderr, "%s: not pinned to a core: %s\n", kName, std::strerror(errno));
}

}  // namespace ink::bench
