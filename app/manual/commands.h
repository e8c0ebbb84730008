#pragma once

#include <string>
#include <vector>

#include "app/declaration.h"

namespace pendular::app {

/// Command of the program with the texts and options that its manual page and its completion in a
/// shell show.
struct DeclaredCommand {
    std::string name, summary;
    const char* heading;  ///< heading of the group to which the command belongs
    CommandDeclaration declaration;

    /// Returns all options of the command. The options that every command has come last.
    std::vector<OptionDeclaration> options() const;
};

/// Returns all commands of the program, in the order of its help text.
std::vector<DeclaredCommand> declared_commands();

}  // namespace pendular::app
