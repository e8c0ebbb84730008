#pragma once

#include <filesystem>
#include <nlohmann/json_fwd.hpp>
#include <string>
#include <string_view>
#include <vector>

#include "sim/runs/ensemble.h"
#include "sim/runs/run_settings.h"

namespace pendular::app {

/// Subcommand of the program `pendular`, such as `calibrate`.
struct Command {
    std::string_view name;
    std::string_view summary;  ///< for the help text
    /// Runs the command with the words after its name, and returns an `ExitCode`. Throws InputError
    /// for wrong input.
    int (*run)(const std::vector<std::string>& arguments);
};

// Functions of the commands. Each function receives the words after the command's name, returns the
// exit code of the program, and throws InputError for wrong input.

int import(const std::vector<std::string>& arguments);
int simulate(const std::vector<std::string>& arguments);
int predict(const std::vector<std::string>& arguments);
int reproduce(const std::vector<std::string>& arguments);
int calibrate(const std::vector<std::string>& arguments);
int compare(const std::vector<std::string>& arguments);
int diagnose(const std::vector<std::string>& arguments);
int next(const std::vector<std::string>& arguments);
int report(const std::vector<std::string>& arguments);
int serve(const std::vector<std::string>& arguments);
int add(const std::vector<std::string>& arguments);
int drop(const std::vector<std::string>& arguments);
int effects(const std::vector<std::string>& arguments);
int campaign(const std::vector<std::string>& arguments);
int runs(const std::vector<std::string>& arguments);
int virtual_lab(const std::vector<std::string>& arguments);

/// Group of commands for one purpose, such as simulation, in the order of their use.
struct CommandGroup {
    const char* heading;
    std::vector<Command> commands;
};

/// Returns all commands of the program in groups, in the order of the help text of `pendular`.
const std::vector<CommandGroup>& command_groups();

/// Texts on the program as a whole, for its help text and its manual page, with line ends.
struct ProgramTexts {
    const char* about;
    const char* session;  ///< commands of a first session
    const char* exit_codes;
};
extern const ProgramTexts program_texts;

/// Exit codes of the program `pendular`, equal for all its commands. `not_converged`: the fit did
/// not converge, or the fitted parameters are meaningless, such as a friction coefficient at the
/// end of its range (`Belief::meaningless`). `interrupted`: a signal such as Ctrl-C stopped the
/// command.
enum ExitCode {
    done = 0,
    program_failed = 1,
    wrong_input = 2,
    not_converged = 3,
    interrupted = 130
};

/// Runs the program with the arguments of the command line, the command's name first, and returns
/// the exit code. Prints the text of exceptions on standard error. Throws no std::exception.
int run_program(const std::vector<std::string>& arguments);

}  // namespace pendular::app
