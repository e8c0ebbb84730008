// `pendular-bench`: long benchmarks of the whole program.
#include <fmt/format.h>

#include <algorithm>
#include <boost/program_options.hpp>
#include <iostream>
#include <string>
#include <vector>

#include "bench/hidden_effects/foreign_world.h"
#include "bench/hidden_effects/hidden_effects.h"
#include "bench/hidden_effects/inexact_worlds.h"
#include "bench/hidden_effects/outside_shapes.h"
#include "data/input_error.h"
#include "sim/dem/simulation_error.h"

namespace po = boost::program_options;
using namespace pendular;

namespace {

const char* const about =
    R"(pendular-bench hidden-effects [options]

Hides every effect in simulated laboratories, at several sizes, lets the program find it, and writes
what came of it: hidden_effects.txt (what was found, and how often it was right), a row for each
study and figures. Truths are simulated with other seeds, beads and set points than any run that the
program knows. Simulations and finished studies stay in the work folder: the same command goes on
where it was stopped.

pendular-bench foreign-worlds [--studies N] [--only WORLD,...] [--results FOLDER] [--work FOLDER]

Diagnoses studies of grains that LAMMPS simulated (bench/foreign_worlds/states.csv), and writes
foreign_worlds.txt and a row for each study.

pendular-bench outside-shapes [--studies N] [--only TRUTH,...] [--results FOLDER] [--work FOLDER]

Hides effects that the program does not know, and writes outside_shapes.txt: whether they are
flagged, and whether the shape that is proposed for the missing change is right; and a row for each
study. --truths: those of outside_truths.csv, written without sight of the shapes; --plan chooses
their sizes anew.

pendular-bench inexact-worlds [--studies N] [--only WORLD,...] [--hidden TRUTH,...] ...

Diagnoses studies of grains that the model describes less than exactly, with errors that differ from
condition to condition, vary smoothly, or are those of LAMMPS' states, with and without a hidden
effect, and writes inexact_worlds.txt.

Examples:
  pendular-bench hidden-effects
  pendular-bench hidden-effects --only lid-slip --studies 2 --results /tmp
  pendular-bench outside-shapes --only swelling --studies 1 --results /tmp
  pendular-bench inexact-worlds --only independent --hidden complete --results /tmp
  pendular-bench foreign-worlds --only "dry rolling" --studies 2 --results /tmp

)";

std::vector<std::string> separated(const std::string& names) {
    std::vector<std::string> all;
    for (std::size_t at = 0; at < names.size();) {
        const std::size_t end = std::min(names.find(',', at), names.size());
        all.push_back(names.substr(at, end - at));
        at = end + 1;
    }
    return all;
}

void run_foreign_studies(const po::variables_map& given) {
    bench::ForeignStudiesOptions options;
    if (!given["work"].defaulted()) options.work = given["work"].as<std::string>();
    if (!given["studies"].defaulted()) options.studies = given["studies"].as<int>();
    if (given.contains("only")) options.only = separated(given["only"].as<std::string>());
    options.results = given["results"].as<std::string>();
    bench::foreign_studies(options);
}

void run_outside_shapes(const po::variables_map& given) {
    bench::OutsideShapesOptions options;
    if (!given["work"].defaulted()) options.work = given["work"].as<std::string>();
    if (!given["truths"].defaulted()) options.more_truths = given["truths"].as<std::string>();
    if (!given["studies"].defaulted()) options.studies = given["studies"].as<int>();
    if (given.contains("only")) options.only = separated(given["only"].as<std::string>());
    options.results = given["results"].as<std::string>();
    options.threads = given["threads"].as<int>();
    options.plan = given.contains("plan");
    options.diagnose = !given.contains("simulate-only");
    bench::outside_shapes(options);
}

void run_inexact_worlds(const po::variables_map& given) {
    bench::InexactWorldsOptions options;
    if (!given["work"].defaulted()) options.work = given["work"].as<std::string>();
    if (!given["studies"].defaulted()) options.studies = given["studies"].as<int>();
    if (!given["complete-studies"].defaulted())
        options.complete_studies = given["complete-studies"].as<int>();
    if (given.contains("only")) options.only = separated(given["only"].as<std::string>());
    if (given.contains("hidden")) options.hidden = separated(given["hidden"].as<std::string>());
    options.results = given["results"].as<std::string>();
    options.threads = given["threads"].as<int>();
    bench::inexact_worlds(options);
}

int run(int count, char** words) {
    bench::HiddenEffectsOptions options;
    std::string command, work, truths, results, only, kinds;
    po::options_description shown("Options", 100);
    shown.add_options()("help", "this text")("work",
                                             po::value(&work)->default_value(options.work.string()),
                                             "folder of simulations and finished studies")(
        "truths", po::value(&truths)->default_value(options.truths.string()),
        "what is hidden, a row each")("results",
                                      po::value(&results)->default_value(options.results.string()),
                                      "folder to write to")(
        "only", po::value(&only), "beginnings of the names of some truths, separated by commas")(
        "hidden", po::value(&kinds), "likewise, of the truths of inexact-worlds")(
        "studies", po::value(&options.studies)->default_value(options.studies),
        "recordings, with noise of their own, of each truth")(
        "worlds", po::value(&options.worlds)->default_value(options.worlds),
        "in which each truth is simulated, one to two minutes each; the complete model has ten")(
        "complete-studies",
        po::value(&options.complete_studies)->default_value(options.complete_studies),
        "likewise of the complete model")(
        "resolved-studies",
        po::value(&options.resolved_studies)->default_value(options.resolved_studies),
        "studies of each truth on which measurements go on, where effects cannot be told apart")(
        "threads", po::value(&options.threads)->default_value(2), "runs or studies side by side")(
        "plan", "choose the truths anew, which makes old simulations useless")(
        "simulate-only", "make simulations, diagnose nothing");
    po::options_description hidden;
    hidden.add_options()("command", po::value(&command));
    po::options_description all;
    all.add(shown).add(hidden);
    po::positional_options_description place;
    place.add("command", 1);
    po::variables_map given;
    po::store(po::command_line_parser(count, words).options(all).positional(place).run(), given);
    po::notify(given);
    if (given.contains("help") || command.empty()) {
        std::cout << about << shown;
        return command.empty() && !given.contains("help") ? 2 : 0;
    }
    if (command == "foreign-worlds") {
        run_foreign_studies(given);
        return 0;
    }
    if (command == "inexact-worlds") {
        run_inexact_worlds(given);
        return 0;
    }
    if (command == "outside-shapes") {
        run_outside_shapes(given);
        return 0;
    }
    if (command != "hidden-effects") {
        throw InputError(fmt::format(
            "unknown benchmark '{}'; there are hidden-effects, foreign-worlds, inexact-worlds and "
            "outside-shapes",
            command));
    }
    options.work = work, options.truths = truths, options.results = results;
    options.only = separated(only);
    options.plan = given.contains("plan");
    options.diagnose = !given.contains("simulate-only");
    bench::hidden_effects(options);
    return 0;
}

}  // namespace

int main(int count, char** words) {
    try {
        return run(count, words);
    } catch (const dem::Interrupted&) {
        std::cerr << "interrupted; the same command goes on from there\n";
        return 130;
    } catch (const std::exception& error) {
        std::cerr << "error: " << error.what() << '\n';
        return 2;
    }
}
