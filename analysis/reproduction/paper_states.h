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

/// Intergranular frictions of the parameter study [1]. Source: Badetti et al. (2018), tab:symbols.
inline constexpr std::array paper_frictions = {0.05, 0.09, 0.15, 0.20, 0.25};

/// A bridge volume of the parameter study with the liquid content that names it.
struct PaperContent {
    double bridge_volume;   ///< V0/a^3 [1]
    double liquid_content;  ///< Phi_L/Phi_S at P* = 3 [1]
};
/// Bridge volumes of the parameter study. Source: Badetti et al. (2018), tab:philphis.
inline constexpr std::array<PaperContent, 5> paper_contents = {
    {{5e-4, 0.003}, {1e-3, 0.007}, {2e-3, 0.014}, {4e-3, 0.030}, {8e-3, 0.063}}};

/// Simulated state of wet grains, together with the stress ratio of dry grains of the same friction
/// and inertial number. From both, the closures (formulas) of Badetti et al. (2018) predict the
/// strength of the wet grains. All values are dimensionless.
class PaperState {
  public:
    /// @param dry_stress_ratio stress ratio of dry grains at the run's friction and inertial number
    /// @param stress_ratio_error standard error of the run's stress ratio, with the scatter between
    ///        runs
    PaperState(dem::RunResult run, const Mean& dry_stress_ratio, double stress_ratio_error);

    const dem::RunResult& run() const { return run_; }
    /// Text that names the state: "friction 0.09, V0/a^3 0.002, P* 3".
    std::string name() const;
    double friction() const { return run_.parameters.friction; }
    double bridge_volume() const { return run_.parameters.wetting->bridge_volume; }
    double reduced_pressure() const { return run_.parameters.wetting->reduced_pressure; }
    /// Stress ratio of dry grains at this friction and inertial number [1].
    const Mean& dry_stress_ratio() const { return dry_stress_ratio_; }
    /// Averages of the run (solid fraction, coordination numbers, fabric, bridge forces) from which
    /// the closures compute stresses.
    const closures::State& network() const { return network_; }
    /// Capillary stresses measured in the run, over F0/a^2 [1].
    const closures::CapillaryStress& capillary() const { return capillary_; }

    /// Observable of the run with its standard error. The standard error of the stress ratio
    /// includes the scatter between runs of different seeds.
    Mean operator[](dem::Observable which) const;
    /// Solid fraction of the run, corrected to grains of infinite stiffness [1].
    Mean rigid_solid_fraction() const;
    /// Value of a closure, as in `closure(&closures::ClosureValues::strength2)`, with the part of
    /// its standard error that comes from the stress ratios of this state and of dry grains.
    Mean closure(double closures::ClosureValues::*value) const;

  private:
    dem::RunResult run_;
    Mean dry_stress_ratio_;
    double stress_ratio_error_;
    closures::State network_;
    closures::CapillaryStress capillary_;
};

/// Straight line mu* = intercept + c*/P* through the stress ratios of one friction and bridge
/// volume at P* >= 2.3, weighted by their standard errors (eq:mohrcoulomb2).
struct StrengthLine {
    double friction = 0, bridge_volume = 0;  ///< friction and V0/a^3 [1]
    Mean intercept, cohesion;                ///< intercept and reduced cohesion c* [1]
    double covariance = 0;                   ///< covariance of intercept and c* [1]
    int points = 0;                          ///< number of states that the line is fitted to

    /// Stress ratio of the line at a reduced pressure [1], with its standard error.
    Mean at(double reduced_pressure) const;
};

/// Lowest reduced pressure P* of the states to which lines are fitted [1]. Source: Badetti et al.
/// (2018), Measurement of a macroscopic cohesion.
inline constexpr double lowest_line_pressure = 2.3;

/// Stiffness number of the simulations of Badetti et al. (2018) [1].
inline constexpr double paper_stiffness = 8400;

