#include "core/parallel.h"

#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>
#include <tbb/task_arena.h>

#include <algorithm>
#include <atomic>
#include <cassert>
#include <chrono>
#include <exception>
#include <map>
#include <mutex>
#include <thread>
#include <utility>
#include <vector>

#include "core/quiet_gate.h"

namespace ink::core {
namespace {

/// What lanes share.
struct Lanes {
    Lanes(int count, Others of_one_alone) : busy(count), others(of_one_alone), gate(count) {}

    std::atomic<int> busy;  ///< lanes that have not ended
    const Others others;
    QuietGate gate;            ///< every thread that works on a lane is inside
    std::mutex one_at_a_time;  ///< instead of the gate, where others work on
};

/// Where a thread works: on which lane, and beside which others.
struct Post {
    int lane = 0;
    Lanes* lanes = nullptr;  ///< nothing outside of lanes
    bool is_alone = false;

    /// Whether other lanes may work while this one does.
    [[nodiscard]] bool has_others() const {
        if (!lanes || lanes->busy == 1) return false;
        return !is_alone || lanes->others == Others::work_on;
    }
    /// Nothing for a thread that never has to stand still; the last lane has none to wait for.
    [[nodiscard]] QuietGate* gate() const {
        return has_others() && lanes->others == Others::stand_still ? &lanes->gate : nullptr;
    }
};

Post& this_post() {
    static thread_local Post post;
    return post;
}

/// Puts the thread on a post while it lives.
class PostGuard {
  public:
    explicit PostGuard(Post post) : before_(std::exchange(this_post(), post)) {}
    ~PostGuard() { this_post() = before_; }
    PostGuard(const PostGuard&) = delete;
    PostGuard& operator=(const PostGuard&) = delete;

  private:
    Post before_;
};

/// The seconds that this thread has waited at a gate.
double& waited() {
    static thread_local double seconds = 0;
    return seconds;
}

/// Calls `wait` and notes how long it took.
template <class Wait>
void wait_at_gate(Wait wait) {
    using Clock = std::chrono::steady_clock;
    const auto begin = Clock::now();
    wait();
    waited() += std::chrono::duration<double>(Clock::now() - begin).count();
}

/// Has the thread inside the gate, or outside of it, while it lives. No gate: nothing.
class InsideGuard {
  public:
    explicit InsideGuard(QuietGate* gate) : gate_(gate) {
        if (gate_) gate_->enter();
    }
    ~InsideGuard() {
        if (gate_) gate_->leave();
    }
    InsideGuard(const InsideGuard&) = delete;
    InsideGuard& operator=(const InsideGuard&) = delete;

  private:
    QuietGate* gate_;
};
class OutsideGuard {
  public:
    explicit OutsideGuard(QuietGate* gate) : gate_(gate) {
        if (gate_) gate_->leave();
    }
    ~OutsideGuard() {
        if (gate_) wait_at_gate([&] { gate_->enter(); });
    }
    OutsideGuard(const OutsideGuard&) = delete;
    OutsideGuard& operator=(const OutsideGuard&) = delete;

  private:
    QuietGate* gate_;
};

/// Has the thread alone while it lives.
class AloneGuard {
  public:
    explicit AloneGuard(Lanes& lanes) : lanes_(lanes) {
        wait_at_gate(
            [&] { stands_still() ? lanes_.gate.begin_alone() : lanes_.one_at_a_time.lock(); });
        this_post().is_alone = true;
    }
    ~AloneGuard() {
        this_post().is_alone = false;
        wait_at_gate(
            [&] { stands_still() ? lanes_.gate.end_alone() : lanes_.one_at_a_time.unlock(); });
    }
    AloneGuard(const AloneGuard&) = delete;
    AloneGuard& operator=(const AloneGuard&) = delete;

  private:
    [[nodiscard]] bool stands_still() const { return lanes_.others == Others::stand_still; }

