#pragma once

#include <map>
#include <string>
#include <vector>

#include "analysis/reproduction/paper_states.h"
#include "reports/figure.h"
#include "sim/dem/run.h"
#include "sim/runs/store/run_store.h"
#include "workflow/state_prediction.h"

namespace pendular {

/// Returns stress ratio and solid fraction, averaged over short blocks of strain, against the shear
/// strain. Horizontal lines mark the averages over the steady state, a vertical line the end of the
/// transient.
Figure trace_figure(const StoredRun& run);

/// Returns a figure of one column of the table of simulations (`run_columns`) against another, one
/// point per successful simulation, with the standard errors of `y` if there are any. Colours
/// distinguish dry simulations and three ranges of P*; symbols distinguish simulations without and
/// with effects on grains.
/// @throws InputError if a column does not exist or contains no numbers, or if no successful
///        simulation has numbers in both
Figure runs_figure(const std::vector<StoredRun>& runs, const std::string& x, const std::string& y);

/// Returns the profiles and distributions of a simulation as CSV, one table for each coordinate,
/// keyed by file name. Headers are `NAME [unit]`; a column NAME_sd after each column NAME contains
/// the standard errors.
std::map<std::string, std::string> field_tables(const dem::RunResult& run);

/// Returns `profiles` of velocity, solid fraction and granular temperature along the velocity
/// gradient, and `distributions` of orientations and forces of contacts and, for wet grains, of
/// orientations and gaps of bridges between grains that do not touch.
std::vector<Figure> field_figures(const dem::RunResult& run);

/// Checks that a quantity, an observable of the simulation or a closure (analytical formula), was
/// predicted along the curve.
/// @param name as in the JSON output of the program
/// @throws InputError if not; the message suggests the known name with the most similar spelling
void check_drawable(const std::string& name, const PredictionCurve& curve);

/// Returns a panel for each quantity along the curve. The emulator predicts observables with
/// standard errors; closures are computed from them. Panels of observables also show the
/// simulations near the curve: those that agree with it within 5 % in stiffness number and in all
/// quantities that do not vary along it.
/// @param drawn names that `check_drawable` accepts
Figure prediction_figure(const PredictionCurve& curve, const Emulator& emulator,
                         const std::vector<std::string>& drawn);

/// Returns the predictions as CSV, one row per state: friction, inertial number, P* and V0/a^3
/// (both empty for dry states), each observable with its standard error and, for wet states, the
/// closures.
std::string prediction_table(const PredictionCurve& curve);

/// Returns the figures of Badetti et al. (2018) that show simulations, with axes, normalisations,
/// symbols and names as in the paper. States that have not been simulated are left out. The first
/// two also show the emulator. Distant bridges join grains that do not touch.
/// - mustarphimu: dry stress ratio and solid fraction against friction
/// - muphinertial: dry stress ratio and solid fraction against the inertial number
/// - philphis: liquid content against P*
/// - cexpnum: stress ratio against 1/P* for friction 0.09, with the fitted straight lines
/// - phiexpnum: solid fraction against 1/P* for friction 0.09
/// - cphilphis, cstarmu: reduced cohesion against the liquid content, against friction
/// - coulombeff: stress ratio of the contact forces against P*, with those of dry grains
/// - zzcip, phisdiffmu: coordination numbers, solid fraction against P*
/// - appdiff, s12pred: predicted against simulated stress ratio, without and with capillary shear
///   stress
/// - cohcomp, cohgen: cohesion by Rumpf's formula, generalised cohesion, over the cohesion from the
///   straight line, against 1/P*
/// - scaps: capillary shear stress against 1/P*
/// - scapcd: capillary shear stress of distant bridges over that of bridges at contacts, against
///   1/P*
/// - fabric: fabric of contacts and of distant bridges against 1/P*
/// - scapdapp, scapapp: capillary shear stress of distant bridges, of all bridges, predicted from
///   fabric and anisotropy of forces, against the simulated value
std::vector<Figure> paper_figures(const PaperStudy& study);

}  // namespace pendular
