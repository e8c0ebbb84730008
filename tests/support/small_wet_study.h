#pragma once

#include <Eigen/Core>

#include "data/grains.h"
#include "data/study/study.h"
#include "sim/runs/fidelity.h"

/// Wet study with beads and liquid of Badetti et al. (2018), and a fidelity for runs of a second.
namespace small_wet {

using namespace pendular;

/// Soft, small and fast: behaviour, not numbers.
inline const Fidelity tiny{"tiny", 150, 300, 0.03, 2};

/// P* = 1 is 129 Pa.
inline Study wet_study() {
    Study study;
    study.grains = {.diameter = 5e-4, .density = 1050};
    study.liquid = Liquid{.surface_tension = 20.6e-3};
    return study;
}

/// Condition of this study at a reduced pressure, liquid content and inertial number [1].
inline Condition condition(double reduced_pressure, double content, double inertial_number = 0.05) {
    const Study study = wet_study();
    const double unit = 1 / pendular::reduced_pressure(1, study.grains, *study.liquid);
    return {.normal_stress = reduced_pressure * unit,
            .inertial_number = inertial_number,
            .liquid_content = content};
}

/// Parameters of a model with the friction alone.
inline Eigen::VectorXd at(double friction) {
    return Eigen::VectorXd::Constant(1, friction);
}

}  // namespace small_wet
