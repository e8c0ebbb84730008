#pragma once

#include <Eigen/Dense>
#include <cstdint>
#include <random>
#include <string>
#include <vector>

#include "analysis/diagnosis/evidence.h"
#include "calib/model/study_model_space.h"
#include "tests/support/effect_study.h"

// Readings of the laboratory that the emulator itself predicts, with an effect on or complete.
namespace pendular {

struct Planted {
    std::string effect;
    double value;
};

inline const Study& planted_study() {
    static const Study study = [] {
        Study with_readings = study_with("dem");
        with_readings.sources = {{.liquid_content = 0.0}, {.liquid_content = 0.03}};
        return with_readings;
    }();
    return study;
}

inline StudyModelSpace models_of(const std::vector<Condition>& conditions,
                                 const Study& study = planted_study()) {
    const Fidelity quick = fidelity_named("quick");
    return {study,
            conditions,
            quick,
            {runs_serving(StudyModelSpace::with_all_effects(planted_study()), quick,
                          all_shipped_runs()),
             shipped_hyperparameters(), false}};
}

inline const StudyModelSpace& models() {
    static const StudyModelSpace shared = models_of(conditions());
    return shared;
}

inline EffectSet place_of(const std::string& effect) {
    const auto& all = models().candidates();
    const auto found = std::ranges::find(all, effect, &Candidate::name);
    return {static_cast<std::size_t>(found - all.begin())};
}

/// Readings at conditions whose true values are these, with errors of 1 % in shear stress and 0.2 %
/// in solid fraction.
inline std::vector<Reading> scattered(const std::vector<Condition>& conditions,
                                      const Eigen::VectorXd& values, std::mt19937_64& random) {
    std::normal_distribution<double> normal;
    std::vector<Reading> readings;
    for (const Condition& condition : conditions) {
        const auto at = 2 * static_cast<Eigen::Index>(readings.size());
        Reading reading{.condition = condition};
        const Eigen::Vector2d errors(0.01 * values(at), 0.002 * values(at + 1));
        reading.value = values.segment<2>(at) +
                        Eigen::Vector2d(errors(0) * normal(random), errors(1) * normal(random));
        reading.covariance = errors.cwiseAbs2().asDiagonal();
        readings.push_back(reading);
    }
    return readings;
}

/// The parameters where the effect is on.
inline Eigen::VectorXd truth_of(const Planted& planted, const Model& model) {
    Eigen::VectorXd parameters(static_cast<Eigen::Index>(model.parameters().size()));
    parameters(0) = planted_friction;
    parameters.tail(parameters.size() - 1).setConstant(planted.value);
    return parameters;
}

/// Readings with the effect on; without an effect, readings of a complete model. `simulation_errs`:
/// the truth is off the emulator as its own errors allow.
inline std::vector<Reading> readings_with(const Planted& planted, std::uint64_t seed,
                                          bool simulation_errs = false) {
    const EffectSet on = planted.effect.empty() ? EffectSet{} : place_of(planted.effect);
    const std::shared_ptr<const Model> truth = models().with(on);
    const Eigen::VectorXd parameters = truth_of(planted, *truth);
    Eigen::VectorXd values = truth->predict(parameters, PredictionPart::values).value;
    std::mt19937_64 random(seed);
    std::normal_distribution<double> normal;
    if (simulation_errs) {
        Eigen::MatrixXd covariance = truth->predict(parameters).covariance;
        covariance.diagonal() *= 1 + 1e-6;  // some readings are predicted alike
        const Eigen::MatrixXd lower = covariance.llt().matrixL();
        values +=
            lower * Eigen::VectorXd::NullaryExpr(values.size(), [&] { return normal(random); });
    }
    return scattered(conditions(), values, random);
}

}  // namespace pendular
