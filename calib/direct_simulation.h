#pragma once

#include <cstdint>
#include <vector>

#include "calib/model.h"
#include "calib/response_surface.h"
#include "data/reading.h"
#include "data/study.h"
#include "sim/ensemble.h"
#include "sim/fidelity.h"

namespace pendular {

/// The discrete-element solver as a model of dry readings; its parameter is the friction.
///
/// Runs are made near where a fit has arrived (improve), at a few inertial numbers that span the
/// readings'; a response surface through all runs so far gives smooth predictions, their
/// derivatives and their covariance. A reading in the quasi-static limit, or slower than the
/// fidelity simulates, is extrapolated in the inertial number. Solid fractions are corrected from
/// the simulated to the study's stiffness number by the overlaps measured in each run. Both
/// corrections add their errors to the covariance, common to all readings.
class DirectSimulation : public Model {
  public:
    DirectSimulation(const Study& study, const std::vector<Condition>& conditions,
                     const Fidelity& fidelity, std::uint64_t seed, Workers workers);

    const std::vector<Parameter>& parameters() const override { return parameters_; }
    Prediction predict(const Eigen::VectorXd& parameters) const override;
    void improve(const Eigen::VectorXd& parameters, double excess) override;
    Supported supported() const override;

    /// Inertial numbers at which runs are made.
    const std::vector<double>& inertial_numbers() const { return inertial_numbers_; }
    /// All runs made so far, crystallised ones included: those are not used.
    const std::vector<dem::RunResult>& runs() const { return runs_; }
    /// Lines the user should read, such as runs left out.
    const std::vector<std::string>& notes() const { return notes_; }

    /// Takes the runs of an earlier calibration in place of making its own, centred as it was.
    void restore(const std::vector<dem::RunResult>& runs, double centre);
    /// Friction at which the response surface is centred.
    double centre() const { return centre_; }

    /// (stress ratio, solid fraction) with their covariance.
    struct Point {
        Eigen::Vector2d value;
        Eigen::Matrix2d covariance;
    };
    /// Prediction for any dry condition, for curves.
    Point predict_at(double friction, const Condition& condition) const;

    /// Share of the rigidity shift that separates the simulated from the study's stiffness [1].
    double stiffness_share(const Condition& condition) const;

  private:
    void carry_out(const std::vector<double>& frictions, double strain);
    void add(const dem::RunResult& run);
    void renew_surfaces(double centre, double half_width);
    Prediction predict(const Eigen::VectorXd& parameters,
                       const std::vector<Condition>& conditions) const;

    Grains grains_;
    std::vector<Condition> conditions_;
    Fidelity fidelity_;
    std::uint64_t seed_;
    Workers workers_;
    std::vector<Parameter> parameters_;
    std::vector<double> inertial_numbers_;
    std::vector<dem::RunResult> runs_;
    std::vector<SurfacePoint> points_;
    std::vector<ResponseSurface> surfaces_;  ///< best exponent first, then the two extreme ones
    std::vector<std::string> notes_;
    double centre_ = 0;
    std::uint64_t ordered_ = 0;  ///< runs ordered so far, each with a seed of its own
    std::size_t placed_ = 0;     ///< sets of runs placed around a centre so far
};

/// Inertial numbers to simulate for readings at these: one where they agree within 5 %, else
/// enough, evenly spaced in the logarithm, that neighbours differ by a factor 10/3 at most. Never
/// below `lowest`; where a reading is, or is quasi-static (0), at least two to extrapolate from.
std::vector<double> inertial_numbers_for(const std::vector<Condition>& conditions, double lowest);

}  // namespace pendular
