#pragma once

#include <string>
#include <vector>

#include "app/manual/commands.h"

namespace pendular::app {

/// Script for bash that completes commands, their options, and values of options: words where an
/// option accepts few, else files, folders or studies.
std::string bash_completion(const std::vector<DeclaredCommand>& commands);

/// Script for zsh that completes as `bash_completion` does and shows descriptions.
std::string zsh_completion(const std::vector<DeclaredCommand>& commands);

/// Script for fish that completes as `bash_completion` does and shows descriptions.
std::string fish_completion(const std::vector<DeclaredCommand>& commands);

}  // namespace pendular::app
