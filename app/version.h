#pragma once

#include <string>

namespace pendular::app {

/// Returns what `pendular --version` prints, with line ends: version of the program, compiler and
/// libraries with which it was built, version of the solver, and the atlas with a hash of its
/// simulations and hyperparameters.
std::string version_text();

}  // namespace pendular::app
