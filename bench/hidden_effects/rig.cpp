#include "bench/hidden_effects/rig.h"

namespace pendular::bench {

Fidelity truth_fidelity() {
    return {.name = "hidden-effects",
            .grains = 800,
            .stiffness_number = 1500,
            .lowest_inertial_number = 3e-3,
            .strain = 3};
}

LabPlan rig(double friction, std::uint64_t world) {
    LabPlan plan{.friction = friction,
                 .dry_normal_stresses = {280, 900, 3200},
                 .wet_normal_stresses = {280, 1800},
                 .liquid_contents = {0.006, 0.014, 0.03},
                 .inertial_numbers = {0.013, 0.045},
                 .fidelity = truth_fidelity(),
                 .seed = world};
    // Runs this short scatter by 0.4 to 1.1 % in shear stress, wet ones less. An instrument that
    // scatters no more would leave all noise to them: uneven, and the same in all studies of a
    // world.
    plan.instrument.noise = 2;
    plan.instrument.drift = 0.6;
    return plan;
}

std::vector<Condition> planned_conditions(const LabPlan& plan) {
    std::vector<Condition> all;
    for (const PlannedRecording& recording : recordings_of(plan)) {
        for (Condition condition : recording.conditions) {
            constexpr double typical = 0.6;
            condition.bead_volume = plan.cell.bead_volume;
            condition.height = height(typical, plan.cell);
            all.push_back(condition);
        }
    }
    return all;
}

Study study_of(const LabPlan& plan) {
    Study study;
    study.grains = plan.grains;
    study.liquid = plan.liquid;
    study.cell = plan.cell;
    for (const double content : contents_of(plan)) {
        Source source;
        source.liquid_content = content;
        study.sources.push_back(source);
    }
    return study;
}

}  // namespace pendular::bench
