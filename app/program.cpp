#include <fmt/format.h>

#include <array>
#include <cstdio>
#include <exception>
#include <string>

#include "app/command.h"
#include "data/input_error.h"
#include "data/quantities/nearest.h"
#include "sim/dem/run.h"

namespace pendular::app {
namespace {

constexpr std::array<Command, 13> commands = {{
    {"import", "recordings to readings: stresses and solid fractions with their errors", import},
    {"simulate", "one discrete-element run of steady shear and its observables", simulate},
    {"predict", "what known runs say of any state, at once, with errors; curves", predict},
    {"calibrate", "fit the intergranular friction to dry readings, predict the wet ones",
     calibrate},
    {"compare", "model beside measurement: misfit by observable and condition, figures", compare},
    {"diagnose", "which physical effect is missing, if any, and how sure that is", diagnose},
    {"next", "the measurement that would tell most: rivals apart, parameters sharper", next},
    {"add", "an effect into a study: fitted, with the error before and after", add},
    {"drop", "an effect out of a study: fitted, with the error before and after", drop},
    {"effects", "what a model may lack: the catalogue of effects, one entry whole", effects},
    {"virtual-lab", "a study as an instrument with a hidden truth would have recorded it",
     virtual_lab},
    {"campaign", "many runs into the store: grids, lists, Sobol fillings; resumable", campaign},
    {"runs", "the stored runs: list, show, compare, plot, export, import, merge, prune, learn",
     runs},
}};

void print_overview() {
    fmt::print(
        "pendular puts rheometer recordings of beads beside a discrete-element model.\n\n"
        "Usage: pendular COMMAND [options]\n\nCommands:\n");
    for (const auto& command : commands) {
        fmt::print("  {:<11} {}\n", command.name, command.summary);
    }
    fmt::print(
        "\n'pendular COMMAND --help' describes one, with examples.\n"
        "Exit codes: 0 done; 1 the program failed; 2 the input or the command line is wrong; "
        "3 the fit did not converge or is meaningless; 130 interrupted.\n");
}

const Command& command_named(const std::string& name) {
    std::vector<std::string> names;
    for (const auto& command : commands) {
        if (command.name == name) {
            return command;
        }
        names.emplace_back(command.name);
    }
    throw InputError(fmt::format("unknown command '{}'; {}", name, did_you_mean(name, names)));
}

}  // namespace

namespace {

int run_command(const std::vector<std::string>& arguments) {
    try {
        if (arguments.empty() || arguments[0] == "--help" || arguments[0] == "-h" ||
            arguments[0] == "help") {
            print_overview();
            return arguments.empty() ? wrong_input : done;
        }
        if (arguments[0] == "--version") {
            fmt::print("pendular {}\n", PENDULAR_VERSION);
            return done;
        }
        return command_named(arguments[0]).run({arguments.begin() + 1, arguments.end()});
    } catch (const InputError& error) {
        fmt::print(stderr, "error: {}\n", error.what());
        return wrong_input;
    } catch (const dem::Interrupted& interruption) {
        fmt::print(stderr, "\n{}\n", interruption.what());
        return interrupted;
    } catch (const std::exception& error) {
        fmt::print(stderr, "pendular failed: {}\n", error.what());
        return program_failed;
    }
}

}  // namespace

int run_program(const std::vector<std::string>& arguments) {
    const int code = run_command(arguments);
    if (std::fflush(stdout) != 0 || std::ferror(stdout) != 0) {
        fmt::print(stderr, "pendular failed: standard output cannot be written\n");
        return program_failed;
    }
    return code;
}

}  // namespace pendular::app
