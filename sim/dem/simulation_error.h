#pragma once

#include <stdexcept>

namespace pendular::dem {

/// The simulation cannot go on: a state that is not finite, a sample that never reached its stress.
class SimulationError : public std::runtime_error {
  public:
    using std::runtime_error::runtime_error;
};

/// The user asked to stop.
class Interrupted : public std::runtime_error {
  public:
    Interrupted() : std::runtime_error("interrupted") {}
};

}  // namespace pendular::dem
