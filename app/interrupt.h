#pragma once

#include <stop_token>
#include <thread>

namespace pendular::app {

/// Turns the signals SIGINT (Ctrl-C), SIGTERM and SIGHUP into a request to stop, so that long
/// computations end in order and leave no half-written file. The program ends at most 20 s after
/// the first signal, even if a computation does not check `token`. A second signal ends it at once.
class InterruptGuard {
  public:
    InterruptGuard();
    /// Returns the token that long computations must check. A stop is requested within about 50 ms
    /// of the first signal.
    std::stop_token token() const { return stop_.get_token(); }

  private:
    std::stop_source stop_;
    std::jthread watcher_;
};

}  // namespace pendular::app
