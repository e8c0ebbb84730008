#include "bench/hidden_effects/hidden_effects.h"

#include <fmt/format.h>

#include <algorithm>
#include <atomic>
#include <functional>
#include <future>
#include <map>
#include <mutex>
#include <tuple>

#include "app/terminal.h"
#include "bench/hidden_effects/report.h"
#include "bench/hidden_effects/resolve.h"
#include "bench/hidden_effects/rig.h"
#include "bench/hidden_effects/walk.h"
#include "reports/words.h"
#include "sim/runs/store/run_store.h"
#include "sim/runs/store/run_table.h"

namespace pendular::bench {
namespace {

/// Simulated worlds, which differ in their seeds. The complete model is simulated in all of them.
constexpr int all_worlds = 10;

class Benchmark {
  public:
    explicit Benchmark(const HiddenEffectsOptions& options)
        : options_(options),
          store_(options.work / "truths.sqlite"),
          outcomes_file_(options.work / "outcomes.csv"),
          outcomes_(read_outcomes(outcomes_file_)),
          resolutions_file_(options.work / "resolutions.csv"),
          resolutions_(read_resolutions(resolutions_file_)) {
        if (options.plan) write_truths(options.truths, planned_truths({10, 25, 60}));
        truths_ = read_truths(options.truths);
        if (store_.size() == 0 && std::filesystem::exists(options.runs)) {
            for (const StoredRun& stored : read_runs(options.runs)) {
                store_.add(stored.run, stored.physics_version);
            }
        }
    }

    void run() {
        if (!options_.diagnose) return simulate();
        for (const Truth& truth : truths_) {
            if (wanted(truth)) walk_all(truth);
        }
        resolve_all(Policy::next);
        resolve_all(Policy::random);
        write_report(truths_, outcomes_, resolutions_, options_.results);
    }

  private:
    bool wanted(const Truth& truth) const {
        return options_.only.empty() ||
               std::ranges::any_of(options_.only, [&](const std::string& name) {
                   return truth.name.starts_with(name);
               });
    }
    /// Truths that ought to be named alone are few; each counts for more than its own world.
    static int times(const Truth& truth) { return truth.well_separated() ? 2 : 1; }
    int worlds(const Truth& truth) const {
        return truth.kind == Truth::Kind::complete ? all_worlds : times(truth) * options_.worlds;
    }
    /// Studies of a truth take its worlds in turn; neighbours in the table have others.
    int world_of(const Truth& truth, int study) const {
        const auto row = static_cast<int>(&truth - truths_.data());
        return 1 + (2 * row + study % worlds(truth)) % all_worlds;
    }
    int studies(const Truth& truth) const {
        return truth.kind == Truth::Kind::complete ? options_.complete_studies
                                                   : times(truth) * options_.studies;
    }
    bool known(const Truth& truth, int study) const {
        return std::ranges::any_of(outcomes_, [&](const Outcome& outcome) {
            return outcome.truth == truth.name && outcome.study == study;
        });
    }

    /// The first world of each truth first.
    void simulate() {
        for (int study = 0; study < all_worlds; ++study) {
            for (const Truth& truth : truths_) {
                if (wanted(truth) && study < std::min(worlds(truth), studies(truth))) {
                    laboratory(truth, world_of(truth, study));
                }
            }
        }
    }

    /// From the store, as far as it has the runs.
    LabResult laboratory(const Truth& truth, int world) {
        LabPlan plan = rig(truth.friction, static_cast<std::uint64_t>(world));
        plan.effects = truth.hidden;
        std::string phase;
        double shown = -1;
        const Workers workers{options_.threads, guard_.token(),
                              [&](const EnsembleProgress& progress) {
                                  if (progress.fraction < shown + 0.25) return;
                                  shown = progress.fraction;
                                  fmt::print(stderr, "{}: {}, {} of {} runs, {} left\n", truth.name,
                                             phase, progress.runs_done, progress.runs,
                                             duration(progress.seconds_left));
                              },
                              &store_};
        return simulate_lab(plan, workers, [&](const std::string& name) {
            phase = name;
            shown = -1;
        });
    }

    void walk_all(const Truth& truth) {
        std::map<int, LabResult> laboratories;
        std::vector<int> open;
        for (int study = 0; study < studies(truth); ++study) {
            if (known(truth, study)) continue;
            open.push_back(study);
            const int world = world_of(truth, study);
            if (!laboratories.contains(world)) laboratories[world] = laboratory(truth, world);
        }
        side_by_side(open.size(), [&](std::size_t k) {
            const int study = open[k];
            add(walk(truth, laboratories.at(world_of(truth, study)), study,
                     folder_of("study", truth, study)));
        });
    }

