#pragma once

#include <stop_token>
#include <thread>

namespace pendular::app {

/// Turns the signals SIGINT (Ctrl-C), SIGTERM and SIGHUP into a request to stop, so that simulation
/// runs end at a clean point and no file is left half-written. A second signal ends the program at
/// once. After the first signal, the program ends at the latest after 20 s, even if the work does
/// not check the token.
class InterruptGuard {
  public:
    InterruptGuard();
    /// Token that long work must check: a stop is requested within about 50 ms of the first signal.
    std::stop_token token() const { return stop_.get_token(); }

  private:
    std::stop_source stop_;
    std::jthread watcher_;
};

}  // namespace pendular::app
