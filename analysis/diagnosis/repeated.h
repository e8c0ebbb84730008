#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <optional>
#include <string_view>

#include "analysis/diagnosis/diagnosis.h"

namespace pendular {

/// How often a verdict comes again in repetitions of the experiment.
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

/// Whether a repetition of an experiment has the verdict again. Verdicts that find no effect
/// missing count as one, whichever effects would stay unseen: this depends on the plan of the
/// experiment, not on its readings. Other verdicts must name the same effects and the same suspect
/// measurements.
bool comes_again(const Diagnosis& verdict, const Diagnosis& repetition);

/// Repeats an experiment by a parametric bootstrap: readings with new random errors are drawn about
/// the accepted explanation at its estimates (about each in turn, where there are several), and the
/// diagnosis of these readings is made again with linearised models (`LinearisedSpace`). The share
/// holds for repetitions of an experiment whose truth is the estimate. Empty where the diagnosis
/// accepted no explanation.
/// Source: Efron and Tibshirani (1993), An Introduction to the Bootstrap, section 6.5.
std::optional<Repeated> repeat(const ModelSpace& space, const Evidence& evidence,
                               const Diagnosis& diagnosis, const RepetitionOptions& options = {});

}  // namespace pendular
