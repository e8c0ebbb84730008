#pragma once

#include <string>
#include <vector>

#include "app/manual/commands.h"

namespace pendular::app {

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
