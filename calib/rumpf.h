#pragma once

#include "calib/simulation_model.h"
#include "sim/closures/strength.h"
#include "sim/closures/terms.h"

namespace pendular {

/// Base `rumpf`: the simulated dry law with the cohesion of Rumpf's formula, its solid fraction and
/// coordination simulated,
///     mu* = mu*_dry(mu, I) [1 + Phi_S Z*/(pi P*)]                          (eq:strength3)
/// or, with the capillary shear stress, that less a^2 s12cap/(F0 P*) (eq:strength2).
/// Dry readings and all solid fractions are those of the simulation. It neglects the shear stress
/// that capillary forces carry where it is left out, and is then too high at little liquid. The
/// error of Z*, a few per mille, is not in its covariance. Source: Badetti et al. (2018),
/// eq:strength3 and eq:cohesion3, after Rumpf.
class RumpfModel : public FlowModel {
  public:
    /// `simulation` must outlive it.
    RumpfModel(SimulationModel& simulation, const Study& study, const closures::Terms& terms = {})
        : simulation_(simulation), study_(study), terms_(terms) {}

    const std::vector<Parameter>& parameters() const override { return simulation_.parameters(); }
    Prediction predict_conditions(const Eigen::VectorXd& parameters,
                                  const std::vector<Condition>& conditions) const override {
        return ask(parameters, conditions, &FlowModel::predict_conditions);
    }
    Prediction predict_mean_conditions(const Eigen::VectorXd& parameters,
                                       const std::vector<Condition>& conditions) const override {
        return ask(parameters, conditions, &FlowModel::predict_mean_conditions);
    }
    Eigen::VectorXd values_of_conditions(const Eigen::VectorXd& parameters,
                                         const std::vector<Condition>& conditions) const override;
    void improve(const Eigen::VectorXd& parameters, double excess) override;
    void learn_wet(const Eigen::VectorXd& parameters, int turns) override {
        simulation_.learn_wet(parameters, turns);
    }
    Supported supported() const override { return simulation_.supported(); }
    bool confirmed() const override { return simulation_.confirmed(); }

  private:
    /// What of the simulation is asked: with covariances or without.
    using Ask = Prediction (FlowModel::*)(const Eigen::VectorXd&,
                                          const std::vector<Condition>&) const;
    Prediction ask(const Eigen::VectorXd& parameters, const std::vector<Condition>& conditions,
                   Ask what) const;
    /// What the closure makes of a wet condition.
    struct Closure {
        StructureResponse z, shear;  ///< Z* and a^2 s12cap/F0
        double pressure = 0;         ///< P*
        /// Shear stress [Pa] with Rumpf's cohesion alone, of the dry one and the solid fraction.
        double rumpf_stress(double dry, double fraction, const Condition& condition) const;
    };
    Closure closure_at(double friction, const Condition& condition) const;

    SimulationModel& simulation_;
    Study study_;
    closures::Terms terms_;
};

/// Conditions, then a dry twin of each wet one in their order, which gives the dry law at the
/// friction of the wet grains; effects on grains that need liquid are off there.
std::vector<Condition> with_dry_twins(const std::vector<Condition>& conditions);

}  // namespace pendular
