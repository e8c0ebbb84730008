#pragma once

#include <string>
#include <vector>

#include "app/declaration.h"

namespace pendular::app {

/// Command of the program with its texts and options, for its manual page and its completion.
struct DeclaredCommand {
    std::string name, summary;
    const char* heading;  ///< of the group of commands
    CommandDeclaration declaration;

    /// Returns all options of the command, those that every command has last.
    std::vector<OptionDeclaration> options() const;
};

/// Returns all commands of the program, in the order of its help text.
std::vector<DeclaredCommand> declared_commands();

}  // namespace pendular::app
