#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <filesystem>
#include <functional>
#include <nlohmann/json.hpp>
#include <optional>

#include "app/command.h"
#include "app/console.h"
#include "app/options.h"
#include "app/stored_runs.h"
#include "app/terminal.h"
#include "data/input_error.h"
#include "reports/run_report.h"
#include "sim/runs/campaign.h"
#include "sim/runs/mpi_ensemble.h"
#include "sim/runs/store/run_table.h"
#include "workflow/fit_study.h"
#include "workflow/json/commands.h"

namespace pendular::app {
namespace {

/// Share and number of shares, parsed from a text such as "2/8", the second of eight shares.
/// @throws InputError for any other text
std::pair<int, int> share_from(const std::string& text) {
    int share = 0, shares = 0;
    const char* const end = text.data() + text.size();
    const auto [slash, fault] = std::from_chars(text.data(), end, share);
    const bool has_both = fault == std::errc{} && slash != end && *slash == '/';
    const auto [read, second_fault] = std::from_chars(has_both ? slash + 1 : end, end, shares);
    if (second_fault != std::errc{} || read != end || share < 1 || shares < share) {
        throw InputError(fmt::format("--shard {}: write i/n with i from 1 to n, 2/8 say", text));
    }
    return {share, shares};
}

/// Runs of a campaign that are missing from a store, and stored runs that failed.
struct Survey {
    std::vector<dem::RunParameters> missing;
    std::vector<dem::RunResult> failed;
};

Survey survey(const std::vector<dem::RunParameters>& runs, const RunStore& store) {
    Survey found;
    for (const auto& run : runs) {
        auto stored = store.find(run);
        if (!stored) {
            found.missing.push_back(run);
        } else if (!stored->failure.empty()) {
            found.failed.push_back(std::move(*stored));
        }
    }
    return found;
}

/// Does work in one of several MPI processes; ends all processes where the work fails, since the
/// others would wait for this process.
void or_abort(const MpiProcesses& processes, const std::function<void()>& work) {
    try {
        work();
    } catch (const std::exception&) {
        processes.abort(report_exception());
    }
}

/// Estimates the duration [s] of the missing runs, from the speed of the runs in the store, else of
/// the runs in the atlas; empty where neither has a run.
/// @param source receives what the estimate follows from
std::optional<double> estimate_duration(const Survey& found, const RunStore& store, int threads,
                                        std::string& source) {
    if (found.missing.empty()) {
        return 0;
    }
    const auto runs_of = [](std::vector<StoredRun> stored) {
        std::vector<dem::RunResult> runs;
        for (StoredRun& each : stored) {
            runs.push_back(std::move(each.run));
        }
        return runs;
    };
    std::vector<dem::RunResult> measured = runs_of(store.select());
    source = fmt::format("the speed of the {} simulations in the store", measured.size());
    auto seconds = expected_seconds(found.missing, measured, threads);
    if (const auto atlas = atlas_file(); !seconds && !atlas.empty()) {
        seconds = expected_seconds(found.missing, runs_of(read_runs(atlas)), threads);
        source = "the speed of the simulations in the atlas, which were made on another machine";
    }
    return seconds;
}

/// Prints how many runs a campaign would simulate and how long they would take; creates no store.
void report_plan(const std::vector<dem::RunParameters>& runs, const CommonOptions& common,
                 Console& console) {
    const bool there = std::filesystem::exists(common.store);
    const RunStore store(there ? common.store : std::filesystem::path(RunStore::in_memory), there);
    const Survey found = survey(runs, store);
    std::string source;
    const CampaignState state{.runs = runs.size(),
                              .stored = runs.size() - found.missing.size(),
                              .failed = found.failed.size(),
                              .store = common.store,
                              .seconds = estimate_duration(found, store, common.threads, source)};
    console.print(plan_output(state, common.threads, source));
    console.json(to_json(state));
}

void report_campaign(std::size_t runs, const Survey& before, const Survey& after,
                     const RunStore& store, Console& console) {
    const CampaignState state{.runs = runs,
                              .stored = runs - after.missing.size(),
                              .made = before.missing.size() - after.missing.size(),
                              .failed = after.failed.size(),
                              .store = store.file()};
    console.print(campaign_output(state, after.failed));
    console.json(to_json(state));
}

/// Makes the runs of a campaign that the store lacks, and reports them.
/// @param processes null: this process makes all of them
void simulate_missing(const std::vector<dem::RunParameters>& runs, MpiProcesses* processes,
                      const std::stop_token& stop, const CommonOptions& common, Console& console) {
    RunStore store(common.store);
    const Survey before = survey(runs, store);
    const Workers workers{
        .threads = common.threads,
        .stop = stop,
        .report = [&](const EnsembleProgress& p) { console.progress("Campaign", p); },
        .store = &store};
    try {
        if (processes && processes->workers() > 0) {
            processes->manage(before.missing, workers);
        } else {
            run_all(before.missing, workers);
        }
    } catch (const dem::Interrupted&) {
        console.end_progress();
        throw interrupted_with(&store);
    }
    console.end_progress();
    store.demand_present();
    report_campaign(runs.size(), before, survey(runs, store), store, console);
}

const char* const about_campaign =
    R"(Runs the simulations that a campaign file lists (grids, lists, Sobol sequences), the longest first,
and keeps each result in the store as soon as the simulation ends. The same command resumes a
stopped campaign: simulations that are in the store are not repeated, and those that were running go
on where they were. Tables that do not state beads, stiffness_number, strain or inertial_number take
them from --fidelity.)";

}  // namespace

int campaign(const std::vector<std::string>& arguments) {
    Options options(
        "campaign FILE [options]", about_campaign,
        "  pendular campaign sim/atlas/campaign.toml\n"
        "  mpirun -n 9 pendular campaign my.toml        # 1 process distributes, 8 simulate\n"
        "  pendular campaign my.toml --shard 2/8 --store part-2.sqlite   # machine 2 of 8\n"
        "  pendular runs merge part-*.sqlite                             # merge the results\n"
        "  pendular campaign my.toml --dry-run\n",
        true);
    options.set_first_word("FILE (the file that lists the simulations)");
    options.leave_out({"out"});
    options.set_fidelity(
        "settings of the tables that do not state them: beads, stiffness_number, strain, and the "
        "lowest inertial number in place of inertial_number");
    std::string shard;
    options.add("shard", &shard,
                "i/n: make only share i of n shares of equal computing time, for n machines or the "
                "tasks of a Slurm array");
    bool dry_run = false;
    options.add_switch("dry-run", &dry_run,
                       "print how many simulations remain and how long they would take; make none");
    const auto common = options.parse(arguments);
    if (!common) {
        return done;
    }
    const InterruptGuard guard;
    Console console(*common);
    auto runs = read_campaign(common->study, common->fidelity);
    if (!shard.empty()) {
        const auto [share, shares] = share_from(shard);
        runs = share_of(runs, share, shares);
    }
    if (dry_run) {
        report_plan(runs, *common, console);
        return done;
    }
    std::optional<MpiProcesses> processes;
    if (MpiProcesses::there()) {
        processes.emplace();
        if (!processes->manager()) {
            or_abort(*processes, [&] { processes->work(guard.token(), common->store); });
            return done;
        }
    }
    const auto work = [&] {
        simulate_missing(runs, processes ? &*processes : nullptr, guard.token(), *common, console);
    };
    if (processes) {
        or_abort(*processes, work);
    } else {
        work();
    }
    return done;
}

}  // namespace pendular::app
