#include "sim/lab/virtual_lab.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>

#include "data/input_error.h"
#include "data/quantities/statistics.h"
#include "sim/lab/lab_checks.h"
#include "sim/lab/lab_plan.h"
#include "sim/runs/run_request.h"
#include "sim/runs/run_settings.h"

namespace pendular {
namespace {

/// Attempts for one run, each with a seed of its own. Chosen: a state that crystallises or fails so
/// often does so with most seeds.
constexpr int most_attempts = 4;

/// Carries out the runs of one laboratory, with consecutive seeds or, where laboratories share
/// their states, with seeds that follow from the parameters of a run and from how often it was
/// wanted.
class Runs {
  public:
    Runs(const LabPlan& plan, const Workers& workers)
        : seed_(plan.seed), shared_(plan.shared_states), workers_(workers) {}

    /// Carries out runs with new seeds, and repeats with other seeds the runs for which `complaint`
    /// returns a reason why they are unusable. Returns the usable results in the order of `runs`.
    /// @throws dem::SimulationError where a run remains unusable after `most_attempts` attempts
    template <typename Complaint>
    std::vector<dem::RunResult> simulate_all(std::vector<dem::RunParameters> runs,
                                             const Complaint& complaint) {
        std::vector<dem::RunResult> results(runs.size());
        std::vector<std::size_t> which(runs.size());
        for (std::size_t k = 0; k < which.size(); ++k) {
            which[k] = k;
        }
        for (int attempt = 1; !which.empty(); ++attempt) {
            std::vector<dem::RunParameters> batch;
            for (const std::size_t k : which) {
                runs[k].seed = seed_of_run(seed_, place_of(runs[k]), SeedDomain::virtual_lab);
                batch.push_back(runs[k]);
            }
            const auto done = run_all(batch, workers_);
            std::vector<std::size_t> again;
            for (std::size_t i = 0; i < which.size(); ++i) {
                results[which[i]] = done[i];
                if (const std::string why = complaint(done[i]); !why.empty()) {
                    note_or_give_up(done[i].parameters, why, attempt);
                    again.push_back(which[i]);
                }
            }
            which = std::move(again);
        }
        return results;
    }

    const std::vector<std::string>& notes() const { return notes_; }

  private:
    /// Returns the number from which the seed of the next run with these parameters follows.
    std::uint64_t place_of(dem::RunParameters run) {
        if (!shared_) return ordered_++;
        run.seed = 0;
        const std::string what = run_description(run);
        return fingerprint(fmt::format("{} {}", what, wanted_[what]++));
    }

    void note_or_give_up(const dem::RunParameters& p, const std::string& why, int attempt) {
        const std::string what = fmt::format(
            "a simulation at inertial number {:g}{} {}", p.inertial_number,
            p.wetting ? fmt::format(", reduced pressure {:.3g}", p.wetting->reduced_pressure) : "",
            why);
        if (attempt == most_attempts) {
            throw dem::SimulationError(
                fmt::format("{}; {} simulations with other seeds were no better; leave the "
                            "condition out, or use a higher friction or fidelity",
                            what, attempt - 1));
        }
        notes_.push_back(what + "; it was repeated with another seed");
    }

    std::uint64_t seed_;
    bool shared_;
    const Workers& workers_;
    std::uint64_t ordered_ = 0;
    std::map<std::string, std::uint64_t> wanted_;  ///< how often runs were wanted, by description
    std::vector<std::string> notes_;
};

std::string failed_or_crystallised(const dem::RunResult& run) {
    return !run.failure.empty() ? "failed: " + run.failure : run.crystallised ? "crystallised" : "";
}

std::string unusable(const dem::RunResult& run) {
    const std::string why = failed_or_crystallised(run);
    return why.empty() && !run.steady ? "was never steady" : why;
}

FlowPoint flow_of(const dem::RunResult& run) {
    return {run[dem::Observable::stress_ratio].value, run[dem::Observable::solid_fraction].value};
}

/// Steps of given angular velocity, whose inertial numbers follow from the flow in pilot runs.
class StepsAtSpeed {
  public:
    StepsAtSpeed(const LabPlan& plan, const std::vector<PlannedRecording>& recordings)
        : plan_(plan) {
        for (const PlannedRecording& recording : recordings) {
            for (std::size_t k = 0; k < recording.conditions.size(); ++k) {
                if (recording.angular_velocities[k] > 0) add(recording.conditions[k]);
            }
        }
    }

