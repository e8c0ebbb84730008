#pragma once

#include <stop_token>
#include <thread>

namespace pendular::app {

/// Turns Ctrl-C (and SIGTERM) into a request to stop, so that runs end at a clean point and nothing
/// half-written is left; a second one ends the program at once.
class InterruptGuard {
  public:
    InterruptGuard();
    std::stop_token token() const { return stop_.get_token(); }

  private:
    std::stop_source stop_;
    std::jthread watcher_;
};

}  // namespace pendular::app
