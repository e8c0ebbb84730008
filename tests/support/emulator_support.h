#pragma once

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <random>
#include <vector>

#include "calib/emulator/emulated_observables.h"
#include "calib/emulator/emulator.h"
#include "calib/emulator/known_runs.h"
#include "data/study/study.h"
#include "sim/runs/store/run_table.h"

namespace pendular {

/// Returns all runs of the atlas, with and without effects on grains.
inline std::vector<dem::RunResult> all_shipped_runs() {
    std::vector<dem::RunResult> runs;
    for (const StoredRun& stored : read_runs(PENDULAR_SOURCE_DIR "/sim/atlas/atlas.csv")) {
        runs.push_back(stored.run);
    }
    return runs;
}

/// Returns the runs of the atlas that have no effects on grains.
inline std::vector<dem::RunResult> shipped_runs() {
    std::vector<dem::RunResult> runs = all_shipped_runs();
    std::erase_if(runs, [](const auto& run) { return !run.parameters.effects.empty(); });
    return runs;
}

/// Returns the emulator's hyperparameters that come with the atlas.
inline EmulatorHyperparameters shipped_hyperparameters() {
    return read_hyperparameters(std::filesystem::path(PENDULAR_SOURCE_DIR "/sim/atlas") /
                                hyperparameters_name);
}

/// Returns a study with the grains and the liquid of Badetti et al. (2018). Its Young's modulus is
/// that of the grains themselves, 3.3 GPa.
inline Study stiff_wet_study() {
    Study study;
    study.grains = {
        .diameter = 5e-4, .density = 1050, .youngs_modulus = 3.3e9, .poisson_ratio = 0.3};
    study.liquid = Liquid{.surface_tension = 0.0206, .contact_angle = 0, .viscosity = 0.05};
    return study;
}

/// Invented flow law from which tests generate runs, so that the true values are known: stress
/// ratio [1] and solid fraction [1] as smooth functions of friction, inertial number, inverse
/// reduced pressure and bridge volume.
struct InventedLaw {
    static double stress_ratio(const FlowState& s) {
        const double dry =
            0.1 + 0.3 * s.friction / (s.friction + 0.15) + std::pow(s.inertial_number, 0.75);
        return dry +
               (s.dry() ? 0
                        : s.inverse_pressure / (1 + 0.2 * s.inverse_pressure) *
                              (0.25 + 0.03 * std::log(s.bridge_volume / 0.002) + 0.1 * s.friction));
    }
    static double solid_fraction(const FlowState& s) {
        return 0.64 - 0.06 * s.friction / (s.friction + 0.2) - 0.3 * s.inertial_number -
               0.02 * s.inverse_pressure / (1 + 0.3 * s.inverse_pressure);
    }
};

/// Returns runs at random states, alternately wet and dry, whose averages follow `InventedLaw` with
/// random errors: standard errors of 0.002 (stress ratio) and 0.0004 (solid fraction), correlated
/// by -0.5.
/// @param factor factor on the stress ratio of the law [1]
inline std::vector<dem::RunResult> invented_runs(std::size_t count, std::uint64_t seed,
                                                 double factor = 1) {
    using enum dem::Observable;
    std::mt19937_64 random(seed);
    std::uniform_real_distribution<double> uniform;
    std::normal_distribution<double> normal;
    std::vector<dem::RunResult> runs;
    for (std::size_t k = 0; k < count; ++k) {
        dem::RunResult run;
        auto& p = run.parameters;
        p.friction = 0.6 * uniform(random);
        p.inertial_number = 0.001 * std::pow(100, uniform(random));
        p.grains = 1000;
        p.seed = seed + k;
        if (k % 2 == 0) {
            p.wetting = {.reduced_pressure = 0.5 * std::pow(40, uniform(random)),
                         .bridge_volume = 0.0005 * std::pow(16, uniform(random))};
        }
        const FlowState state = emulated::flow_state_of(p);
        const double a = normal(random), b = -0.5 * a + std::sqrt(0.75) * normal(random);
        const auto mean = [&](dem::Observable which, double value, double error) {
            run.means[static_cast<std::size_t>(which)] = {value, error};
        };
        mean(stress_ratio, factor * InventedLaw::stress_ratio(state) + 0.002 * a, 0.002);
        const double mean_overlap = 0.001;
        const double solid = InventedLaw::solid_fraction(state);
        mean(solid_fraction, solid + dem::rigidity_shift(solid, mean_overlap) + 0.0004 * b, 0.0004);
        mean(overlap, mean_overlap, 1e-6);
        mean(contact_coordination, 5, 0.02);
        if (p.wetting) {
            mean(distant_coordination, 2 + 0.2 * std::log(p.wetting->bridge_volume / 0.002), 0.02);
        }
        run.covariance = -0.5 * 0.002 * 0.0004;
        run.strain_averaged = p.strain = 6;
        run.steady = true;
        runs.push_back(run);
    }
    return runs;
}

}  // namespace pendular
