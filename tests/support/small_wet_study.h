#pragma once

#include <Eigen/Core>

#include "data/grains.h"
#include "data/study/study.h"
#include "sim/runs/run_settings.h"

/// Wet study with beads and liquid of Badetti et al. (2018), and settings with which a simulation
/// takes about a second.
namespace small_wet {

using namespace pendular;

/// Settings for the smallest and fastest simulations: 150 grains, stiffness number 300, lowest
/// inertial number 0.03, strain 2. They suffice to test how the program behaves, but the results
/// are inaccurate.
inline const Fidelity tiny{"tiny", 150, 300, 0.03, 2};

/// Returns a study of 500 um grains with a liquid, without readings. A reduced pressure of 1 is a
/// normal stress of 129 Pa.
inline Study wet_study() {
    Study study;
    study.grains = {.diameter = 5e-4, .density = 1050};
    study.liquid = Liquid{.surface_tension = 20.6e-3};
    return study;
}

/// Returns the condition of `wet_study()` at a reduced pressure [1], a liquid content [1] and an
/// inertial number [1].
inline Condition condition(double reduced_pressure, double content, double inertial_number = 0.05) {
    const Study study = wet_study();
    const double unit = 1 / pendular::reduced_pressure(1, study.grains, *study.liquid);
    return {.normal_stress = reduced_pressure * unit,
            .inertial_number = inertial_number,
            .liquid_content = content};
}

/// Returns the parameters of a model whose only parameter is the friction [1].
inline Eigen::VectorXd at(double friction) {
    return Eigen::VectorXd::Constant(1, friction);
}

}  // namespace small_wet
