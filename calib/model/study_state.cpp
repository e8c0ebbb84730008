#include "calib/model/study_state.h"

namespace pendular {

double inverse_pressure_of(const EffectiveCondition& condition, const Study& study) {
    const Liquid& liquid = condition.liquid ? *condition.liquid : study.liquid.value();
    return 1 / reduced_pressure(condition.normal_stress, study.grains, liquid);
}

dem::RunParameters run_at(const FlowState& state, const Study& study, const Fidelity& fidelity) {
    dem::RunParameters run{.friction = state.friction,
                           .inertial_number = state.inertial_number,
                           .stiffness_number = fidelity.stiffness_number,
                           .poisson_ratio = study.grains.poisson_ratio,
                           .grains = fidelity.grains,
                           .strain = fidelity.strain,
                           .effects = state.effects};
    if (!state.dry()) {
        run.wetting = {1 / state.inverse_pressure, state.bridge_volume, study.model.bridge_force};
    }
    return run;
}

double stiffness_number_of(const Condition& condition, const GrainProperties& grains,
                           const Fidelity& fidelity) {
    return stiffness_number(condition.normal_stress, grains).value_or(fidelity.stiffness_number);
}

double stiffness_share(double simulated, const Condition& condition, const GrainProperties& grains,
                       const Fidelity& fidelity) {
    return 1 - simulated / stiffness_number_of(condition, grains, fidelity);
}

}  // namespace pendular
