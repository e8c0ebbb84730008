#include "app/interrupt.h"

#include <unistd.h>

#include <atomic>
#include <chrono>
#include <csignal>

#include "app/command.h"

namespace pendular::app {
namespace {

/// Longest time for work to end at a clean point.
constexpr std::chrono::seconds patience{20};

std::atomic<int> signals_seen{0};
static_assert(std::atomic<int>::is_always_lock_free,
              "a signal handler may only touch lock-free atomics");

extern "C" void note_signal(int) {
    if (signals_seen.fetch_add(1) > 0) {
        _exit(interrupted);
    }
}

}  // namespace

InterruptGuard::InterruptGuard() {
    std::signal(SIGINT, note_signal);
    std::signal(SIGTERM, note_signal);
    std::signal(SIGHUP, note_signal);
    // A signal handler must not request the stop itself; this thread does.
    watcher_ = std::jthread([this](const std::stop_token& end) {
        while (!end.stop_requested() && signals_seen == 0) {
            std::this_thread::sleep_for(std::chrono::milliseconds(50));
        }
        if (signals_seen == 0) return;
        stop_.request_stop();
        // Work that does not check the token is ended too, which is safe: files are written as a
        // whole or not at all.
        const auto last = std::chrono::steady_clock::now() + patience;
        while (!end.stop_requested() && std::chrono::steady_clock::now() < last) {
            std::this_thread::sleep_for(std::chrono::milliseconds(50));
        }
        if (!end.stop_requested()) {
            _exit(interrupted);
        }
    });
}

}  // namespace pendular::app
