#pragma once

#include <string>
#include <vector>

#include "app/declaration.h"

namespace pendular::app {

/// A command of the program with all that its manual page and its completion show.
struct DeclaredCommand {
    std::string name, summary;
    const char* heading;  ///< of the group of commands that it belongs to
    CommandDeclaration declaration;

    /// All its options, those that every command has last.
    std::vector<OptionDeclaration> options() const;
};

/// All commands of the program, in the order of the program's overview.
std::vector<DeclaredCommand> declared_commands();

}  // namespace pendular::app
