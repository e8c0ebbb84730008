#pragma once

#include <stop_token>
#include <thread>

namespace pendular::app {

/// Turns Ctrl-C (SIGINT) and SIGTERM into a request to stop, so that runs end at a clean point and
/// no file is left half-written. A second signal ends the program at once.
class InterruptGuard {
  public:
    InterruptGuard();
    /// Token that requests a stop after the first signal.
    std::stop_token token() const { return stop_.get_token(); }

  private:
    std::stop_source stop_;
    std::jthread watcher_;
};

}  // namespace pendular::app
