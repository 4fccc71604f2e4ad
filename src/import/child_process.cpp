#include "import/child_process.h"

#include <fcntl.h>
#include <poll.h>
#include <sys/prctl.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <chrono>
#include <cmath>
#include <csignal>
#include <limits>
#include <optional>
#include <utility>

#include "core/interrupt.h"

namespace ink::import {
namespace {

using Clock = std::chrono::steady_clock;

constexpr std::size_t kReadBytes = 1 << 20;
constexpr int kExecFailed = 127;  // as a shell would say it

#if defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__)
constexpr bool kLimitMemory = false;  // sanitizers reserve terabytes for their shadow
#else
constexpr bool kLimitMemory = true;
#endif
#if defined(__SANITIZE_THREAD__)
constexpr bool kLimitFiles = false;  // this one maps a large file before main
#else
constexpr bool kLimitFiles = true;
#endif

class FileDescriptor {
  public:
    explicit FileDescriptor(int fd = -1) : fd_(fd) {}
    FileDescriptor(FileDescriptor&& other) noexcept : fd_(std::exchange(other.fd_, -1)) {}
    FileDescriptor& operator=(FileDescriptor&& other) noexcept {
        std::swap(fd_, other.fd_);
        return *this;
    }
    ~FileDescriptor() { reset(); }

    void reset() {
        if (fd_ >= 0) close(std::exchange(fd_, -1));
    }
    [[nodiscard]] int number() const { return fd_; }

  private:
    int fd_;
};

std::int64_t ns_of(const timeval& time) {
    return std::int64_t{time.tv_sec} * 1'000'000'000 + std::int64_t{time.tv_usec} * 1'000;
}

/// A running child, killed and reaped when it goes out of scope.
class Child {
  public:
    Child(pid_t pid, bool leads_group)
        : pid_(pid), group_(leads_group ? pid : 0), ends_with_us_([group = group_] {
              if (group > 0) kill(-group, SIGKILL);
          }) {}
    Child(const Child&) = delete;
    Child& operator=(const Child&) = delete;
    ~Child() {
        kill_and_reap();
        if (group_ > 0) kill(-group_, SIGKILL);  // what it left behind
    }

    /// The wait status if it has ended; never blocks.
    std::optional<int> ended() {
        int status = 0;
        rusage used{};
        pid_t got = -1;
        do {
            got = wait4(pid_, &status, WNOHANG, &used);
        } while (got < 0 && errno == EINTR);
        if (got == 0) return std::nullopt;
        pid_ = -1;
        cpu_ns_ = ns_of(used.ru_utime) + ns_of(used.ru_stime);
        // Whoever ignores SIGCHLD loses the status; then the output alone has to convince.
        return got < 0 ? 0 : status;
    }

    /// Processor time of what has ended.
    [[nodiscard]] std::int64_t cpu_ns() const { return cpu_ns_; }

    void kill_and_reap() {
        if (pid_ < 0) return;
        if (group_ > 0) kill(-group_, SIGKILL);
        kill(pid_, SIGKILL);
        while (waitpid(pid_, nullptr, 0) < 0 && errno == EINTR) {
        }
        pid_ = -1;
    }

