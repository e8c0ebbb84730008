#include <fmt/format.h>
#include <glog/logging.h>

#include <csignal>
#include <cstdio>
#include <exception>
#include <string>
#include <vector>

#include "app/command.h"
#include "app/terminal.h"
#include "app/version.h"
#include "data/input_error.h"

namespace pendular::app {
namespace {

const std::vector<CommandGroup> groups = {
    {"Measure and calibrate",
     {{"import", "turn recordings into readings: shear stress and solid fraction with their errors",
       import},
      {"calibrate", "fit the friction coefficient to the dry readings, predict the wet readings",
       calibrate},
      {"compare", "show where the model misses the readings, with figures", compare},
      {"report", "write one HTML page on a study, with switches for effects and sliders", report},
      {"serve", "show the report in the browser and update it as recordings arrive", serve}}},
    {"Find the missing physical effect",
     {{"diagnose", "test which physical effect is missing from the model", diagnose},
      {"next", "plan the most informative next measurement", next},
      {"add", "add an effect to the model, refit it, show the misfit before and after", add},
      {"drop", "remove an effect from the model, refit it, show the misfit before and after", drop},
      {"effects", "list the effects in the catalogue, or describe one", effects}}},
    {"Simulate",
     {{"predict", "predict steady shear from stored simulations, without a new one", predict},
      {"simulate", "simulate one sheared sample by the discrete-element method", simulate},
      {"campaign", "make many simulations; resumable, also on a cluster", campaign},
      {"runs", "list, compare, plot, export, import, merge and prune stored simulations", runs},
      {"virtual-lab", "make test recordings with hidden effects that you choose", virtual_lab},
      {"reproduce", "compare the simulations with the numbers of Badetti et al. (2018)",
       reproduce}}}};

void print_overview() {
    fmt::print("{}\nUsage: pendular COMMAND [options]\n", program_texts.about);
    for (const CommandGroup& group : groups) {
        fmt::print("\n{}\n", group.heading);
        for (const Command& command : group.commands) {
            fmt::print("  {:<11} {}\n", command.name, command.summary);
        }
    }
    fmt::print(

        "\nA study is a folder with a file study.toml. A first session:\n{}"
        "\n'pendular COMMAND --help' describes one command, with examples.\n"
        "Exit codes: {}",
        program_texts.session, program_texts.exit_codes);
}

const Command& command_named(const std::string& name) {
    std::vector<std::string> names;
    for (const CommandGroup& group : groups) {
        for (const Command& command : group.commands) {
            if (command.name == name) return command;
            names.emplace_back(command.name);
        }
    }
    throw InputError(fmt::format("unknown command '{}'; {}", name, did_you_mean(name, names)));
}

}  // namespace

const std::vector<CommandGroup>& command_groups() {
    return groups;
}

const ProgramTexts program_texts = {
    .about =
        "Pendular fits a discrete-element model to rheometer recordings of dry or wet beads and\n"
        "finds the physical effect that the model lacks.\n",
    .session =
        "  pendular import my-study\n"
        "  pendular calibrate my-study --no-confirm\n"
        "  pendular diagnose my-study\n",
    .exit_codes =
        "0 done; 1 the program failed; 2 the input or the command line is wrong;\n"
        "3 no usable fit: it did not converge; or the friction coefficient is at its bound and\n"
        "the model does not describe the readings; or more readings were excluded than kept;\n"
        "130 interrupted.\n"};

namespace {

int run_command(const std::vector<std::string>& arguments) {
    try {
        if (arguments.empty() || arguments[0] == "--help" || arguments[0] == "-h" ||
            arguments[0] == "help") {
            print_overview();
            return arguments.empty() ? wrong_input : done;
        }
        if (arguments[0] == "--version") {
            fmt::print("{}", version_text());
            return done;
        }
        return command_named(arguments[0]).run({arguments.begin() + 1, arguments.end()});
    } catch (const std::exception&) {
        return report_exception();
    }
}

}  // namespace

int run_program(const std::vector<std::string>& arguments) {
    // Ceres logs problems inside a fit; the user is to read only the messages of commands.
    FLAGS_minloglevel = google::GLOG_FATAL;
    // A reader that has seen enough, such as 'head', must not end the program before its files are
    // written.
    std::signal(SIGPIPE, SIG_IGN);
    const int code = run_command(arguments);
    if (reader_has_left()) return code;
    if (std::fflush(stdout) != 0 || std::ferror(stdout) != 0) {
        print_error("pendular failed: ", "standard output cannot be written");
        return program_failed;
    }
    return code;
}

}  // namespace pendular::app
