#pragma once

#include <array>
#include <functional>
#include <string>
#include <vector>

#include "calib/emulator/emulator.h"
#include "sim/closures/capillary_stress.h"
#include "sim/closures/closure_values.h"
#include "sim/dem/run.h"

// Simulated states of the parameter study of Badetti et al. (2018), on which its figures and
// numbers are based.
namespace pendular {

/// Friction coefficients between grains in the parameter study [1].
/// Source: Badetti et al. (2018), tab:symbols.
inline constexpr std::array paper_frictions = {0.05, 0.09, 0.15, 0.20, 0.25};

/// A bridge volume of the parameter study, with the liquid content by which Badetti et al. (2018)
/// name it.
struct PaperContent {
    double bridge_volume;  ///< volume of a liquid bridge, divided by the cubed grain diameter [1]
    /// Liquid content Phi_L/Phi_S (volume of liquid divided by volume of grains) at reduced
    /// pressure P* = 3 [1].
    double liquid_content;
};
/// Bridge volumes of the parameter study.
/// Source: Badetti et al. (2018), tab:philphis.
inline constexpr std::array<PaperContent, 5> paper_contents = {
    {{5e-4, 0.003}, {1e-3, 0.007}, {2e-3, 0.014}, {4e-3, 0.030}, {8e-3, 0.063}}};

/// Simulated state of wet grains, together with the stress ratio of dry grains of the same friction
/// and inertial number. From both, the closures (analytical formulas) of Badetti et al. (2018)
/// predict the strength of the wet grains. All values are dimensionless.
class PaperState {
  public:
    /// @param run simulation run of the wet state
    /// @param dry_stress_ratio stress ratio of dry grains at the run's friction and inertial number
    ///        [1]
    /// @param stress_ratio_error standard error of the run's stress ratio, including the scatter
    ///        between runs of different seeds [1]
    PaperState(dem::RunResult run, const Mean& dry_stress_ratio, double stress_ratio_error);

    const dem::RunResult& run() const { return run_; }
    /// Returns a text that names the state: "friction 0.09, V0/a^3 0.002, P* 3" (V0/a^3: bridge
    /// volume divided by cubed grain diameter, P*: reduced pressure).
    std::string name() const;
    /// Friction coefficient between the grains in the run [1].
    double friction() const { return run_.parameters.friction; }
    /// Volume of a liquid bridge in the run, divided by the cubed grain diameter [1].
    double bridge_volume() const { return run_.parameters.wetting->bridge_volume; }
    /// Reduced pressure P* of the run [1].
    double reduced_pressure() const { return run_.parameters.wetting->reduced_pressure; }
    /// Stress ratio of dry grains at the friction and inertial number of the state [1].
    const Mean& dry_stress_ratio() const { return dry_stress_ratio_; }
    /// Averages over the run (solid fraction, coordination numbers, fabric, bridge forces) from
    /// which the closures (analytical formulas) compute stresses.
    const closures::State& network() const { return network_; }
    /// Capillary stresses measured in the run, divided by F0/a^2 [1] (F0: pull-off force of a
    /// bridge, a: grain diameter).
    const closures::CapillaryStress& capillary() const { return capillary_; }

    /// Returns an observable of the run with its standard error. The standard error of the stress
    /// ratio includes the scatter between runs of different seeds.
    Mean operator[](dem::Observable which) const;
    /// Solid fraction of the run, corrected to grains of infinite stiffness [1].
    Mean rigid_solid_fraction() const;
    /// Returns the value of a closure (analytical formula) [1], as in
    /// `closure(&closures::ClosureValues::strength2)`, with the part of its standard error that
    /// comes from the stress ratios of this state and of dry grains.
    Mean closure(double closures::ClosureValues::*value) const;

  private:
    dem::RunResult run_;
    Mean dry_stress_ratio_;
    double stress_ratio_error_;
    closures::State network_;
    closures::CapillaryStress capillary_;
};

/// Straight line mu* = intercept + c*/P* through the stress ratios mu* of the states of one
/// friction and one bridge volume at reduced pressures P* >= 2.3, weighted by their standard
/// errors. The slope c* is the reduced cohesion.
/// Source: Badetti et al. (2018), eq:mohrcoulomb2.
struct StrengthLine {
    /// Friction coefficient [1], and bridge volume divided by cubed grain diameter [1], of the
    /// states on the line.
    double friction = 0, bridge_volume = 0;
    /// Fitted intercept of the line [1], and its slope, the reduced cohesion c* = a^2 c/F0 [1] (a:
    /// grain diameter, c: cohesion, F0: pull-off force of a bridge).
    Mean intercept, cohesion;
    /// Covariance of the errors of the intercept and of the reduced cohesion c* [1].
    double covariance = 0;
    /// Number of simulated states to which the line is fitted.
    int points = 0;

