#include "app/interrupt.h"

#include <pthread.h>
#include <signal.h>
#include <unistd.h>

#include <ctime>

#include "app/command.h"

namespace pendular::app {

InterruptGuard::InterruptGuard() {
    sigset_t signals;
    sigemptyset(&signals);
    sigaddset(&signals, SIGINT);
    sigaddset(&signals, SIGTERM);
    // Threads made later inherit the mask, so that the watcher alone receives the signals.
    pthread_sigmask(SIG_BLOCK, &signals, nullptr);
    watcher_ = std::jthread([this, signals](std::stop_token end) {
        const timespec patience{.tv_sec = 0, .tv_nsec = 100'000'000};
        while (!end.stop_requested()) {
            if (sigtimedwait(&signals, nullptr, &patience) < 0) {
                continue;
            }
            if (stop_.stop_requested()) {
                _exit(interrupted);
            }
            stop_.request_stop();
        }
    });
}

}  // namespace pendular::app
