#pragma once

#include <Eigen/Dense>
#include <cmath>
#include <random>
#include <vector>

#include "calib/fit/calibrate_study.h"
#include "calib/fit/calibration.h"
#include "calib/fit/study_model.h"
#include "tests/support/emulator_support.h"

/// Calibrated wet study whose runs and readings follow an invented flow law, so that no simulation
/// is needed and the right result of every test is known. The values of the law are close to those
/// of Badetti et al. (2018). `mu` is the friction [1], `u` is 1/P* [1] (0: dry), and `volume` is
/// the bridge volume divided by the cubed grain diameter [1].
namespace planted {

using namespace pendular;

constexpr double friction = 0.09, bridge_volume_unit = 2e-3;
inline const std::vector<double> contents = {0.003, 0.007, 0.014, 0.030, 0.063};
inline const std::vector<double> pressures = {0.8, 1.5, 2.3, 4, 8, 16};

/// Logarithmic coordinate of a friction coefficient `mu` [1], ln[(mu + 0.05)/(0.09 + 0.05)]. It is
/// 0 at the friction of the study, 0.09.
inline double friction_coordinate(double mu) {
    return std::log((mu + 0.05) / (friction + 0.05));
}
inline double dry_ratio(double mu) {
    return 0.257 + 0.12 * friction_coordinate(mu);
}
inline double contact_coordination(double mu) {
    return 5.2 - 0.4 * friction_coordinate(mu);
}
inline double distant_coordination(double volume) {
    return 2 + 0.7 * std::log(volume / bridge_volume_unit);
}
/// Effective coordination number Z* = Z_c + 0.5 Z_d [1] of the invented flow law, with the numbers
/// of contacts Z_c and of distant bridges Z_d per grain.
inline double effective_coordination(double mu, double volume) {
    return contact_coordination(mu) + 0.5 * distant_coordination(volume);
}
/// Capillary shear stress of the invented flow law, multiplied by the squared grain diameter and
/// divided by the pull-off force [1].
inline double capillary_shear_stress(double mu, double volume) {
    return 0.05 - 0.03 * std::log(volume / bridge_volume_unit) + 0.02 * friction_coordinate(mu);
}
inline double solid_fraction(double mu, double u) {
    return 0.615 - 0.02 * friction_coordinate(mu) - 0.021 * u;
}
/// Stress ratio of the invented flow law [1]. As a function of u, the stress ratio bends below a
/// straight line, as the data of Badetti et al. (2018) do below P* = 2.3.
inline double stress_ratio(double mu, double u, double volume) {
    const double cohesion = 0.29 + 0.035 * std::log(volume / bridge_volume_unit);
    return dry_ratio(mu) + cohesion * u - 0.028 * u * u;
}
/// Volume V0 of a liquid bridge divided by the cubed grain diameter [1], at a liquid content
/// `content` [1] and the friction of the study: the solution of
///     content = 3 Z V0/pi,
/// where the coordination number Z of contacts and distant bridges depends on V0.
inline double volume_of(double content) {
    double volume = bridge_volume_unit;
    for (int k = 0; k < 100; ++k) {
        volume =
            content * M_PI / (3 * (contact_coordination(friction) + distant_coordination(volume)));
    }
    return volume;
}

/// Returns a study of 500 um grains with a liquid, without readings.
inline Study study() {
    Study s;
    s.grains = {.diameter = 5e-4, .density = 1050};
    s.liquid = Liquid{.surface_tension = 20.6e-3};
    return s;
}
/// Normal stress [Pa] at a reduced pressure [1] in the study.
inline double normal_stress(double pressure) {
    const Study s = study();
    return pressure / reduced_pressure(1, s.grains, *s.liquid);
}

/// Returns a run whose averages follow the invented flow law exactly, with stated standard errors.
inline dem::RunResult run(double mu, double u, double volume) {
    dem::RunResult r;
    r.parameters.friction = mu;
    r.parameters.inertial_number = 3e-3;
    r.steady = true;
    const auto set = [&](dem::Observable which, double value, double error = 0) {
        r.means[static_cast<std::size_t>(which)] = {value, error};
    };
    set(dem::Observable::stress_ratio, stress_ratio(mu, u, volume), 0.003);
    set(dem::Observable::solid_fraction, solid_fraction(mu, u), 0.0005);
    set(dem::Observable::contact_coordination, contact_coordination(mu), 0.01);
    set(dem::Observable::overlap, 3e-3, 3e-5);
    if (u > 0) {
        r.parameters.wetting = {1 / u, volume};
        set(dem::Observable::distant_coordination, distant_coordination(volume), 0.01);
        set(dem::Observable::effective_coordination, effective_coordination(mu, volume), 0.01);
        set(dem::Observable::capillary_shear_stress, capillary_shear_stress(mu, volume) * u, 1e-4);
    }
    return r;
}

/// Returns dry and wet runs that follow the invented flow law, at five frictions around that of the
/// study.
inline std::vector<dem::RunResult> runs() {
    std::vector<dem::RunResult> result;
    for (const double mu : {0.06, 0.075, 0.09, 0.11, 0.13}) {
        result.push_back(run(mu, 0, bridge_volume_unit));
        for (const double volume : {5e-4, 2e-3, 8e-3}) {
            for (const double u : {0.1, 0.5, 1.25}) {
                result.push_back(run(mu, u, volume));
            }
        }
    }
    return result;
}

/// Returns a reading that follows the invented flow law with random errors: standard errors of 2 %
/// of the shear stress and of 0.002 in the solid fraction.
/// @param pressure reduced pressure [1], from which the normal stress follows for dry readings too
/// @param content liquid content [1]; 0: dry
inline Reading reading(double pressure, double content, std::mt19937_64& random,
                       double inertial_number = 3e-3) {
    std::normal_distribution<double> noise;
    Reading r;
    r.origin = {"points.csv", 1};
    r.condition = {.normal_stress = normal_stress(pressure),
                   .inertial_number = inertial_number,
                   .liquid_content = content};
    const double u = content > 0 ? 1 / pressure : 0;
    const double ratio = stress_ratio(friction, u, content > 0 ? volume_of(content) : 1),
                 error = 0.02 * ratio;
    r.value << (ratio + error * noise(random)) * r.condition.normal_stress,
        solid_fraction(friction, u) + 0.002 * noise(random);
    r.covariance << std::pow(error * r.condition.normal_stress, 2), 0, 0, 4e-6;
    return r;
}

/// Returns three dry readings, then for each liquid content one wet reading at each of `pressures`;
/// all follow the invented flow law with random errors.
inline std::vector<Reading> readings(const std::vector<double>& wet_contents = contents) {
    std::mt19937_64 random(3);
    std::vector<Reading> result;
    for (const double pressure : {4.0, 8.0, 16.0}) {
        result.push_back(reading(pressure, 0, random));
    }
    for (const double content : wet_contents) {
        for (const double pressure : pressures) {
            result.push_back(reading(pressure, content, random));
        }
    }
    return result;
}

/// Returns a calibration of readings whose emulator is trained on `runs()`. Its fitted friction is
/// set to the true one of the readings, with a standard error of 0.004.
inline Calibration calibration(const std::vector<Reading>& readings,
                               const CohesionOptions& cohesion = {}) {
    Calibration c{.readings = readings,
                  .grains = study().grains,
                  .liquid = study().liquid,
                  .fidelity = {"planted", 2000, 1000, 3e-3, 10}};
    c.fitted = fitted_count(study(), readings);
    c.runs = runs();
    c.hyperparameters = shipped_hyperparameters();
    c.fit.parameters = Eigen::VectorXd::Constant(1, friction);
    c.fit.covariance = Eigen::MatrixXd::Constant(1, 1, 0.004 * 0.004);
    c.fit.measurement_part = c.fit.run_part = c.fit.covariance / 2;
    c.fit.at_bound = {false};
    c.parameters = {{.name = "friction", .lower = 0, .upper = 1, .start = friction}};
    c.fit.converged = true;
    const StudyModel model(study(), c);
    c.prediction = predict_readings(model.model(), c);
    c.cohesion = cohesion;
    add_cohesion_lines(model.model(), c);
    return c;
}

}  // namespace planted
