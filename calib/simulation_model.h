#pragma once

#include <algorithm>
#include <string>
#include <vector>

#include "calib/basis.h"
#include "calib/model.h"
#include "calib/structure_response.h"
#include "data/study.h"
#include "sim/dem/run.h"
#include "sim/fidelity.h"

namespace pendular {

/// A flow model made from simulation runs; its parameter is the friction.
class SimulationModel : public FlowModel {
  public:
    const std::vector<Parameter>& parameters() const override { return parameters_; }

    /// The runs it rests on.
    virtual const std::vector<dem::RunResult>& runs() const = 0;
    /// Lines the user should read, such as runs left out.
    virtual const std::vector<std::string>& notes() const = 0;
    /// Inertial numbers that span those of its dry conditions, none below the fidelity's lowest.
    virtual const std::vector<double>& inertial_numbers() const = 0;

    /// State to simulate for a condition: a wet one at the bridge volume that has its liquid
    /// content.
    virtual FlowState state_of(double friction, const Condition& condition) const = 0;
    /// Z* and a^2 s12cap/F0 at a wet condition; derivatives by friction at constant liquid content.
    virtual StructureResponse effective_coordination(double friction,
                                                     const Condition& condition) const = 0;
    virtual StructureResponse capillary_shear_stress(double friction,
                                                     const Condition& condition) const = 0;

  protected:
    /// The nearest friction that the parameter may take.
    double allowed(double friction) const {
        return std::clamp(friction, parameters_[0].lower, parameters_[0].upper);
    }

  private:
    std::vector<Parameter> parameters_{{.name = "friction", .lower = 0, .upper = 1, .start = 0.15}};
};

/// 1/P* of a wet condition, with the liquid that effects make of the study's.
double inverse_pressure_of(const Condition& condition, const Study& study);

/// A run of the beads of a study at a state, without a seed; over the fidelity's strain.
dem::RunParameters run_at(const FlowState& state, const Study& study, const Fidelity& fidelity);

/// Share of the rigidity shift of runs of a stiffness number that separates them from the beads of
/// the study at a condition [1]; from those of the fidelity, where the study names no modulus.
double stiffness_share(double simulated, const Condition& condition, const Grains& grains,
                       const Fidelity& fidelity);

}  // namespace pendular