    const std::vector<dem::RunParameters>& pilots() const { return pilots_; }
    void set_flows(const std::vector<dem::RunResult>& runs) {
        std::ranges::transform(runs, std::back_inserter(flows_), flow_of);
    }
    /// Returns the flow in the pilot run of a step.
    const FlowPoint& flow(const Condition& asked) const {
        return flows_[places_.at(run_description(pilot(asked)))];
    }

  private:
    dem::RunParameters pilot(const Condition& asked) const {
        const EffectiveCondition imposed = imposed_condition(plan_, asked);
        return pilot_at(plan_, imposed,
                        imposed.dry() ? 0 : first_bridge_volume(imposed.liquid_content));
    }
    void add(const Condition& asked) {
        const dem::RunParameters run = pilot(asked);
        if (places_.emplace(run_description(run), pilots_.size()).second) pilots_.push_back(run);
    }

    const LabPlan& plan_;
    std::vector<dem::RunParameters> pilots_;
    std::vector<FlowPoint> flows_;
    std::map<std::string, std::size_t> places_;
};

/// Returns the planned recordings, with the true condition of each step but without runs. The flow
/// of a step of given speed comes from `steps`.
std::vector<LabRecording> without_runs(const LabPlan& plan, std::vector<PlannedRecording> planned,
                                       const StepsAtSpeed& steps) {
    std::vector<std::vector<FlowPoint>> flows;
    for (PlannedRecording& recording : planned) {
        flows.emplace_back(recording.conditions.size(), FlowPoint{0.3, 0.6});
        for (std::size_t k = 0; k < recording.conditions.size(); ++k) {
            Condition& asked = recording.conditions[k];
            const double speed = recording.angular_velocities[k];
            if (speed == 0) continue;
            flows.back()[k] = steps.flow(asked);
            asked.inertial_number = inertial_number_at_speed(plan, asked, speed, flows.back()[k]);
        }
    }
    if (!steps.pilots().empty()) set_times(plan, planned);
    std::vector<LabRecording> recordings;
    for (std::size_t r = 0; r < planned.size(); ++r) {
        LabRecording recording{.file = planned[r].file,
                               .liquid_content = planned[r].liquid_content,
                               .replicate = planned[r].replicate,
                               .seed = planned[r].seed,
                               .steps = {}};
        for (std::size_t k = 0; k < planned[r].conditions.size(); ++k) {
            const Condition& condition = planned[r].conditions[k];
            recording.steps.push_back({condition,
                                       imposed_condition(plan, condition, flows[r][k]),
                                       {},
                                       planned[r].angular_velocities[k]});
        }
        recordings.push_back(std::move(recording));
    }
    return recordings;
}

/// Returns the recordings of a plan without runs; pilot runs find the inertial numbers at given
/// angular velocities.
std::vector<LabRecording> planned_recordings(const LabPlan& plan, Runs& runs, std::size_t& pilots,
                                             const AnnouncePhase& announce) {
    std::vector<PlannedRecording> planned = recordings_of(plan);
    StepsAtSpeed steps(plan, planned);
    if (!steps.pilots().empty()) {
        announce("simulations that seek the heights");
        steps.set_flows(runs.simulate_all(steps.pilots(), failed_or_crystallised));
        pilots += steps.pilots().size();
    }
    return without_runs(plan, std::move(planned), steps);
}

/// Distinct wet conditions of all recordings, each of which needs its own bridge volume.
class WetConditions {
  public:
    WetConditions(const LabPlan& plan, const std::vector<LabRecording>& recordings) : plan_(plan) {
        for (const LabRecording& recording : recordings) {
            for (const LabStep& step : recording.steps) {
                if (!step.imposed.dry()) add(step.imposed);
            }
        }
    }

    const std::vector<EffectiveCondition>& all() const { return conditions_; }
    /// Returns the index of a condition in `all`.
    std::size_t place_of(const EffectiveCondition& condition) const {
        return places_.at(key_of(condition));
    }

  private:
    /// Returns a text of all quantities that determine a run and its liquid content.
    std::string key_of(const EffectiveCondition& condition) const {
        return fmt::format("{} {}", condition.liquid_content,
                           run_description(run_at(plan_, condition, 0)));
    }
    void add(const EffectiveCondition& condition) {
        if (places_.emplace(key_of(condition), conditions_.size()).second) {
            conditions_.push_back(condition);
        }
    }