    Lanes& lanes_;
};

using Range = std::function<void(std::size_t first, std::size_t end)>;

#ifdef __SANITIZE_THREAD__

/// The thread sanitizer does not know what orders the tasks of oneTBB, which is not built with it.
/// For it loops run on threads that it sees.
void divide(std::size_t count, int threads, int /*lane*/, const Range& range) {
    std::atomic<std::size_t> next = 0;
    std::mutex mutex;
    std::exception_ptr failure;
    const auto work = [&] {
        try {
            for (std::size_t i = next++; i < count; i = next++)
                range(i, i + 1);
        } catch (...) {
            next = count;
            const std::lock_guard lock(mutex);
            if (!failure) failure = std::current_exception();
        }
    };
    std::vector<std::thread> others;
    for (int i = 1; i < threads; ++i)
        others.emplace_back(work);
    work();
    for (std::thread& other : others)
        other.join();
    if (failure) std::rethrow_exception(failure);
}

#else

/// A lane's arena for so many threads, made once: a new one would have to wake its workers for
/// every loop, which is long beside a frame of a millisecond. Never destroyed: workers outlive
/// main.
tbb::task_arena& arena_of(int threads, int lane) {
    static std::mutex mutex;
    static auto& arenas = *new std::map<std::pair<int, int>, tbb::task_arena>();
    const std::lock_guard lock(mutex);
    return arenas.try_emplace({threads, lane}, threads).first->second;
}

void divide(std::size_t count, int threads, int lane, const Range& range) {
    arena_of(threads, lane).execute([&] {
        tbb::parallel_for(tbb::blocked_range<std::size_t>(0, count),
                          [&](const auto& part) { range(part.begin(), part.end()); });
    });
}

#endif

}  // namespace

void parallel_for(std::size_t count, int threads, const std::function<void(std::size_t)>& body) {
    assert(threads >= 1);
    // More threads than the machine has would only wait, and oneTBB warns of it on stderr.
    if (threads > 1 && count > 1) threads = std::min(threads, share_of_threads());
    if (threads == 1 || count <= 1) {
        for (std::size_t i = 0; i < count; ++i) {
            if (i > 0) pause();
            body(i);
        }
        return;
    }
    const Post post = this_post();
    // This thread comes back as one of those that work, or only waits for them.
    QuietGate* gate = post.gate();
    const OutsideGuard outside(gate);
    divide(count, threads, post.lane, [&](std::size_t first, std::size_t end) {
        const PostGuard guard(post);
        const InsideGuard inside(gate);
        for (std::size_t i = first; i != end; ++i) {
            if (i > first) pause();
            body(i);
        }
    });
}

int hardware_threads() {
    return std::max(1, static_cast<int>(std::thread::hardware_concurrency()));
}

void run_lanes(int count, const std::function<void(int)>& body, Others others) {
    assert(count >= 1 && this_post().lanes == nullptr);
    if (count == 1) return body(0);
    Lanes lanes(count, others);
    std::vector<std::exception_ptr> failures(static_cast<std::size_t>(count));
    std::vector<std::thread> threads;
    for (int lane = 0; lane < count; ++lane) {
        threads.emplace_back([&, lane] {
            const PostGuard guard({lane, &lanes});
            try {
                body(lane);
            } catch (...) {
                failures[static_cast<std::size_t>(lane)] = std::current_exception();
            }
            --lanes.busy;
            lanes.gate.leave();
        });
    }
    for (std::thread& thread : threads)
        thread.join();
    for (const std::exception_ptr& failure : failures)
        if (failure) std::rethrow_exception(failure);
}

void run_alone(const std::function<void()>& work) {
    const Post& post = this_post();
    if (post.is_alone || !post.has_others()) return work();
    const AloneGuard alone(*post.lanes);
    work();
}

void pause() {
    QuietGate* gate = this_post().gate();
    if (gate && gate->is_closed()) wait_at_gate([&] { gate->pause(); });
}

double waited_s() {
    return waited();
}

int this_lane() {
    return this_post().lane;
}

int share_of_threads() {
    const Post& post = this_post();
    if (!post.has_others()) return hardware_threads();
    return std::max(1, hardware_threads() / std::max(1, post.lanes->busy.load()));
}

}  // namespace ink::core
