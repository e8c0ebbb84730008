// How good the emulator is, on runs that it has not seen. Prints the tables of docs/validation.md.
#include "calib/emulator/emulator.h"
#include "calib/fit/calibrate_study.h"

#include <gtest/gtest.h>

#include <Eigen/Dense>
#include <algorithm>
#include <boost/math/distributions/binomial.hpp>
#include <boost/math/distributions/chi_squared.hpp>
#include <cmath>
#include <cstdio>
#include <iterator>
#include <map>
#include <random>
#include <tuple>

#include "calib/emulator/emulated_observables.h"
#include "calib/emulator/emulated_state.h"
#include "calib/fit/calibration.h"
#include "sim/runs/run_settings.h"
#include "sim/runs/store/run_table.h"

namespace pendular::emulator_test {

using dem::Observable;

std::vector<dem::RunResult> usable_runs(const std::string& file) {
    std::vector<dem::RunResult> runs;
    for (const StoredRun& stored : read_runs(PENDULAR_SOURCE_DIR "/" + file)) {
        if (emulated::usable(stored.run) && stored.run.parameters.effects.empty()) {
            runs.push_back(stored.run);
        }
    }
    return runs;
}

const std::vector<dem::RunResult>& atlas() {
    static const auto runs = usable_runs("sim/atlas/atlas.csv");
    return runs;
}
const std::vector<dem::RunResult>& unseen() {
    static const auto runs = usable_runs("tests/data/unseen/runs.csv");
    return runs;
}

double wetness(const dem::RunParameters& p) {
    return p.wetting ? p.wetting->reduced_pressure : INFINITY;
}

/// The atlas in five parts of 20 % of its conditions each: all frictions sheared at one inertial
/// number, reduced pressure and bridge volume are left out together.
std::vector<std::size_t> parts() {
    std::map<std::tuple<double, double, double>, std::size_t> conditions;
    std::vector<std::size_t> part;
    for (const auto& run : atlas()) {
        const auto& p = run.parameters;
        const std::tuple key(p.inertial_number, wetness(p),
                             p.wetting ? p.wetting->bridge_volume : 0);
        part.push_back(conditions.emplace(key, conditions.size()).first->second % 5);
    }
    return part;
}

/// Errors of an observable on runs left out: standardised, and net of the runs' own noise.
struct Score {
    double standardised = 0, net = 0, net_strong = 0;
    int runs = 0, strong = 0;

