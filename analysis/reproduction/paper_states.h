#pragma once

#include <array>
#include <functional>
#include <string>
#include <vector>

#include "calib/emulator/emulator.h"
#include "sim/closures/capillary_stress.h"
#include "sim/closures/closure_values.h"
#include "sim/dem/run.h"

// Simulated states of the parameter study of Badetti et al. (2018), on which the figures and
// numbers of that paper are based.
namespace pendular {

/// Friction coefficients between grains [1] in the parameter study of Badetti et al. (2018).
/// Source: Badetti et al. (2018), Table 2.
inline constexpr std::array paper_frictions = {0.05, 0.09, 0.15, 0.20, 0.25};

/// Volume of a liquid bridge in the parameter study of Badetti et al. (2018), with the liquid
/// content that the authors state for this volume.
struct PaperContent {
    double bridge_volume;  ///< volume of a liquid bridge, divided by the cubed grain diameter [1]
    /// Liquid content Phi_L/Phi_S (volume of liquid divided by volume of grains) at the reduced
    /// pressure P* = 3 [1].
    double liquid_content;
};
/// Volumes of a liquid bridge in the parameter study of Badetti et al. (2018), each with the liquid
/// content that the authors state for the volume.
/// Source: Badetti et al. (2018), Table 1.
inline constexpr std::array<PaperContent, 5> paper_contents = {
    {{5e-4, 0.003}, {1e-3, 0.007}, {2e-3, 0.014}, {4e-3, 0.030}, {8e-3, 0.063}}};

/// Simulated state of wet grains, with the stress ratio of dry grains that have the friction
/// coefficient and the inertial number of the wet grains. From the state and this stress ratio, the
/// closures (analytical formulas) of Badetti et al. (2018) predict the strength of the wet grains.
/// All values are dimensionless.
class PaperState {
  public:
    /// Combines the simulation run of a state of wet grains with the stress ratio of dry grains.
    /// @param run simulation run of the wet grains
    /// @param dry_stress_ratio stress ratio [1] of dry grains that have the friction coefficient
    ///        and the inertial number of the run
    /// @param stress_ratio_error standard error of the run's stress ratio [1], including the
    ///        scatter between runs of different seeds
    PaperState(dem::RunResult run, const Mean& dry_stress_ratio, double stress_ratio_error);

    const dem::RunResult& run() const { return run_; }
    /// Returns a name for the state, such as "friction 0.09, V0/a^3 0.002, P* 3" (V0/a^3: bridge
    /// volume divided by cubed grain diameter, P*: reduced pressure).
    std::string name() const;
    /// Returns the friction coefficient between the grains in the run [1].
    double friction() const { return run_.parameters.friction; }
    /// Returns the volume of a liquid bridge in the run, divided by the cubed grain diameter [1].
    double bridge_volume() const { return run_.parameters.wetting->bridge_volume; }
    /// Returns the reduced pressure P* of the run [1].
    double reduced_pressure() const { return run_.parameters.wetting->reduced_pressure; }
    /// Returns the stress ratio [1] of dry grains that have the friction coefficient and the
    /// inertial number of the state, with its standard error.
    const Mean& dry_stress_ratio() const { return dry_stress_ratio_; }
    /// Returns the averages over the run (solid fraction, coordination numbers, fabric, bridge
    /// forces) from which the closures (analytical formulas) compute stresses. All averages are
    /// dimensionless.
    const closures::State& network() const { return network_; }
    /// Returns the capillary stresses (contributions of the bridge forces to the stress) in the
    /// run, divided by F0/a^2 [1] (F0: pull-off force of a bridge, a: grain diameter).
    const closures::CapillaryStress& capillary() const { return capillary_; }

