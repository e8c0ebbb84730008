#pragma once

#include <stdexcept>
#include <string>

namespace pendular::dem {

/// Error of a simulation that cannot continue: its stress is not finite, an overlap is too large,
/// or the sample does not reach or keep the imposed normal stress.
class SimulationError : public std::runtime_error {
  public:
    using std::runtime_error::runtime_error;
};

/// Ends a simulation or another computation when the user stops the program. The message states
/// what was saved.
class Interrupted : public std::runtime_error {
  public:
    explicit Interrupted(const std::string& what_remains = "nothing was written")
        : std::runtime_error("interrupted; " + what_remains) {}
};

}  // namespace pendular::dem