    void add(const dem::RunResult& run, Observable which, double said, double variance,
             double noise) {
        const Mean training_value = emulated::training_value(run, which);
        const double off = training_value.value - said;
        standardised += off * off / (variance + noise);
        net += off * off - noise;
        ++runs;
        if (wetness(run.parameters) >= 1) {
            net_strong += off * off - noise;
            ++strong;
        }
    }
    double variance() const { return standardised / runs; }
    static double rms(double sum, int n) { return std::sqrt(std::max(0.0, sum / n)); }
};

Score left_out(Observable which) {
    static const auto part = parts();
    Score score;
    for (std::size_t left = 0; left < 5; ++left) {
        std::vector<dem::RunResult> known, tested;
        for (std::size_t k = 0; k < atlas().size(); ++k) {
            (part[k] == left ? tested : known).push_back(atlas()[k]);
        }
        // Its scales are learned without them too.
        const Emulator emulator(known, {});
        for (const auto& run : tested) {
            if (!emulated::of_bridges(which) || run.parameters.wetting) {
                const std::vector<Query> query = {{emulated::flow_state_of(run.parameters), which}};
                const double said = emulator.mean(query)(0),
                             variance = emulator.covariance(query)(0, 0);
                score.add(run, which, said, variance, emulator.noise_variance(run, which));
            }
        }
    }
    return score;
}

constexpr const char* input_names[] = {"friction", "ln I", "1/P*", "V0/a³"};

double input_of(const FlowState& state, Input input) {
    switch (input) {
        case Input::friction:
            return state.friction;
        case Input::log_inertial_number:
            return std::log(state.inertial_number);
        case Input::inverse_pressure:
            return state.inverse_pressure;
        default:
            return state.bridge_volume;
    }
}

struct PairOfRuns {
    dem::RunResult first, second;
    Input by;
};

/// Unseen runs that were made in pairs.
std::vector<PairOfRuns> pairs_of_runs() {
    std::vector<PairOfRuns> pairs;
    std::vector<dem::RunResult> runs;
    std::ranges::copy_if(unseen(), std::back_inserter(runs),
                         [](const auto& run) { return run.parameters.strain == 10; });
    constexpr Input inputs[] = {Input::friction, Input::log_inertial_number,
                                Input::inverse_pressure, Input::bridge_volume};
    for (std::size_t i = 0; i < runs.size(); ++i) {
        for (std::size_t j = i + 1; j < runs.size(); ++j) {
            std::vector<Input> differing;
            for (const Input input : inputs) {
                if (input_of(emulated::flow_state_of(runs[i].parameters), input) !=
                    input_of(emulated::flow_state_of(runs[j].parameters), input)) {
                    differing.push_back(input);
                }
            }
            // Frictions of different pairs of dry runs lie farther apart.
            const double friction_apart =
                std::abs(runs[i].parameters.friction - runs[j].parameters.friction);
            if (differing.size() == 1 && friction_apart < 0.15) {
                pairs.push_back({runs[i], runs[j], differing[0]});
            }
        }
    }
    return pairs;
}

TEST(EmulatorOfTheAtlas, KnowsHowWrongItIsOnConditionsLeftOut) {
    for (const Observable which : emulated::observables()) {
        const Score score = left_out(which);
        std::printf("| %s | %d | %.2f | %.5f | %.5f |\n",
                    std::string(dem::observable_names[static_cast<std::size_t>(which)]).c_str(),
                    score.runs, score.variance(), Score::rms(score.net_strong, score.strong),
                    Score::rms(score.net, score.runs));
        EXPECT_GE(score.variance(), 0.7);
        EXPECT_LE(score.variance(), 1.4);
        if (which == Observable::stress_ratio) {
            EXPECT_LE(Score::rms(score.net_strong, score.strong), 0.008);
        } else if (which == Observable::solid_fraction) {
            EXPECT_LE(Score::rms(score.net_strong, score.strong), 0.002);
        }
    }
}

TEST(EmulatorOfTheAtlas, HasTheDerivativesThatPairsOfRunsHave) {
    // Runs on either side of a state, alike in all inputs but one: the slope between them against
    // the emulator's derivative in the middle.
    const Emulator emulator(atlas(), {});
    double chi2 = 0;
    int dof = 0;
    for (const auto& [first, second, by] : pairs_of_runs()) {
        const FlowState a = emulated::flow_state_of(first.parameters),
                        b = emulated::flow_state_of(second.parameters);
        const double apart = input_of(b, by) - input_of(a, by);
        const FlowState middle{
            (a.friction + b.friction) / 2, std::sqrt(a.inertial_number * b.inertial_number),
            (a.inverse_pressure + b.inverse_pressure) / 2, (a.bridge_volume + b.bridge_volume) / 2};
        for (const Observable which : {Observable::stress_ratio, Observable::solid_fraction}) {
            const std::vector<Query> query = {{middle, which, by}};
            const double slope = emulator.mean(query)(0),
                         error = std::sqrt(emulator.covariance(query)(0, 0));
            const double found = (emulated::training_value(second, which).value -
                                  emulated::training_value(first, which).value) /
                                 apart,
                         noise = std::sqrt(emulator.noise_variance(first, which) +
                                           emulator.noise_variance(second, which)) /
                                 std::abs(apart);
            std::printf("| %s | %s | %.2g | %s | %.3g ± %.2g | %.3g ± %.2g |\n",
                        which == Observable::stress_ratio ? "stress ratio" : "solid fraction",
                        input_names[static_cast<std::size_t>(by)], middle.friction,
                        middle.dry() ? "dry" : std::to_string(1 / middle.inverse_pressure).c_str(),
                        found, noise, slope, error);
            chi2 += std::pow(found - slope, 2) / (noise * noise + error * error);
            ++dof;
        }
    }
    std::printf("chi2 = %.1f for %d\n", chi2, dof);
    ASSERT_EQ(dof, 24);
    const boost::math::chi_squared law(dof);
    EXPECT_GT(cdf(complement(law, chi2)), 0.001);
    EXPECT_GT(cdf(law, chi2), 0.001);
}

TEST(EmulatorOfTheAtlas, CoversTheTruthOfStudiesItHasNotSeen) {
    // A hundred studies: two dry readings each, at inertial numbers 0.003 and 0.03, whose values
    // are those of runs of other seeds and size, with their noise and a further 1 % and 0.001 of an
    // instrument. The friction is calibrated on the emulator alone.
    Study study;
    study.grains = {.diameter = 5e-4, .density = 1050, .poisson_ratio = 0.3};
    const Fidelity quick = fidelity_named("quick");
    const std::vector<dem::RunResult> known = atlas();
    EmulatorHyperparameters hyperparameters;
    for (const Observable which :
         {Observable::stress_ratio, Observable::solid_fraction, Observable::overlap}) {
        hyperparameters[which] = PlainEmulator::learn(known, which);
    }
    std::map<double, std::vector<dem::RunResult>> truths;
    for (const auto& run : unseen()) {
        if (!run.parameters.wetting && run.parameters.strain == 5) {
            truths[run.parameters.friction].push_back(run);
        }
    }
    std::mt19937_64 random(31);
    std::normal_distribution<double> normal;
    int studies = 0, within_68 = 0, within_95 = 0;
    double standardised = 0;
    for (const auto& [friction, runs] : truths) {
        Measurements measurements;
        for (const auto& run : runs) {
            Reading reading{.condition = {.normal_stress = 1000,
                                          .inertial_number = run.parameters.inertial_number}};
            const Mean &ratio = run[Observable::stress_ratio],
                       &solid = run[Observable::solid_fraction];
            const double ratio_error = 0.01 * ratio.value, solid_error = 0.001;
            reading.value << 1000 * (ratio.value + ratio_error * normal(random)),
                solid.value + solid_error * normal(random);
            reading.covariance << 1e6 * (std::pow(ratio_error, 2) +
                                         std::pow(ratio.standard_error, 2)),
                1e3 * run.covariance, 1e3 * run.covariance,
                std::pow(solid_error, 2) + std::pow(solid.standard_error, 2);
            measurements.readings.push_back(reading);
        }
        CalibrationRequest request{.fidelity = quick,
                                   .known = KnownRuns{known, hyperparameters, false}};
        request.options.fewest_rounds = request.options.most_rounds = 1;
        const Calibration c = calibrate_study(study, measurements, request, {});
        EXPECT_TRUE(c.fit.converged);
        const double off = (c.fit.parameters(0) - friction) / c.fit.standard_error(0);
        ++studies;
        standardised += off * off;
        within_68 += std::abs(off) < 1;
        within_95 += std::abs(off) < 1.96;
    }
    std::printf(
        "%d studies: %d within 1, %d within 1.96 standard errors, scatter over error %.2f\n",
        studies, within_68, within_95, std::sqrt(standardised / studies));
    ASSERT_GE(studies, 95);
    // Two-sided, 1 % each.
    const auto likely = [&](int count, double share) {
        const boost::math::binomial law(studies, share);
        return cdf(law, count) > 0.005 && cdf(complement(law, count - 1)) > 0.005;
    };
    EXPECT_TRUE(likely(within_68, 0.683));
    EXPECT_TRUE(likely(within_95, 0.95));
}

TEST(EmulatorOfTheAtlas, PredictsWetRunsItHasNotSeen) {
    const Emulator emulator(atlas(), {});
    for (const Observable which : {Observable::stress_ratio, Observable::solid_fraction,
                                   Observable::distant_force, Observable::capillary_shear_stress}) {
        Score score;
        for (const auto& run : unseen()) {
            if (run.parameters.wetting) {
                const std::vector<Query> query = {{emulated::flow_state_of(run.parameters), which}};
                score.add(run, which, emulator.mean(query)(0), emulator.covariance(query)(0, 0),
                          emulator.noise_variance(run, which));
            }
        }
        std::printf("| %s | %d | %.2f | %.5f |\n",
                    std::string(dem::observable_names[static_cast<std::size_t>(which)]).c_str(),
                    score.runs, score.variance(), Score::rms(score.net, score.runs));
        EXPECT_GE(score.variance(), 0.6);
        EXPECT_LE(score.variance(), 1.5);
    }
}

}  // namespace pendular::emulator_test
