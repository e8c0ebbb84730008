#pragma once

#include <stdexcept>
#include <string>

namespace pendular::dem {

/// Error of a simulation that cannot continue: a state that is not finite, or a sample that never
/// reached its stress.
class SimulationError : public std::runtime_error {
  public:
    using std::runtime_error::runtime_error;
};

/// Thrown where the user stops the work.
class Interrupted : public std::runtime_error {
  public:
    explicit Interrupted(const std::string& what_remains = "nothing was written")
        : std::runtime_error("interrupted; " + what_remains) {}
};

}  // namespace pendular::dem