  private:
    pid_t pid_;
    pid_t group_;  ///< 0: it leads none
    std::int64_t cpu_ns_ = 0;
    core::CutOffGuard ends_with_us_;
};

/// All that the forked child needs, computed before the fork: other threads may hold any lock.
struct Launch {
    const char* program;
    char* const* arguments;
    int null_fd;
    int output_fd;
    pid_t parent;
    rlim_t cpu_s;
    const ChildLimits& limits;
};

void limit(__rlimit_resource what, rlim_t most) {
    const rlimit both{most, most};
    setrlimit(what, &both);  // fails only where a tighter limit stands already
}

/// The forked child's way to exec. Only async-signal-safe calls.
[[noreturn]] void become_child(const Launch& launch) {
    // Ctrl-C must end the child whatever the parent does with the signal.
    for (const int number : {SIGINT, SIGTERM, SIGQUIT, SIGHUP, SIGPIPE})
        signal(number, SIG_DFL);
    sigset_t none;
    sigemptyset(&none);
    sigprocmask(SIG_SETMASK, &none, nullptr);
    prctl(PR_SET_PDEATHSIG, SIGKILL);
    const ChildLimits& limits = launch.limits;
    if (limits.leads_group) setpgid(0, 0);
    if (getppid() != launch.parent) _exit(kExecFailed);  // it died before we asked to be told

    dup2(launch.null_fd, STDIN_FILENO);
    dup2(launch.output_fd, STDOUT_FILENO);
    dup2(limits.keeps_errors ? launch.output_fd : launch.null_fd, STDERR_FILENO);
    limit(RLIMIT_CORE, 0);
    if (kLimitFiles) limit(RLIMIT_FSIZE, limits.file_bytes);
    limit(RLIMIT_CPU, launch.cpu_s);
    if (kLimitMemory) limit(limits.counts_reserved ? RLIMIT_AS : RLIMIT_DATA, limits.memory_bytes);
    execv(launch.program, launch.arguments);
    _exit(kExecFailed);
}

/// The descriptor moved out of the way of 0, 1 and 2, which a caller may have closed.
FileDescriptor above_standard(int fd) {
    FileDescriptor low(fd);
    if (fd < 0 || fd > STDERR_FILENO) return low;
    return FileDescriptor(fcntl(fd, F_DUPFD_CLOEXEC, STDERR_FILENO + 1));
}

int poll_timeout_ms(Clock::time_point deadline) {
    const auto left = std::chrono::ceil<std::chrono::milliseconds>(deadline - Clock::now()).count();
    return static_cast<int>(std::clamp<std::int64_t>(left, 0, std::numeric_limits<int>::max()));
}

/// Reads until the child closes its output; the end is `exited` if it did so within its limits.
ChildEnd drain(int fd,
               Clock::time_point deadline,
               std::uint64_t most,
               std::vector<std::byte>& out) {
    std::size_t used = 0;
    while (true) {
        pollfd wait{fd, POLLIN, 0};
        const int ready = poll(&wait, 1, poll_timeout_ms(deadline));
        if (Clock::now() >= deadline) return ChildEnd::timed_out;
        if (ready <= 0) continue;  // interrupted, or woken early

        if (out.size() - used < kReadBytes) out.resize(std::max(2 * out.size(), used + kReadBytes));
        const ssize_t got = read(fd, out.data() + used, out.size() - used);
        if (got < 0 && (errno == EINTR || errno == EAGAIN)) continue;
        if (got <= 0) break;
        used += static_cast<std::size_t>(got);
        if (used > most) return ChildEnd::flooded;
    }
    out.resize(used);
    return ChildEnd::exited;
}

/// Waits for the end of a child that has closed its output: at once, unless it plays dead.
std::optional<int> await_end(Child& child, Clock::time_point deadline) {
    while (true) {
        if (const auto status = child.ended()) return status;
        if (Clock::now() >= deadline) return std::nullopt;
        poll(nullptr, 0, 1);
    }
}

}  // namespace

ChildOutcome run_child(const std::filesystem::path& program,
                       const std::vector<std::string>& arguments,
                       const ChildLimits& limits) {
    int ends[2] = {-1, -1};
    if (pipe2(ends, O_CLOEXEC) != 0) return {ChildEnd::not_started, errno, {}};
    const FileDescriptor from_child = above_standard(ends[0]);
    FileDescriptor to_parent = above_standard(ends[1]);
    const FileDescriptor null = above_standard(open("/dev/null", O_RDWR | O_CLOEXEC));
    if (null.number() < 0) return {ChildEnd::not_started, errno, {}};

    std::vector<std::string> texts = {program.string()};
    texts.insert(texts.end(), arguments.begin(), arguments.end());
    std::vector<char*> words;
    for (std::string& text : texts)
        words.push_back(text.data());
    words.push_back(nullptr);
    const double wall_s = std::clamp(limits.wall_s, 0.0, 1e6);
    const Launch launch{.program = words.front(),
                        .arguments = words.data(),
                        .null_fd = null.number(),
                        .output_fd = to_parent.number(),
                        .parent = getpid(),
                        // A backstop only, for the day on which the parent is stopped itself.
                        .cpu_s = static_cast<rlim_t>(std::ceil(wall_s * limits.threads)) + 1,
                        .limits = limits};
    const auto deadline = Clock::now() + std::chrono::duration_cast<Clock::duration>(
                                             std::chrono::duration<double>(wall_s));
    const pid_t pid = fork();
    if (pid < 0) return {ChildEnd::not_started, errno, {}};
    if (pid == 0) become_child(launch);

    if (limits.leads_group) setpgid(pid, pid);  // whoever comes first
    Child child(pid, limits.leads_group);
    to_parent.reset();
    ChildOutcome outcome;
    outcome.end = drain(from_child.number(), deadline, limits.output_bytes, outcome.output);
    if (outcome.end != ChildEnd::exited) return outcome;
    const auto status = await_end(child, deadline);
    outcome.cpu_ns = child.cpu_ns();
    if (!status) {
        outcome.end = ChildEnd::timed_out;
    } else if (WIFSIGNALED(*status)) {
        outcome.end = ChildEnd::signalled;
        outcome.code = WTERMSIG(*status);
    } else {
        outcome.code = WEXITSTATUS(*status);
    }
    return outcome;
}

}  // namespace ink::import
