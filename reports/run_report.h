#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "reports/output.h"
#include "sim/closures/closure_values.h"
#include "sim/dem/run.h"
#include "sim/lab/virtual_lab.h"
#include "sim/runs/store/run_store.h"
#include "workflow/json/commands.h"
#include "workflow/json/run.h"
#include "workflow/reproduction.h"
#include "workflow/state_prediction.h"

namespace pendular {

/// Returns a line with the name of an observable, its value with standard error, and its meaning.
std::string observable_line(dem::Observable which, const Mean& mean);

/// Adds the closures (analytical formulas) of Badetti et al. (2018) for a flow of wet grains, one
/// dimensionless value per line.
/// @param stress_ratio simulated or predicted stress ratio [1], for comparison
void add_closures(Output& output, const closures::ClosureValues& values, double stress_ratio);

/// Returns the closures of a simulation or, if `values` is empty, a sentence on what they need.
Output closures_output(const std::optional<closures::ClosureValues>& values, double stress_ratio);

/// Returns what `pendular simulate` says of a simulation.
Output simulation_output(const Simulated& simulated);

/// Returns what `pendular predict` says of a state that it simulated.
/// @param wanted parameters of the run that was asked for
/// @param store that has the result; null: none
Output simulated_output(const RequestedState& requested, const dem::RunParameters& wanted,
                        const dem::RunResult& run, const Fidelity& fidelity, const RunStore* store);

/// Returns what `pendular predict` says of a predicted state.
/// @param simulates whether the user allowed a simulation
Output prediction_output(const RequestedState& requested, const StatePrediction& prediction,
                         bool simulates);

/// Returns what `pendular predict --along` says of a curve that was written to `folder`.
/// @param points number of states that were asked for
/// @param runs number of training runs
Output curve_output(const PredictionCurve& curve, int points, std::size_t runs,
                    const std::filesystem::path& folder);

/// Returns a table of stored runs, one line each.
Output runs_output(const std::vector<StoredRun>& runs);

Output run_output(const StoredRun& stored);

/// Returns a table of two stored runs, side by side.
Output difference_output(const StoredRun& first, const StoredRun& second);

/// Returns what `pendular campaign` says at its end.
Output campaign_output(const CampaignState& state, const std::vector<dem::RunResult>& failed);

/// Returns what `pendular campaign --dry-run` says.
/// @param source what the expected duration follows from
Output plan_output(const CampaignState& state, int threads, const std::string& source);

/// Returns what `pendular virtual-lab` says of the recordings that it wrote to `folder`.
Output lab_output(const LabResult& result, const std::filesystem::path& folder);

/// Returns how many of the published numbers the simulations reproduce, and how many simulated
/// states were used.
std::string verdict_of(const Reproduction& reproduction);

/// Returns a table with the meaning of each published number, its published and simulated values,
/// and whether they agree.
/// @param all whether numbers that agree are shown too
std::vector<std::string> scoreboard_table(const std::vector<ScoreboardRow>& rows, bool all);

/// Returns a page in Markdown with a table of numbers for each section of Badetti et al. (2018),
/// and how to repeat the comparison.
std::string reproduction_page(const Reproduction& reproduction);

/// Returns what `pendular reproduce` says.
/// @param all whether numbers that agree are shown too
Output reproduction_output(const Reproduction& reproduction, bool all);

}  // namespace pendular
