#include "core/quiet_gate.h"

namespace ink::core {

void QuietGate::enter() {
    std::unique_lock lock(mutex_);
    changed_.wait(lock, [&] { return !is_closed(); });
    ++inside_;
}

void QuietGate::leave() {
    const std::lock_guard lock(mutex_);
    --inside_;
    changed_.notify_all();
}

void QuietGate::begin_alone() {
    std::unique_lock lock(mutex_);
    ++asking_;
    --inside_;
    changed_.notify_all();
    changed_.wait(lock, [&] { return inside_ == 0 && !is_taken_; });
    is_taken_ = true;
}

void QuietGate::end_alone() {
    std::unique_lock lock(mutex_);
    is_taken_ = false;
    --asking_;
    changed_.notify_all();
    changed_.wait(lock, [&] { return !is_closed(); });
    ++inside_;
}

}  // namespace ink::core
