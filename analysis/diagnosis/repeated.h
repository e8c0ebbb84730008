#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <optional>
#include <string_view>

#include "analysis/diagnosis/diagnosis.h"

namespace pendular {

/// Reproducibility of the verdict of a diagnosis (whether a model lacks a physical effect): number
/// of simulated repetitions of the experiment, and number of repetitions for which the diagnosis
/// gives the same verdict as for the readings.
struct Repeated {
    /// Number of simulated repetitions for which the diagnosis gives the same verdict as for the
    /// readings.
    std::size_t same = 0;
    /// Number of all simulated repetitions of the experiment.
    std::size_t of = 0;
};

/// Options of `repeat`, which simulates repetitions of an experiment and diagnoses each repetition.
struct RepetitionOptions {
    /// Number of repetitions of the experiment to simulate.
    std::size_t count = 20;
    /// Number of random draws of errors from which the p values of each repetition follow. With
    /// 2000 draws, a p value of 0.025 has a standard error of 0.0035. With fewer draws, the share
    /// of repetitions with the same verdict depends on the seed.
    Eigen::Index draws = 2000;
    /// Seed of the random errors of the simulated readings and of the random draws of errors for
    /// the p values.
    std::uint64_t seed = 1;
    /// Largest number of threads for the diagnoses of repetitions. No result depends on the number
    /// of threads.
    std::size_t threads = 1;
    /// Function that is called with the progress of the diagnoses: `done` of `of` pieces of the
    /// work `what`, such as "repetitions", are finished. May be empty, and may throw to end the
    /// work.
    std::function<void(std::string_view what, std::size_t done, std::size_t of)> progress = {};
};

/// Whether `repetition`, the diagnosis of a repeated experiment, confirms `verdict`, the diagnosis
/// of the readings. Both diagnoses must have the same verdict, name the same effects and suspect
/// measurements, and agree on whether a model fits (`Diagnosis::complete`). However, the verdicts
/// `nothing_missing` and `inconclusive` count as equal, whatever effects the diagnoses name.
bool confirms_verdict(const Diagnosis& verdict, const Diagnosis& repetition);

/// Repeats an experiment by simulation (parametric bootstrap), and counts the repetitions for which
/// the diagnosis gives the same verdict as for the readings. The readings of a repetition are the
/// predictions of a model that fits the readings, at the model's fitted parameters, plus new random
/// errors. If several models fit, the repetitions are divided equally among these models.
/// Linearised models (`LinearisedSpace`) are used for the diagnoses. The result is empty if no
/// model fits the readings (`Diagnosis::confidence_set`), or if `options.count` is 0.
/// Source: Efron and Tibshirani (1993), An Introduction to the Bootstrap, section 6.5.
std::optional<Repeated> repeat(const ModelSpace& space, const Evidence& evidence,
                               const Diagnosis& diagnosis, const RepetitionOptions& options = {});

}  // namespace pendular
