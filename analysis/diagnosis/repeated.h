#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <optional>
#include <string_view>

#include "analysis/diagnosis/diagnosis.h"

namespace pendular {

/// Number of repetitions of the experiment in which the diagnosis gives the same verdict.
struct Repeated {
    std::size_t same = 0;  ///< number of repetitions with the same verdict
    std::size_t of = 0;    ///< number of repetitions
};

/// Options of `repeat`.
struct RepetitionOptions {
    std::size_t count = 20;  ///< number of repetitions
    /// Number of random draws for the p values of each repetition. With 2000, a p value of 0.025
    /// has a standard error of 0.0035; with fewer, the share depends on the seed of the draws.
    Eigen::Index draws = 2000;
    std::uint64_t seed = 1;   ///< seed of the random errors
    std::size_t threads = 1;  ///< largest number of threads; no result depends on it
    /// Callback for progress as in DiagnosisOptions; may throw to end the work.
    std::function<void(std::string_view what, std::size_t done, std::size_t of)> progress = {};
};

/// Whether the diagnosis of a repeated experiment gives the same verdict as the first. The verdicts
/// `nothing_missing` and `inconclusive` count as the same: which effects would stay unseen depends
/// on the plan of the experiment, not on its readings. Other verdicts must name the same effects
/// and the same suspect measurements.
bool comes_again(const Diagnosis& verdict, const Diagnosis& repetition);

/// Repeats an experiment by a parametric bootstrap. The readings of a repetition are predictions of
/// the accepted explanation at its estimates, plus new random errors; several accepted explanations
/// serve in turn. Each repetition is diagnosed with linearised models (`LinearisedSpace`). The
/// share of equal verdicts holds if the estimates are the truth. Empty where the diagnosis accepted
/// no explanation.
/// Source: Efron and Tibshirani (1993), An Introduction to the Bootstrap, section 6.5.
std::optional<Repeated> repeat(const ModelSpace& space, const Evidence& evidence,
                               const Diagnosis& diagnosis, const RepetitionOptions& options = {});

}  // namespace pendular
