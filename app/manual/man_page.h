#pragma once

#include <string>
#include <vector>

#include "app/manual/commands.h"

namespace pendular::app {

/// Date and version that the first line of a manual page states.
struct ManHeading {
    /// Date of the manual page, as year-month-day.
    std::string date;
    /// Version of the program that the manual page describes.
    std::string version;
};

/// Returns the manual page of the program, pendular(1), in roff: commands by group, commands of a
/// first session, and exit codes.
std::string man_page_of_program(const std::vector<DeclaredCommand>& commands,
                                const ManHeading& heading);

/// Returns the manual page of one command, pendular-COMMAND(1), in roff, with the texts of the
/// command's help (usage, description, options and examples) and the exit codes.
std::string man_page_of(const DeclaredCommand& command, const ManHeading& heading);

}  // namespace pendular::app
