#pragma once

#include <array>
#include <functional>
#include <string>
#include <vector>

#include "calib/emulator/emulator.h"
#include "sim/closures/closure_values.h"
#include "sim/closures/state.h"
#include "sim/dem/run.h"

// Simulated states of the parameter study of Badetti et al. (2018), on which the figures and
// numbers of that paper are based. Bridge volumes are divided by the cubed grain diameter; all
// values here are dimensionless.
namespace pendular {

/// Friction coefficients of the parameter study. Source: Badetti et al. (2018), Table 2.
inline constexpr std::array paper_frictions = {0.05, 0.09, 0.15, 0.20, 0.25};

/// Bridge volume of the parameter study with its liquid content.
struct PaperContent {
    double bridge_volume;
    double liquid_content;  ///< Phi_L/Phi_S, stated at P* = 3
};
/// Bridge volumes of the parameter study. Source: Badetti et al. (2018), Table 1.
inline constexpr std::array<PaperContent, 5> paper_contents = {
    {{5e-4, 0.003}, {1e-3, 0.007}, {2e-3, 0.014}, {4e-3, 0.030}, {8e-3, 0.063}}};

/// Simulated state of wet grains, with the stress ratio of dry grains of its friction coefficient
/// and inertial number, from which the closures of Badetti et al. (2018) predict its strength.
class PaperState {
  public:
    /// Combines a run with the stress ratio of dry grains.
    /// @param stress_ratio_error standard error of the run's stress ratio, including the scatter
    ///        between runs of different seeds
    PaperState(dem::RunResult run, const Mean& dry_stress_ratio, double stress_ratio_error);

    const dem::RunResult& run() const { return run_; }
    /// Returns a name such as "friction 0.09, V0/a^3 0.002, P* 3".
    std::string name() const;
    double friction() const { return run_.parameters.friction; }
    double bridge_volume() const { return run_.parameters.wetting->bridge_volume; }
    double reduced_pressure() const { return run_.parameters.wetting->reduced_pressure; }
    const Mean& dry_stress_ratio() const { return dry_stress_ratio_; }
    /// Returns the averages over the run from which the closures compute stresses.
    const closures::State& network() const { return network_; }
    /// Returns the contributions of the bridge forces to the stress, divided by F0/a^2 (F0:
    /// pull-off force, a: grain diameter).
    const closures::CapillaryStress& capillary() const { return capillary_; }

    /// Returns the mean of an observable, with the error of the constructor for the stress ratio.
    Mean operator[](dem::Observable which) const;
    /// Returns the solid fraction, corrected to grains of infinite stiffness.
    Mean rigid_solid_fraction() const;
    /// Returns the result of a closure, such as `closure(&closures::ClosureValues::strength2)`. Its
    /// standard error contains only those of the stress ratios of the state and of dry grains.
    Mean closure(double closures::ClosureValues::*value) const;

  private:
    dem::RunResult run_;
    Mean dry_stress_ratio_;
    double stress_ratio_error_;
    closures::State network_;
    closures::CapillaryStress capillary_;
};

/// Straight line mu* = intercept + c*/P* through the stress ratios mu* of states of one friction
/// coefficient and bridge volume at reduced pressures P* >= 2.3, weighted with the inverse
/// variances of mu*. The slope c* is the reduced cohesion.
/// Source: Badetti et al. (2018), Eq. (16).
struct StrengthLine {
    double friction = 0, bridge_volume = 0;
    Mean intercept, cohesion;
    double covariance = 0;  ///< of the errors of intercept and cohesion
    int points = 0;         ///< number of states

