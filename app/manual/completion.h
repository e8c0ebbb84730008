#pragma once

#include <string>
#include <vector>

#include "app/manual/commands.h"

namespace pendular::app {

/// Returns a script for the shell bash that completes the names of commands, the names of options,
/// and the values of options. The values are the accepted words of an option that accepts only a
/// few words, or files, folders or studies.
std::string bash_completion(const std::vector<DeclaredCommand>& commands);

/// Returns a script for the shell zsh that completes the names of commands, the names of options
/// and the values of options, and shows descriptions.
std::string zsh_completion(const std::vector<DeclaredCommand>& commands);

/// Returns a script for the shell fish that completes the names of commands, the names of options
/// and the values of options, and shows descriptions.
std::string fish_completion(const std::vector<DeclaredCommand>& commands);

}  // namespace pendular::app
