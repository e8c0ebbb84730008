#include "bench/hidden_effects/foreign_world.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>

#include "bench/hidden_effects/judgement.h"
#include "data/files/write_whole.h"
#include "data/quantities/statistics.h"

namespace pendular::bench {
namespace {

/// Studies of one world that state an error of the model, or none.
struct Series {
    const ForeignWorld* world;
    Truth truth;  ///< the world's, by the name that tables show
    std::array<double, 2> discrepancy;
};

std::vector<Series> all_series(const std::vector<ForeignWorld>& worlds,
                               const ForeignStudiesOptions& options) {
    std::vector<Series> all;
    for (const ForeignWorld& world : worlds) {
        if (!options.only.empty() && std::ranges::none_of(options.only, [&](const auto& name) {
                return world.truth.name.starts_with(name);
            })) {
            continue;
        }
        all.push_back({&world, world.truth, {0, 0}});
        all.push_back({&world, world.truth, options.discrepancy});
        all.back().truth.name += ": error stated";
    }
    return all;
}

/// Whether the verdict is what it ought to be: no alarm, the effect, or that it is unknown.
bool as_wanted(const LabStudy& s) {
    switch (s.truth->kind) {
        case Truth::Kind::complete:
            return !alarms(s);
        case Truth::Kind::outside:
            return flagged(s);
        default:
            return right(s);
    }
}

std::string table_of(const std::vector<Series>& all, const Studies& studies) {
    std::string text =
        fmt::format("{:<38} {:>7} {:>7} {:>6} {:>10} {:>6} {:>7} {:>13}\n", "world", "studies",
                    "alarms", "right", "undecided", "wrong", "in set", "median chi2/dof");
    for (const Series& series : all) {
        Studies here;
        std::ranges::copy_if(studies, std::back_inserter(here),
                             [&](const LabStudy& s) { return s.truth == &series.truth; });
        if (here.empty()) continue;
        const auto count = [&](const auto& test) { return std::ranges::count_if(here, test); };
        const auto wanted = count(as_wanted), wrong = count(confidently_wrong);
        std::vector<double> misfits;
        for (const LabStudy& s : here) {
            misfits.push_back(s.outcome->chi2 / s.outcome->dof);
        }
        text += fmt::format(
            "{:<38} {:>7} {:>7} {:>6} {:>10} {:>6} {:>7} {:>13.3g}\n", series.truth.name,
            here.size(), count(alarms), wanted, std::ssize(here) - wanted - wrong, wrong,
            count([](const LabStudy& s) { return s.outcome->set_has_truth; }), median(misfits));
    }
    return text;
}

void write_results(const std::vector<Series>& all, const std::vector<Outcome>& outcomes,
                   const ForeignStudiesOptions& options) {
    Studies studies;
    std::vector<std::string> names;
    for (const Series& series : all) {
        names.push_back(series.truth.name);
        for (const Outcome& outcome : outcomes) {
            if (outcome.truth == series.truth.name) studies.push_back({&series.truth, &outcome});
        }
    }
    write_confusion(options.results / "foreign_worlds_confusion.csv", names, studies);
    write_outcomes(options.results / "foreign_worlds_studies.csv", outcomes);
    const std::string text = fmt::format(
        "pendular-bench foreign-worlds, pendular {}: studies of grains that LAMMPS simulated\n"
        "right: no alarm where nothing is missing, the effect named alone where one is, unknown "
        "or\n"
        "suspect-measurement where the catalogue has no such effect; wrong: another effect named, "
        "or\n"
        "nothing-missing. Studies of one world share its simulations. Error stated: "
        "[model] discrepancy\n= [{:g}, {:g}]\n\n{}",
        PENDULAR_VERSION, options.discrepancy[0], options.discrepancy[1], table_of(all, studies));
    write_whole(options.results / "foreign_worlds.txt", text);
    fmt::print("{}", text);
}

}  // namespace

void foreign_studies(const ForeignStudiesOptions& options) {
    const std::vector<ForeignWorld> worlds = read_foreign_worlds(options.states);
    const std::vector<Series> all = all_series(worlds, options);
    const std::filesystem::path file = options.work / "outcomes.csv";
    std::filesystem::create_directories(options.work);
    std::vector<Outcome> outcomes = read_outcomes(file);
    for (int study = 0; study < options.studies; ++study) {
        for (const Series& series : all) {
            if (std::ranges::any_of(outcomes, [&](const Outcome& outcome) {
                    return outcome.truth == series.truth.name && outcome.study == study;
                })) {
                continue;
            }
            Outcome outcome = walk(series.world->truth, series.world->laboratory, study,
                                   options.work / "study", series.discrepancy);
            outcome.truth = series.truth.name;
            fmt::print(stderr, "{}, study {}: {} {} ({:.1f} s)\n", outcome.truth, study,
                       outcome.verdict, fmt::join(outcome.named, ", "), outcome.seconds);
            outcomes.push_back(std::move(outcome));
            write_outcomes(file, outcomes);
        }
    }
    write_results(all, outcomes, options);
}

}  // namespace pendular::bench
