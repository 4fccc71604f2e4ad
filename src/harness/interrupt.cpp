#include "harness/interrupt.h"

#include <csignal>

namespace ink::harness {
namespace {

volatile std::sig_atomic_t interrupted = 0;

void on_signal(int) {
    interrupted = 1;
}

void install(int signal, void (*handler)(int)) {
    struct sigaction action {};
    action.sa_handler = handler;
    // One-shot, so that the second Ctrl-C does what it always does.
    action.sa_flags = handler == on_signal ? static_cast<int>(SA_RESETHAND) : 0;
    sigaction(signal, &action, nullptr);
}

}  // namespace

InterruptGuard::InterruptGuard() {
    interrupted = 0;
    install(SIGINT, on_signal);
    install(SIGTERM, on_signal);
}

InterruptGuard::~InterruptGuard() {
    install(SIGINT, SIG_DFL);
    install(SIGTERM, SIG_DFL);
}

bool is_interrupted() {
    return interrupted != 0;
}

}  // namespace ink::harness
