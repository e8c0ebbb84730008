#pragma once

#include <Eigen/Core>
#include <filesystem>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "calib/basis.h"
#include "calib/effect_response.h"
#include "calib/gaussian_process.h"
#include "calib/query.h"
#include "sim/dem/run.h"

namespace pendular {

/// What runs say of all the states between them: for each observable a Gaussian process over
/// friction, inertial number, reduced pressure and bridge volume, whose noise is the runs' own. The
/// stress ratio and the solid fraction of one run are correlated, and so are what is said of them.
/// Observables are those of runs but for two that depend on stiffness in a known way, so that runs
/// of any stiffness serve: the solid fraction is that of rigid beads and the overlap is that at the
/// stiffness number `reference_stiffness`. What else is told of structure is that of the runs it
/// was learned from, since it depends on stiffness weakly.
///
/// Effects on grains are learned apart, each from the runs that have it alone (EffectResponse), and
/// their changes add up; derivatives are those without effects.
class Emulator {
  public:
    static constexpr double reference_stiffness = 1000;

    /// Runs that failed, crystallised or were not steady are left out, and those of another damping
    /// than the standard. Scales that are missing are learned, half a second an observable.
    /// @throws std::invalid_argument where no run is left
    Emulator(const std::vector<dem::RunResult>& runs, EmulatorScales scales);
    ~Emulator();
    Emulator(Emulator&&) noexcept;
    Emulator& operator=(Emulator&&) noexcept;

    /// The same with more runs; nothing is learned anew.
    Emulator with(const std::vector<dem::RunResult>& more) const;

    /// Scales in use, those learned so far included.
    const EmulatorScales& scales() const { return scales_; }

    /// An entry for each query.
    /// @throws std::invalid_argument for an observable of bridges where no run was wet, or of a dry
    ///         state, and for an effect that no run has alone
    Eigen::VectorXd mean(const std::vector<Query>& queries) const;
    /// Covariance of the errors of that, a row and a column for each query.
    Eigen::MatrixXd covariance(const std::vector<Query>& queries) const;

    /// In what a state lies beyond all runs, as in "friction 0.9 is above 0.6"; empty where it does
    /// not. Slower flow than any run is extrapolated, with its error, and no matter of this.
    std::string beyond(const FlowState& state) const;

    /// Those that teach.
    const std::vector<dem::RunResult>& runs() const { return runs_; }

    /// Whether a run can teach.
    static bool usable(const dem::RunResult& run);
    /// What a run says of an observable, as emulated.
    static Mean taught(const dem::RunResult& run, dem::Observable which);
    static FlowState state_of(const dem::RunParameters& run);
    /// Variance of what a run says about what a longer one would: of the error it states and of the
    /// scatter between runs beyond that.
    double noise_variance(const dem::RunResult& run, dem::Observable which) const;

    /// The same of stress ratio and solid fraction together.
    Eigen::Matrix2d noise(const dem::RunResult& run) const;

    /// Whether an observable says nothing of dry beads.
    static bool of_bridges(dem::Observable which);
    /// All observables that are emulated.
    static const std::vector<dem::Observable>& observables();

    /// Whether any of these runs says something of an observable.
    static bool known(const std::vector<dem::RunResult>& runs, dem::Observable which);
    /// Scales of greatest likelihood for one observable.
    /// @throws std::invalid_argument where none does
    static Scales learn(const std::vector<dem::RunResult>& runs, dem::Observable which);

  private:
    const GaussianProcess& process_of(dem::Observable which) const;
    const EffectResponse& response_to(const std::string& effect, dem::Observable which) const;
    EffectResponse learn_response(const std::string& effect, dem::Observable which) const;
    Eigen::VectorXd plain_mean(const std::vector<Query>& queries) const;
    Eigen::MatrixXd plain_covariance(const std::vector<Query>& queries) const;
    struct Affected;
    std::vector<Affected> affected(const std::vector<Query>& queries) const;

    std::vector<dem::RunResult> runs_;
    mutable EmulatorScales scales_;
    mutable std::map<dem::Observable, std::unique_ptr<GaussianProcess>> processes_;
    mutable std::map<std::pair<std::string, dem::Observable>, EffectResponse> responses_;
};

/// Name of the file beside an atlas that keeps the scales learned from it.
constexpr const char* scales_name = "emulator.csv";

/// Reads scales from a table of a row per observable and a column per scale, and writes it.
/// @throws InputError at the cell that is wrong
EmulatorScales read_scales(const std::filesystem::path& file);
void write_scales(const std::filesystem::path& file, const EmulatorScales& scales);

}  // namespace pendular
