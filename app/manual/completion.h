#pragma once

#include <string>
#include <vector>

#include "app/manual/commands.h"

namespace pendular::app {

/// Returns a script for bash that completes the names of commands and options, and the values of
/// options: accepted words, files, folders or studies.
std::string bash_completion(const std::vector<DeclaredCommand>& commands);

/// Returns such a script for zsh, which also shows descriptions.
std::string zsh_completion(const std::vector<DeclaredCommand>& commands);

/// Returns such a script for fish, which also shows descriptions.
std::string fish_completion(const std::vector<DeclaredCommand>& commands);

}  // namespace pendular::app