    /// Returns the stress ratio on the line.
    Mean at(double reduced_pressure) const;
};

/// Stiffness number of the simulations of Badetti et al. (2018).
inline constexpr double paper_stiffness = 8400;

/// Whether two values of a parameter of the study are equal up to rounding.
bool same_setting(double a, double b);

/// State of the parameter study that no run simulates.
struct MissingState {
    double friction, bridge_volume, reduced_pressure;
};

/// Runs of atlas and store that belong to the parameter study of Badetti et al. (2018).
class PaperStudy {
  public:
    /// Selects runs that can train an emulator (`emulated::usable`), without effects, with a
    /// friction coefficient and a bridge volume of the parameter study and an inertial number of at
    /// most 0.0035. Of several runs of one state, those with a stiffness number within a factor of
    /// 2 of `paper_stiffness` have precedence, then the one with the most grains. Results at other
    /// stiffness numbers are converted to `paper_stiffness` by the emulator, with the error of the
    /// conversion added, unless Emulator::knows_stiffness() is false.
    /// @param emulator trained on `runs`; must outlive this object
    PaperStudy(const std::vector<dem::RunResult>& runs, const Emulator& emulator);

    /// Returns the states, sorted by friction coefficient, bridge volume and reduced pressure.
    const std::vector<PaperState>& states() const { return states_; }
    /// Returns the number of states whose run needs no conversion of the stiffness number.
    std::size_t stiff() const { return stiff_; }
    /// Returns the states that satisfy `condition`, in the order of states().
    std::vector<const PaperState*> where(
        const std::function<bool(const PaperState&)>& condition) const;
    /// Returns a state; null if no run simulates it.
    const PaperState* at(double friction, double bridge_volume, double reduced_pressure) const;
    /// Returns the runs of dry grains that can train an emulator, without effects, sorted by
    /// friction coefficient and inertial number.
    const std::vector<dem::RunResult>& dry_runs() const { return dry_runs_; }
    /// Returns a line for each friction coefficient and bridge volume with three or more states at
    /// P* >= `lowest_cohesion_pressure`.
    const std::vector<StrengthLine>& lines() const { return lines_; }
    /// Returns a line; null if none was fitted.
    const StrengthLine* line(double friction, double bridge_volume) const;
    /// Returns the mean of a closure over the states of `line`. Its standard error is the mean of
    /// theirs: they count as fully correlated, since they come mostly from the stress ratio of dry
    /// grains, which the states have in common.
    Mean mean_over(const StrengthLine& line, double closures::ClosureValues::*value) const;
    /// Returns values of dry grains at the inertial number 0 by the emulator; the solid fraction is
    /// that of rigid grains.
    Mean dry_stress_ratio(double friction) const;
    Mean dry_solid_fraction(double friction) const;
    /// Returns the mean of an observable of dry grains at `paper_stiffness` by the emulator; the
    /// solid fraction is that of rigid grains.
    Mean dry(dem::Observable which, double friction, double inertial_number) const;
    /// Returns the combinations of `paper_frictions`, `paper_contents` and `paper_pressures` that
    /// no run simulates.
    std::vector<MissingState> missing() const;

  private:
    /// Returns one state for each setting among `runs`, and counts `stiff_`.
    std::vector<PaperState> states_of(std::vector<dem::RunResult> runs);
    /// Returns the states at reduced pressures of at least `lowest_cohesion_pressure`.
    std::vector<const PaperState*> line_states(double friction, double bridge_volume) const;
    void fit_lines();

    const Emulator& emulator_;
    std::size_t stiff_ = 0;
    std::vector<PaperState> states_;
    std::vector<dem::RunResult> dry_runs_;
    std::vector<StrengthLine> lines_;
};

/// Inertial number at which Pendular simulates the states: the shear still counts as slow
/// (`PaperStudy`), in a third of the time of 0.001, the inertial number of Badetti et al. (2018).
inline constexpr double grid_inertial_number = 0.003;
/// Reduced pressures at which Pendular repeats the simulations. Badetti et al. (2018) state only
/// that the range begins at 0.5; the other values were chosen here.
inline constexpr std::array paper_pressures = {0.5, 1.0, 2.0, 3.0, 5.0, 10.0};

}  // namespace pendular