    const LabPlan& plan_;
    std::vector<EffectiveCondition> conditions_;
    std::map<std::string, std::size_t> places_;
};

/// Returns the bridge volume V0/a^3 [1] of each wet condition, found by pilot runs.
std::vector<double> find_bridge_volumes(const LabPlan& plan,
                                        const std::vector<EffectiveCondition>& conditions,
                                        Runs& runs, LabResult& result,
                                        const AnnouncePhase& announce) {
    if (conditions.empty()) {
        return {};
    }
    std::vector<double> contents;
    std::ranges::transform(conditions, std::back_inserter(contents),
                           &EffectiveCondition::liquid_content);
    bool first = true;
    return bridge_volumes(
        contents, [&](std::span<const std::size_t> which, std::span<const double> volumes) {
            announce(first ? "simulations that seek the bridge volumes"
                           : "second simulations that seek the bridge volumes");
            first = false;
            std::vector<dem::RunParameters> pilots;
            for (std::size_t i = 0; i < which.size(); ++i) {
                pilots.push_back(pilot_at(plan, conditions[which[i]], volumes[i]));
            }
            result.pilots += pilots.size();
            std::vector<double> found;
            for (const auto& run : runs.simulate_all(pilots, failed_or_crystallised)) {
                found.push_back(run[dem::Observable::liquid_content].value);
            }
            return found;
        });
}

/// Adds a note where the standard errors of the runs exceed the scatter planned for the recordings.
void note_scatter(LabResult& result) {
    const double noise = result.plan.instrument.noise;
    const double torque = typical_error(result, dem::Observable::stress_ratio);
    const double fraction = typical_error(result, dem::Observable::solid_fraction);
    const double torque_error = result.plan.instrument.torque_error;
    const double fraction_error = result.plan.instrument.solid_fraction_error;
    if (torque > noise * torque_error || fraction > noise * fraction_error) {
        result.notes.push_back(
            fmt::format("the simulations alone cause a scatter of {:.2g} % in torque and {:.2g} % "
                        "in solid fraction, whereas --noise {:g} requests a total of {:g} % and "
                        "{:g} %; a higher fidelity reduces the scatter",
                        100 * torque, 100 * fraction, noise, 100 * noise * torque_error,
                        100 * noise * fraction_error));
    }
}

void note_merging_bridges(LabResult& result) {
    double largest = 0;
    for (const LabRecording& recording : result.recordings) {
        for (const LabStep& step : recording.steps) {
            const auto& wetting = step.run.parameters.wetting;
            largest = std::max(largest, wetting ? wetting->bridge_volume : 0);
        }
    }
    if (largest > dem::largest_pendular_volume) {
        result.notes.push_back(fmt::format(
            "bridge volumes reach {:.2g} a^3; above {:g} a^3 the bridges between three grains in "
            "contact merge: the model holds for separate bridges",
            largest, dem::largest_pendular_volume));
    }
}

}  // namespace

double typical_error(const LabResult& result, dem::Observable which) {
    std::vector<double> errors;
    for (const LabRecording& recording : result.recordings) {
        for (const LabStep& step : recording.steps) {
            errors.push_back(step.run[which].standard_error / step.run[which].value);
        }
    }
    return median(errors);
}

LabResult simulate_lab(const LabPlan& plan, const Workers& workers, const AnnouncePhase& announce) {
    check_plan(plan);
    const AnnouncePhase tell = announce ? announce : [](const std::string&) {};
    Runs runs(plan, workers);
    LabResult result{.plan = plan};
    result.recordings = planned_recordings(plan, runs, result.pilots, tell);
    const WetConditions wet(plan, result.recordings);
    const std::vector<double> volumes = find_bridge_volumes(plan, wet.all(), runs, result, tell);

    std::vector<dem::RunParameters> wanted;
    for (const LabRecording& recording : result.recordings) {
        for (const LabStep& step : recording.steps) {
            const EffectiveCondition& imposed = step.imposed;
            wanted.push_back(
                run_at(plan, imposed, imposed.dry() ? 0 : volumes[wet.place_of(imposed)]));
        }
    }
    tell("recordings");
    const auto done = runs.simulate_all(wanted, unusable);
    auto next = done.begin();
    for (LabRecording& recording : result.recordings) {
        for (LabStep& step : recording.steps) {
            step.run = *next++;
            if (step.angular_velocity > 0) {
                step.condition.inertial_number = inertial_number_at_speed(
                    plan, step.condition, step.angular_velocity, flow_of(step.run));
            }
        }
    }
    result.notes = runs.notes();
    note_scatter(result);
    note_merging_bridges(result);
    return result;
}

}  // namespace pendular