/// Whether two frictions, bridge volumes or reduced pressures [1] are those of one state.
bool same_setting(double a, double b);

/// A state of the parameter study that has not been simulated.
struct MissingState {
    double friction, bridge_volume, reduced_pressure;  ///< mu, V0/a^3 and P* [1]
};

/// Simulations of the parameter study of Badetti et al. (2018) that are in the atlas or the store.
class PaperStudy {
  public:
    /// Takes the usable runs without effects at the frictions and bridge volumes of the study and
    /// inertial numbers up to 0.0035. Of several runs of one state, one within a factor 2 of the
    /// paper's stiffness number counts, else that with the most grains. Runs of other stiffness
    /// numbers are changed to the paper's by the emulator, with the error of the change, so that no
    /// trend is one of stiffness; an emulator that knows no such change leaves them as they are.
    /// @param runs runs of atlas and store
    /// @param emulator emulator trained on them; must outlive this object
    PaperStudy(const std::vector<dem::RunResult>& runs, const Emulator& emulator);

    /// The states, in the order of friction, bridge volume and reduced pressure.
    const std::vector<PaperState>& states() const { return states_; }
    /// Number of the states that were simulated within a factor 2 of the paper's stiffness number.
    std::size_t stiff() const { return stiff_; }
    /// States that fulfil a condition.
    std::vector<const PaperState*> where(
        const std::function<bool(const PaperState&)>& condition) const;
    /// State of a friction, bridge volume and reduced pressure; null where no run simulates it.
    const PaperState* at(double friction, double bridge_volume, double reduced_pressure) const;
    /// Dry runs without effects, in the order of friction and inertial number.
    const std::vector<dem::RunResult>& dry_runs() const { return dry_runs_; }
    /// Straight lines mu*(1/P*), one for each friction and bridge volume with three or more states
    /// at P* of `lowest_line_pressure` or above.
    const std::vector<StrengthLine>& lines() const { return lines_; }
    const StrengthLine* line(double friction, double bridge_volume) const;
    /// Mean of a closure over the states of a line. Its standard error is the mean of the states'
    /// standard errors: these are taken as fully correlated, since most of each comes from the one
    /// stress ratio of dry grains.
    Mean mean_over(const StrengthLine& line, double closures::ClosureValues::*value) const;
    /// Stress ratio and solid fraction of rigid dry grains [1] in the limit of slow shear, by the
    /// emulator.
    Mean dry_stress_ratio(double friction) const;
    Mean dry_solid_fraction(double friction) const;
    /// Stress ratio and solid fraction of rigid dry grains at an inertial number [1].
    Mean dry(dem::Observable which, double friction, double inertial_number) const;
    /// States of the paper's grid of frictions, bridge volumes and reduced pressures (P* = 0.5, 1,
    /// 2, 3, 5 and 10) that have not been simulated.
    std::vector<MissingState> missing() const;

  private:
    /// One state for each friction, bridge volume and reduced pressure of runs.
    std::vector<PaperState> states_of(std::vector<dem::RunResult> runs);
    /// States of a friction and bridge volume at P* of `lowest_line_pressure` or above.
    std::vector<const PaperState*> line_states(double friction, double bridge_volume) const;
    void fit_lines();

    const Emulator& emulator_;
    std::size_t stiff_ = 0;
    std::vector<PaperState> states_;
    std::vector<dem::RunResult> dry_runs_;
    std::vector<StrengthLine> lines_;
};

/// Inertial number of the grid of simulations [1]: slow enough, and three times as fast to simulate
/// as the 0.001 of Badetti et al. (2018).
inline constexpr double grid_inertial_number = 0.003;
/// Reduced pressures of the grid of simulations [1]. Badetti et al. (2018) state the range from 0.5
/// up only.
inline constexpr std::array paper_pressures = {0.5, 1.0, 2.0, 3.0, 5.0, 10.0};

}  // namespace pendular