    /// Returns the mean of an observable of the run, such as the solid fraction, with its standard
    /// error [1]. The standard error of the stress ratio includes the scatter between runs of
    /// different seeds.
    Mean operator[](dem::Observable which) const;
    /// Returns the solid fraction of the run [1], corrected to grains of infinite stiffness, with
    /// its standard error.
    Mean rigid_solid_fraction() const;
    /// Returns the result of a closure (analytical formula) [1] for the state, for example
    /// `closure(&closures::ClosureValues::strength2)`. The standard error contains only the
    /// contributions from the stress ratios of the state and of dry grains.
    Mean closure(double closures::ClosureValues::*value) const;

  private:
    dem::RunResult run_;
    Mean dry_stress_ratio_;
    double stress_ratio_error_;
    closures::State network_;
    closures::CapillaryStress capillary_;
};

/// Straight line mu* = intercept + c*/P* fitted to the stress ratios mu* of simulated states at
/// reduced pressures P* >= 2.3, weighted with the inverse variances of mu*. All states of a line
/// have one friction coefficient and one bridge volume. The slope c* is the reduced cohesion.
/// Source: Badetti et al. (2018), Eq. (16).
struct StrengthLine {
    /// Friction coefficient [1] of the states to which the line is fitted, and bridge volume of
    /// these states, divided by the cubed grain diameter [1].
    double friction = 0, bridge_volume = 0;
    /// Intercept [1] and slope [1] of the fitted line, with standard errors. The slope is the
    /// reduced cohesion c* = a^2 c/F0 (a: grain diameter, c: cohesion, F0: pull-off force of a
    /// bridge).
    Mean intercept, cohesion;
    /// Covariance of the errors of the intercept and of the reduced cohesion c* [1].
    double covariance = 0;
    /// Number of simulated states to which the line is fitted.
    int points = 0;

    /// Returns the stress ratio on the line [1] at a reduced pressure [1], with the standard error
    /// of the stress ratio.
    Mean at(double reduced_pressure) const;
};

/// Stiffness number (E/((1 - nu^2) s22))^(2/3) of the simulations of Badetti et al. (2018) [1] (E,
/// nu: Young's modulus and Poisson ratio of the grains, s22: normal stress).
inline constexpr double paper_stiffness = 8400;

/// Whether two friction coefficients, two bridge volumes or two reduced pressures [1] are equal up
/// to rounding.
bool same_setting(double a, double b);

/// State of the parameter study of Badetti et al. (2018) that no available simulation run covers.
struct MissingState {
    /// Friction coefficient [1], bridge volume divided by the cubed grain diameter [1], and reduced
    /// pressure [1] of the state.
    double friction, bridge_volume, reduced_pressure;
};

/// Simulations of the parameter study of Badetti et al. (2018) that the atlas (the simulations
/// supplied with Pendular) or the store (the user's file of simulations) contains.
class PaperStudy {
  public:
    /// Selects runs of wet grains that can train an emulator (`emulated::usable`), without
    /// additional physical effects. The runs must have a friction coefficient and a bridge volume
    /// of the parameter study, and an inertial number of at most 0.0035. If several runs simulate
    /// one state, the constructor prefers runs whose stiffness number is within a factor of 2 of
    /// `paper_stiffness`, then the run with the most grains. The results of runs with other
    /// stiffness numbers are converted to `paper_stiffness` by the emulator (which interpolates
    /// simulations), with the error of the conversion added. Nothing is converted if
    /// Emulator::knows_stiffness() is false.
    /// @param runs simulation runs of atlas and store
    /// @param emulator emulator trained on `runs`; must outlive this object
    PaperStudy(const std::vector<dem::RunResult>& runs, const Emulator& emulator);