    /// Returns the stress ratio of the line at a reduced pressure [1], with its standard error.
    Mean at(double reduced_pressure) const;
};

/// Stiffness number of the simulations of Badetti et al. (2018) [1].
inline constexpr double paper_stiffness = 8400;

/// Whether two frictions, two bridge volumes or two reduced pressures [1] are equal up to rounding.
bool same_setting(double a, double b);

/// A state of the parameter study that has not been simulated.
struct MissingState {
    /// Friction coefficient, bridge volume divided by cubed grain diameter, and reduced pressure of
    /// the missing state [1].
    double friction, bridge_volume, reduced_pressure;
};

/// Simulations of the parameter study of Badetti et al. (2018), as far as the atlas or the store
/// contains them.
class PaperStudy {
  public:
    /// Selects the usable runs (`emulated::usable`) without effects at the frictions and bridge
    /// volumes of the parameter study and inertial numbers up to 0.0035. If several runs simulate
    /// one state, a run within a factor 2 of the stiffness number of Badetti et al. (2018) is used,
    /// else the run with the most grains. The emulator converts runs of other stiffness numbers to
    /// the stiffness number of Badetti et al., with the error of the conversion; otherwise
    /// stiffness could be mistaken for a trend. An emulator without runs of several stiffness
    /// numbers converts nothing.
    /// @param runs runs of atlas and store
    /// @param emulator emulator trained on `runs`; must outlive this object
    PaperStudy(const std::vector<dem::RunResult>& runs, const Emulator& emulator);

    /// Simulated states of the parameter study, sorted by friction, bridge volume and reduced
    /// pressure.
    const std::vector<PaperState>& states() const { return states_; }
    /// Number of the states that were simulated within a factor 2 of the stiffness number of
    /// Badetti et al. (2018).
    std::size_t stiff() const { return stiff_; }
    /// Returns the states that fulfil a condition, in the order of states().
    std::vector<const PaperState*> where(
        const std::function<bool(const PaperState&)>& condition) const;
    /// Returns the state with the given friction [1], bridge volume divided by the cubed grain
    /// diameter [1] and reduced pressure [1]; null if no run simulates this state.
    const PaperState* at(double friction, double bridge_volume, double reduced_pressure) const;
    /// Dry runs without effects, sorted by friction, then by inertial number.
    const std::vector<dem::RunResult>& dry_runs() const { return dry_runs_; }
    /// Straight lines of stress ratio against 1/P* (P*: reduced pressure), one for each friction
    /// and bridge volume with three or more states at P* >= `lowest_cohesion_pressure`.
    const std::vector<StrengthLine>& lines() const { return lines_; }
    /// Returns the straight line of stress ratio against 1/P* (P*: reduced pressure) of the states
    /// of one friction [1] and one bridge volume, divided by the cubed grain diameter [1]; null if
    /// no line was fitted to these states.
    const StrengthLine* line(double friction, double bridge_volume) const;
    /// Returns the mean of a closure (analytical formula) [1] over the states to which the line
    /// `line` was fitted. Its standard error is the mean of the states' standard errors, which are
    /// taken as fully correlated, since most of each comes from the common stress ratio of dry
    /// grains.
    Mean mean_over(const StrengthLine& line, double closures::ClosureValues::*value) const;
    /// Stress ratio and solid fraction [1] of dry grains of a friction coefficient [1] in the limit
    /// of slow shear, predicted by the emulator; the solid fraction is that of rigid grains.
    Mean dry_stress_ratio(double friction) const;
    Mean dry_solid_fraction(double friction) const;
    /// Returns an observable [1] of dry grains at a friction coefficient and an inertial number
    /// [1], predicted by the emulator for the stiffness number of Badetti et al. (2018); the solid
    /// fraction is that of rigid grains.
    Mean dry(dem::Observable which, double friction, double inertial_number) const;
    /// Returns the states of the grid of frictions, bridge volumes and reduced pressures
    /// (`paper_frictions`, `paper_contents`, `paper_pressures`) that no run simulates.
    std::vector<MissingState> missing() const;

  private:
    /// Returns one state for each combination of friction, bridge volume and reduced pressure among
    /// `runs`.
    std::vector<PaperState> states_of(std::vector<dem::RunResult> runs);
    /// Returns the states of a friction and bridge volume at reduced pressures >=
    /// `lowest_cohesion_pressure`.
    std::vector<const PaperState*> line_states(double friction, double bridge_volume) const;
    void fit_lines();

    const Emulator& emulator_;
    std::size_t stiff_ = 0;
    std::vector<PaperState> states_;
    std::vector<dem::RunResult> dry_runs_;
    std::vector<StrengthLine> lines_;
};

/// Inertial number at which the states of the parameter study are simulated [1]: slow enough, and
/// three times as fast to simulate as the 0.001 of Badetti et al. (2018).
inline constexpr double grid_inertial_number = 0.003;
/// Reduced pressures at which the states of the parameter study are simulated [1]. Badetti et al.
/// (2018) state only that the range begins at 0.5.
inline constexpr std::array paper_pressures = {0.5, 1.0, 2.0, 3.0, 5.0, 10.0};

}  // namespace pendular
