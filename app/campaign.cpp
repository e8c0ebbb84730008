#include <fmt/format.h>

#include <algorithm>
#include <functional>
#include <nlohmann/json.hpp>
#include <optional>

#include "app/command.h"
#include "app/console.h"
#include "app/interrupt.h"
#include "app/options.h"
#include "data/input_error.h"
#include "sim/campaign.h"
#include "sim/mpi_ensemble.h"
#include "sim/store/run_store.h"

namespace pendular::app {
namespace {

/// "2/8": the second of eight shares.
std::pair<int, int> share_from(const std::string& text) {
    int share = 0, shares = 0, read = 0;
    if (std::sscanf(text.c_str(), "%d/%d%n", &share, &shares, &read) != 2 ||
        static_cast<std::size_t>(read) != text.size() || share < 1 || shares < share) {
        throw InputError(fmt::format("--shard {}: write i/n with i from 1 to n, 2/8 say", text));
    }
    return {share, shares};
}

std::size_t stored_among(const RunStore& store, const std::vector<dem::RunParameters>& runs) {
    return static_cast<std::size_t>(std::ranges::count_if(
        runs, [&](const dem::RunParameters& run) { return store.find(run).has_value(); }));
}

/// Ends all processes where this one fails, since the others would wait for it.
void or_abort(const MpiProcesses& processes, const std::function<void()>& work) {
    try {
        work();
    } catch (const InputError& error) {
        fmt::print(stderr, "error: {}\n", error.what());
        processes.abort(wrong_input);
    } catch (const dem::Interrupted& interruption) {
        fmt::print(stderr, "\n{}\n", interruption.what());
        processes.abort(interrupted);
    } catch (const std::exception& error) {
        fmt::print(stderr, "pendular failed: {}\n", error.what());
        processes.abort(program_failed);
    }
}

void report(const std::vector<dem::RunParameters>& runs, const RunStore& store, std::size_t before,
            Console& console) {
    std::size_t stored = 0, failed = 0;
    for (const auto& run : runs) {
        const auto found = store.find(run);
        stored += found.has_value();
        if (found && !found->failure.empty()) {
            ++failed;
            console.note(fmt::format("friction {}, inertial number {}, seed {} failed: {}",
                                     run.friction, run.inertial_number, run.seed, found->failure));
        }
    }
    console.line(fmt::format("{} of {} runs are in {}: {} new, {} failed", stored, runs.size(),
                             store.file().string(), stored - before, failed));
    console.json({{"runs", runs.size()},
                  {"stored", stored},
                  {"new", stored - before},
                  {"failed", failed},
                  {"store", store.file().string()}});
}

}  // namespace

int campaign(const std::vector<std::string>& arguments) {
    Options options(
        "campaign FILE [options]",
        "Carries out the runs of a campaign file (grids, lists, Sobol fillings), the longest "
        "first, and keeps\n"
        "each in the store as it ends. The same command goes on where an earlier one was stopped; "
        "runs that\n"
        "are in the store are not repeated.",
        "  pendular campaign sim/atlas/campaign.toml\n"
        "  mpirun -n 9 pendular campaign my.toml        # one manages, eight work\n"
        "  pendular campaign my.toml --shard 2/8 --store part-2.sqlite   # one of eight machines\n"
        "  pendular runs merge part-*.sqlite                             # then, together again\n"
        "  pendular campaign my.toml --dry-run\n",
        true);
    options.set_out("not used by this command");
    std::string shard;
    options.add("shard", &shard, "i/n: only the i-th of n shares of equal cost (a Slurm array)");
    bool dry_run = false;
    options.add_switch("dry-run", &dry_run, "only say what there is to do");
    const auto common = options.parse(arguments);
    if (!common) {
        return done;
    }
    const InterruptGuard guard;
    Console console(*common);
    auto runs = read_campaign(common->study);
    if (!shard.empty()) {
        const auto [share, shares] = share_from(shard);
        runs = share_of(runs, share, shares);
    }
    std::optional<MpiProcesses> processes;
    if (MpiProcesses::there() && !dry_run) {
        processes.emplace();
        if (!processes->manager()) {
            or_abort(*processes, [&] { processes->work(guard.token()); });
            return done;
        }
    }
    const auto carry_out = [&] {
        RunStore store(common->store);
        const std::size_t before = stored_among(store, runs);
        const Workers workers{
            .threads = common->threads,
            .stop = guard.token(),
            .report = [&](const EnsembleProgress& p) { console.progress("campaign", p); },
            .store = &store};
        try {
            if (processes && processes->workers() > 0) {
                processes->manage(runs, workers);
            } else if (!dry_run) {
                run_all(runs, workers);
            }
        } catch (const dem::Interrupted&) {
            console.end_progress();
            throw interrupted_with(store);
        }
        console.end_progress();
        report(runs, store, before, console);
    };
    if (processes) {
        or_abort(*processes, carry_out);
    } else {
        carry_out();
    }
    return done;
}

}  // namespace pendular::app