    /// Returns the simulated states of the parameter study, sorted by friction coefficient, then
    /// bridge volume, then reduced pressure.
    const std::vector<PaperState>& states() const { return states_; }
    /// Returns the number of simulated states whose run has a stiffness number within a factor of 2
    /// of `paper_stiffness`, so that the run needs no conversion.
    std::size_t stiff() const { return stiff_; }
    /// Returns the simulated states for which `condition` returns true, in the order of states().
    std::vector<const PaperState*> where(
        const std::function<bool(const PaperState&)>& condition) const;
    /// Returns the simulated state with the given friction coefficient [1], bridge volume divided
    /// by the cubed grain diameter [1] and reduced pressure [1]. Null if no available run simulates
    /// the state.
    const PaperState* at(double friction, double bridge_volume, double reduced_pressure) const;
    /// Returns the runs of dry grains that can train an emulator (`emulated::usable`), without
    /// additional physical effects, sorted by friction coefficient, then by inertial number.
    const std::vector<dem::RunResult>& dry_runs() const { return dry_runs_; }
    /// Returns the straight lines of stress ratio against 1/P* (P*: reduced pressure), one for each
    /// friction coefficient and bridge volume with three or more simulated states at P* >=
    /// `lowest_cohesion_pressure`.
    const std::vector<StrengthLine>& lines() const { return lines_; }
    /// Returns the straight line of stress ratio against 1/P* (P*: reduced pressure) of the
    /// simulated states with the friction coefficient `friction` [1] and the bridge volume
    /// `bridge_volume`, divided by the cubed grain diameter [1]. Null if no line was fitted to
    /// these states.
    const StrengthLine* line(double friction, double bridge_volume) const;
    /// Returns the mean of the closure (analytical formula) `value` [1] over the simulated states
    /// to which `line` was fitted. The standard error of the mean is the mean of the states'
    /// standard errors. The errors count as fully correlated, since they come mostly from the
    /// stress ratio of dry grains, which the states have in common.
    Mean mean_over(const StrengthLine& line, double closures::ClosureValues::*value) const;
    /// Returns the stress ratio [1] or the solid fraction [1] of dry grains with the friction
    /// coefficient `friction` [1] at the inertial number 0 (limit of slow shear). The emulator
    /// (which interpolates simulations) predicts both values. The solid fraction holds for rigid
    /// grains.
    Mean dry_stress_ratio(double friction) const;
    Mean dry_solid_fraction(double friction) const;
    /// Returns the mean of an observable [1] of dry grains at a friction coefficient [1] and an
    /// inertial number [1]. The emulator (which interpolates simulations) predicts the mean for the
    /// stiffness number of Badetti et al. (2018). The solid fraction holds for rigid grains.
    Mean dry(dem::Observable which, double friction, double inertial_number) const;
    /// Returns the states of the parameter study that no available run simulates. The parameter
    /// study combines all friction coefficients, bridge volumes and reduced pressures of
    /// `paper_frictions`, `paper_contents` and `paper_pressures`.
    std::vector<MissingState> missing() const;

  private:
    /// Returns one state for each combination of friction coefficient, bridge volume and reduced
    /// pressure that occurs among `runs`, and counts the states that need no conversion of the
    /// stiffness number (`stiff_`).
    std::vector<PaperState> states_of(std::vector<dem::RunResult> runs);
    /// Returns the simulated states with the given friction coefficient [1] and bridge volume,
    /// divided by the cubed grain diameter [1], at reduced pressures of at least
    /// `lowest_cohesion_pressure`.
    std::vector<const PaperState*> line_states(double friction, double bridge_volume) const;
    void fit_lines();

    const Emulator& emulator_;
    std::size_t stiff_ = 0;
    std::vector<PaperState> states_;
    std::vector<dem::RunResult> dry_runs_;
    std::vector<StrengthLine> lines_;
};

/// Inertial number [1] at which Pendular simulates the states of the parameter study of Badetti et
/// al. (2018). At this inertial number, the shear still counts as slow (`PaperStudy`), and a
/// simulation takes a third of the time of a simulation at 0.001, the inertial number of Badetti et
/// al. (2018).
inline constexpr double grid_inertial_number = 0.003;
/// Reduced pressures [1] at which Pendular repeats the simulations of Badetti et al. (2018). The
/// paper states only that the range begins at 0.5; the other values were chosen here.
inline constexpr std::array paper_pressures = {0.5, 1.0, 2.0, 3.0, 5.0, 10.0};

}  // namespace pendular