    struct Job {
        const Truth* truth;
        int study;
        Policy policy;
    };
    /// Studies on which measuring goes on: where the diagnosis could not tell single effects apart.
    void add_jobs(const Truth& truth, Policy policy, std::vector<Job>& jobs) const {
        if (truth.kind != Truth::Kind::effect) return;
        for (const Outcome& outcome : outcomes_) {
            if (outcome.truth != truth.name || outcome.verdict != "indistinguishable" ||
                outcome.study >= options_.resolved_studies) {
                continue;
            }
            const bool done = std::ranges::any_of(resolutions_, [&](const Resolution& r) {
                return r.truth == truth.name && r.study == outcome.study && r.policy == policy;
            });
            if (!done && (policy == Policy::next || separable(truth.name, outcome.study))) {
                jobs.push_back({&truth, outcome.study, policy});
            }
        }
    }

    /// Whether `next` said that its rig can tell what a study hides.
    bool separable(const std::string& truth, int study) const {
        return std::ranges::any_of(resolutions_, [&](const Resolution& r) {
            return r.policy == Policy::next && r.separable && r.truth == truth && r.study == study;
        });
    }

    void resolve_all(Policy chosen_by) {
        std::vector<Job> jobs;
        for (const Truth& truth : truths_) {
            if (wanted(truth)) add_jobs(truth, chosen_by, jobs);
        }
        std::map<std::pair<const Truth*, int>, LabResult> laboratories;
        for (const Job& job : jobs) {
            const std::pair key(job.truth, world_of(*job.truth, job.study));
            if (!laboratories.contains(key)) {
                laboratories[key] = laboratory(*job.truth, key.second);
            }
        }
        side_by_side(jobs.size(), [&](std::size_t k) {
            const auto& [truth, study, policy] = jobs[k];
            const Workers workers{1, guard_.token(), {}, &store_};
            add(resolve(*truth, laboratories.at({truth, world_of(*truth, study)}), study, policy,
                        options_.most_measurements, workers,
                        folder_of(policy == Policy::next ? "next" : "random", *truth, study)));
        });
    }

    std::filesystem::path folder_of(const std::string& what, const Truth& truth, int study) const {
        return options_.work / fmt::format("{} {} of {}", what, study, truth.name);
    }

    /// Does work with the numbers 0, 1, ... in as many threads as wanted.
    void side_by_side(std::size_t count, const std::function<void(std::size_t)>& work) {
        std::atomic<std::size_t> next = 0;
        std::vector<std::future<void>> threads;
        for (int thread = 0; thread < options_.threads; ++thread) {
            threads.push_back(std::async(std::launch::async, [&] {
                for (std::size_t k = next++; k < count && !guard_.token().stop_requested();
                     k = next++) {
                    work(k);
                }
            }));
        }
        for (auto& thread : threads) {
            thread.get();
        }
        if (guard_.token().stop_requested()) throw dem::Interrupted();
    }

    void add(Outcome outcome) {
        const std::scoped_lock lock(mutex_);
        fmt::print(stderr, "{}, study {}: {} {} ({:.1f} s)\n", outcome.truth, outcome.study,
                   outcome.verdict, fmt::join(outcome.named, ", "), outcome.seconds);
        outcomes_.push_back(std::move(outcome));
        std::ranges::sort(outcomes_, {},
                          [](const Outcome& each) { return std::tuple(each.truth, each.study); });
        write_outcomes(outcomes_file_, outcomes_);
    }

    void add(const std::vector<Resolution>& more) {
        const std::scoped_lock lock(mutex_);
        for (const Resolution& r : more) {
            fmt::print(stderr, "{}, study {}, {}: {} {} after {} measurements\n", r.truth, r.study,
                       r.policy == Policy::next ? "next" : "random", r.verdict,
                       fmt::join(r.named, ", "), r.measurements);
            resolutions_.push_back(r);
        }
        std::ranges::sort(resolutions_, {}, [](const Resolution& each) {
            return std::tuple(each.truth, each.study, each.policy);
        });
        write_resolutions(resolutions_file_, resolutions_);
    }

    const HiddenEffectsOptions& options_;
    const app::InterruptGuard guard_;
    RunStore store_;
    std::filesystem::path outcomes_file_;
    std::vector<Outcome> outcomes_;
    std::filesystem::path resolutions_file_;
    std::vector<Resolution> resolutions_;
    std::vector<Truth> truths_;
    std::mutex mutex_;
};

}  // namespace

void hidden_effects(const HiddenEffectsOptions& options) {
    Benchmark(options).run();
}

}  // namespace pendular::bench
