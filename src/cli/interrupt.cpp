#include "cli/interrupt.hpp"

#include <csignal>

namespace fringe::cli {
namespace {

// A signal handler may touch lock-free atomics and nothing else.
std::atomic<bool> flag{false};
std::atomic<int> signalNumber{0};
static_assert(std::atomic<bool>::is_always_lock_free && std::atomic<int>::is_always_lock_free);

void onSignal(int number) {
    signalNumber = number;
    flag = true;
}

}  // namespace

void catchInterrupts() {
    struct sigaction action {};
    action.sa_handler = onSignal;
    action.sa_flags = static_cast<int>(SA_RESETHAND | SA_RESTART);
    sigaction(SIGINT, &action, nullptr);
    sigaction(SIGTERM, &action, nullptr);
}

const std::atomic<bool>& interrupted() {
    return flag;
}

int interruptStatus() {
    return 128 + signalNumber;
}

}  // namespace fringe::cli
