#pragma once

#include <fmt/format.h>

#include <cmath>
#include <functional>
#include <random>
#include <string>
#include <vector>

#include "data/annular_cell.h"
#include "data/recordings/recording.h"

namespace pendular {

/// Random errors of the recordings that `ordinary_recording` simulates, of the size that a careful
/// experimenter has.
struct OrdinaryNoise {
    double torque = 0.03;  ///< relative standard deviation of torque within a step
    double force = 0.002;  ///< relative standard deviation of the normal force
    double gap = 0.002;    ///< relative standard deviation of the gap
    /// Number of rows over which the correlation of the noise falls to 1/e (first-order
    /// autoregression).
    double correlation_rows = 2;
    double filling = 0.01;         ///< relative scatter of the torque between files
    double step = 0.005;           ///< relative scatter of the torque between steps of a file
    double torque_resolution = 0;  ///< rounding of the torque [N m]; 0: none
};

/// Annular cell of the simulated recordings: radii of 21 and 45 mm, 20 g of polystyrene beads.
inline const AnnularCell ordinary_cell{
    .inner_radius = 0.021, .outer_radius = 0.045, .bead_volume = 0.02 / 1050};

/// One row of a simulated recording: torque [N m], normal force [N] and gap [m], which a test may
/// change, with the time [s] and the rotation angle of the lid [rad] since the step began.
struct RowOfStep {
    double time, angle;
    double &torque, &force, &gap;
};
/// Function that changes one row of a simulated recording, such as to imitate a fault. `step` is
/// the index of the row's step, from 0.
using Spoil = std::function<void(RowOfStep row, int step)>;

/// Simulates a recording of three steps at normal stresses of 0.5, 1 and 2 kPa. Each step has 450
/// rows, 0.2 s apart, and begins with a transient of 4 s. The lid turns at 0.18 to 0.35 turns per
/// second.
/// @param file name of the file that the recording states
/// @param spoil function that changes each row after the noise; empty: no row is changed
inline Recording ordinary_recording(const std::string& file, std::uint64_t seed,
                                    const OrdinaryNoise& noise = {}, const Spoil& spoil = {}) {
    std::mt19937_64 random(seed);
    std::normal_distribution<double> normal;
    const double keep = std::exp(-1 / noise.correlation_rows),
                 area = M_PI * (0.045 * 0.045 - 0.021 * 0.021);
    const double of_file = 1 + noise.filling * normal(random);
    Recording r;
    r.file = file;
    for (int step = 0; step < 3; ++step) {
        const double stress = 500 * std::pow(2, step), rate = 0.25 * std::sqrt(stress / 1000.0);
        const double level =
            torque(0.29 * stress, ordinary_cell) * of_file * (1 + noise.step * normal(random));
        double a = normal(random), b = normal(random), c = normal(random);
        for (int k = 0; k < 450; ++k) {
            const auto next = [&](double& x) {
                x = keep * x + std::sqrt(1 - keep * keep) * normal(random);
            };
            next(a), next(b), next(c);
            const double time = 0.2 * k, fading = std::exp(-time / 4);
            double t = level * (1 + 0.35 * fading - 1.1 * std::exp(-time / 0.5) + noise.torque * a);
            double f = area * stress * (1 + noise.force * b);
            double h = 6.15e-3 * (1 - 0.02 * fading + noise.gap * c);
            const double speed = 2 * M_PI * rate;  // rate in turns a second
            if (spoil) spoil({time, speed * time, t, f, h}, step);
            if (noise.torque_resolution > 0)
                t = noise.torque_resolution * std::round(t / noise.torque_resolution);
            r.line.push_back(static_cast<int>(r.line.size()) + 2);
            r.time.push_back(90 * step + time);
            r.torque.push_back(t);
            r.normal_force.push_back(f);
            r.height.push_back(h);
            r.angular_velocity.push_back(speed);
            r.interval.push_back(step + 1);
        }
    }
    return r;
}

/// Returns a recording as the text of a CSV file, with up to seven significant digits.
inline std::string csv_of(const Recording& r) {
    std::string text =
        "Time [s],Torque [mN m],Normal force [N],Gap [mm],Angular velocity [rad/s],Interval [1]\n";
    for (std::size_t k = 0; k < r.size(); ++k)
        text +=
            fmt::format("{:.6g},{:.7g},{:.7g},{:.7g},{:.7g},{:g}\n", r.time[k], 1e3 * r.torque[k],
                        r.normal_force[k], 1e3 * r.height[k], r.angular_velocity[k], r.interval[k]);
    return text;
}

}  // namespace pendular
