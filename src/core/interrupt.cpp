#include "core/interrupt.h"

#include <semaphore.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <chrono>
#include <condition_variable>
#include <csignal>
#include <exception>
#include <map>
#include <mutex>
#include <thread>
#include <utility>
#include <vector>

#include "core/progress.h"

namespace ink::core {
namespace {

using Clock = std::chrono::steady_clock;

volatile std::sig_atomic_t interrupted = 0;
sem_t asked;  // posted by the handler, to which little else is allowed

struct Guarded {
    std::string what_is_left;
    std::function<void()> save;
};

/// What guards, watcher and saver share. Never destroyed: the saver may outlive main.
struct State {
    std::mutex mutex;  ///< of all that follows but `writing`
    std::condition_variable changed;
    std::vector<Guarded> guards;  ///< the innermost last
    std::map<std::uint64_t, std::function<void()>> clear_ups;
    std::uint64_t next_clear_up = 0;
    bool is_saved = false;
    int run = 0;  ///< counts outermost guards
    std::thread watcher;
    /// Held by who writes what is done. The saver never gives it back.
    std::mutex writing;
};

State& state() {
    static State& shared = *new State;
    return shared;
}

void on_signal(int) {
    const int before = errno;
    interrupted = 1;
    sem_post(&asked);
    errno = before;
}

void install(int signal, void (*handler)(int)) {
    struct sigaction action {};
    action.sa_handler = handler;
    // One-shot, so that the second Ctrl-C does what it always does.
    action.sa_flags = handler == on_signal ? static_cast<int>(SA_RESETHAND) : 0;
    sigaction(signal, &action, nullptr);
}

/// Calls the innermost `save` of this run. With one at work nothing else is written, and no guard
/// ends.
void save_what_is_done(int run) {
    State& shared = state();
    std::unique_lock writing(shared.writing);
    std::function<void()> save;
    {
        const std::lock_guard lock(shared.mutex);
        for (const Guarded& guarded : shared.guards)
            if (guarded.save && shared.run == run) save = guarded.save;
    }
    if (!save) return;
    try {
        save();
    } catch (const std::exception&) {  // a full disk: what is finished lies in parts as it did
    }
    const std::lock_guard lock(shared.mutex);
    shared.is_saved = true;
    shared.changed.notify_all();
    (void)writing.release();
}

/// Ends the process, with whatever runs in it. The caller holds State::mutex.
[[noreturn]] void cut_off(const State& shared) {
    std::string what_is_left;
    for (const Guarded& guarded : shared.guards)
        if (!guarded.what_is_left.empty()) what_is_left = "; " + guarded.what_is_left;
    // A line of progress may stand there.
    const ProgressDisplay& display = progress_display();
    const char* clear = display.is_terminal && !display.is_quiet ? "\r\033[K" : "";
    const std::string line = clear + ("inkbench: interrupted" + what_is_left) + "\n";
    // By itself: a lock of stderr may be held for good.
    if (write(STDERR_FILENO, line.data(), line.size()) < 0) {
        // Nobody reads it.
    }
    for (auto last = shared.clear_ups.rbegin(); last != shared.clear_ups.rend(); ++last)
        last->second();
    _exit(kInterrupted);
}

/// Waits for a signal, and sees to it that the program ends.
void watch() {
    while (sem_wait(&asked) != 0) {
    }
    State& shared = state();
    const auto begin = Clock::now();
    const auto after = [&](double share) {
        return begin + std::chrono::duration_cast<Clock::duration>(
                           std::chrono::duration<double>(share * kMostUntilEnd_s));
    };
    std::unique_lock lock(shared.mutex);
    const auto is_over = [&] { return shared.guards.empty(); };
    if (shared.changed.wait_until(lock, after(0.5), is_over)) return;
    std::thread(save_what_is_done, shared.run).detach();
    shared.changed.wait_until(lock, after(1), [&] { return is_over() || shared.is_saved; });
    if (!is_over()) cut_off(shared);
}

}  // namespace

InterruptGuard::InterruptGuard(std::string what_is_left, std::function<void()> save) {
    State& shared = state();
    const std::lock_guard lock(shared.mutex);
    shared.guards.push_back({std::move(what_is_left), std::move(save)});
    if (shared.guards.size() > 1) return;
    interrupted = 0;
    shared.is_saved = false;
    ++shared.run;
    sem_init(&asked, 0, 0);
    shared.watcher = std::thread(watch);
    install(SIGINT, on_signal);
    install(SIGTERM, on_signal);
}

InterruptGuard::~InterruptGuard() {
    State& shared = state();
    {
        // A saver uses what the guard's owner has.
        const std::lock_guard writing(shared.writing);
        const std::lock_guard lock(shared.mutex);
        shared.guards.pop_back();
        if (!shared.guards.empty()) return;
    }
    install(SIGINT, SIG_DFL);
    install(SIGTERM, SIG_DFL);
    shared.changed.notify_all();
    sem_post(&asked);
    shared.watcher.join();
    sem_destroy(&asked);
}

bool is_interrupted() {
    return interrupted != 0;
}

void write_unless_cut_off(const std::function<void()>& work) {
    const std::lock_guard writing(state().writing);
    work();
}

CutOffGuard::CutOffGuard(std::function<void()> clear_up) {
    State& shared = state();
    const std::lock_guard lock(shared.mutex);
    number_ = shared.next_clear_up++;
    shared.clear_ups.emplace(number_, std::move(clear_up));
}

CutOffGuard::~CutOffGuard() {
    const std::lock_guard lock(state().mutex);
    state().clear_ups.erase(number_);
}

}  // namespace ink::core
