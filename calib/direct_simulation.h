#pragma once

#include <cstdint>
#include <vector>

#include "calib/bridge_network.h"
#include "calib/response_surface.h"
#include "calib/run_design.h"
#include "calib/simulation_model.h"
#include "data/reading.h"
#include "data/study.h"
#include "sim/closures/terms.h"
#include "sim/ensemble.h"
#include "sim/fidelity.h"

namespace pendular {

/// The discrete-element solver as a model of dry and wet readings; its parameter is the friction.
///
/// Runs are made near where a fit has arrived (improve), at a few inertial numbers that span the
/// readings' and, for wet readings, at their reduced pressures and liquid contents; a response
/// surface through all dry runs, and one through all runs for wet readings, give smooth
/// predictions, their derivatives and their covariance. A reading in the quasi-static limit, or
/// slower than the fidelity simulates, is extrapolated in the inertial number. A liquid content is
/// turned into a bridge volume with the simulated coordination. Solid fractions are corrected from
/// the simulated to the study's stiffness number by the overlaps measured in each run. The
/// corrections add their errors to the covariance, common to all readings.
class DirectSimulation : public SimulationModel {
  public:
    /// Predicts `conditions` until `predict_for` says otherwise; runs span all of them.
    DirectSimulation(const Study& study, const std::vector<Condition>& conditions,
                     const Fidelity& fidelity, std::uint64_t seed, Workers workers);

    Prediction predict_conditions(const Eigen::VectorXd& parameters,
                                  const std::vector<Condition>& conditions) const override;
    void improve(const Eigen::VectorXd& parameters, double excess) override;
    Supported supported() const override;

    void learn_wet(const Eigen::VectorXd& parameters, int turns = 1) override;

    /// Inertial numbers at which dry runs are made.
    const std::vector<double>& inertial_numbers() const override { return inertial_numbers_; }
    /// All runs made so far, crystallised ones included: those are not used.
    const std::vector<dem::RunResult>& runs() const override { return runs_; }
    const std::vector<std::string>& notes() const override { return notes_; }

    /// Takes the runs of an earlier calibration in place of making its own, centred as it was.
    void restore(const std::vector<dem::RunResult>& runs, double centre);
    /// Friction at which the response surface is centred.
    double centre() const { return centre_; }

    StructureResponse effective_coordination(double friction,
                                             const Condition& condition) const override;
    StructureResponse capillary_shear_stress(double friction,
                                             const Condition& condition) const override;
    FlowState state_of(double friction, const Condition& condition) const override;

  private:
    /// Surfaces for one way in which the quasi-static limit is approached.
    struct Surfaces {
        ResponseSurface dry;
        ResponseSurface all;  ///< equal to `dry` where there are no wet runs
        const ResponseSurface& of(const FlowState& s) const { return s.dry() ? dry : all; }
    };
    struct Terms;

    void carry_out(std::vector<dem::RunParameters> wanted);
    void carry_out_dry(const std::vector<double>& frictions, double strain);
    void add(const dem::RunResult& run);
    void renew_surfaces(double centre, double half_width);
    Terms terms_of(double friction, const Condition& condition) const;

    Study study_;
    Fidelity fidelity_;
    std::uint64_t seed_;
    Workers workers_;
    std::vector<double> inertial_numbers_;
    std::vector<WetSetting> wet_settings_;
    std::vector<dem::RunResult> runs_;
    std::vector<SurfacePoint> points_;
    std::vector<Surfaces> surfaces_;  ///< best exponent first, then the two extreme ones
    BridgeNetwork network_;
    std::vector<std::string> notes_;
    double centre_ = 0, half_width_ = 0;
    std::uint64_t ordered_ = 0;     ///< runs ordered so far, each with a seed of its own
    std::uint64_t wet_rounds_ = 0;  ///< of wet runs so far
    std::size_t placed_ = 0;        ///< sets of dry runs placed around a centre so far
};

}  // namespace pendular
