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

/// Returns a script for bash that completes the names of commands and options, and the values of
/// options: accepted words, files, folders or studies.
std::string bash_completion(const std::vector<DeclaredCommand>& commands);

/// Returns such a script for zsh, which also shows descriptions.
std::string zsh_completion(const std::vector<DeclaredCommand>& commands);

/// Returns such a script for fish, which also shows descriptions.
std::string fish_completion(const std::vector<DeclaredCommand>& commands);

/// Date and version that the first line of a manual page states.
struct ManHeading {
    std::string date;  ///< year-month-day
    std::string version;
};

/// Returns the manual page of the program, pendular(1), in roff: commands by group, commands of a
/// first session, and exit codes.
std::string man_page_of_program(const std::vector<DeclaredCommand>& commands,
                                const ManHeading& heading);

/// Returns the manual page of one command, pendular-COMMAND(1), in roff: the texts of its help and
/// the exit codes.
std::string man_page_of(const DeclaredCommand& command, const ManHeading& heading);

}  // namespace pendular::app
