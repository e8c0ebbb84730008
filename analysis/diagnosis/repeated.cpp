#include "analysis/diagnosis/repeated.h"

#include <algorithm>
#include <set>
#include <string>
#include <vector>

#include "analysis/diagnosis/linearised_space.h"
#include "analysis/diagnosis/side_by_side.h"

namespace pendular {
namespace {

bool finds_nothing(Verdict verdict) {
    return verdict == Verdict::nothing_missing || verdict == Verdict::inconclusive;
}

bool same_names(const std::vector<std::string>& one, const std::vector<std::string>& other) {
    return std::set(one.begin(), one.end()) == std::set(other.begin(), other.end());
}

/// Readings of repetitions of the experiment, one column for each: the prediction of an explanation
/// with random errors.
Eigen::MatrixXd repeated_readings(const Evidence& evidence, const Explanation& truth,
                                  std::uint64_t seed, Eigen::Index count) {
    const Prediction& prediction = truth.fit.prediction;
    const WeightedResiduals residuals(evidence.measured, prediction);
    const NullDraws draws(evidence.measured, evidence.errors, seed, count);
    return residuals.unwhiten(draws.whitened(residuals)).colwise() + prediction.value;
}

}  // namespace

bool confirms_verdict(const Diagnosis& verdict, const Diagnosis& repetition) {
    if (finds_nothing(verdict.verdict)) return finds_nothing(repetition.verdict);
    return verdict.verdict == repetition.verdict && verdict.complete == repetition.complete &&
           same_names(verdict.effects, repetition.effects) &&
           same_names(verdict.suspects, repetition.suspects);
}

std::optional<Repeated> repeat(const ModelSpace& space, const Evidence& evidence,
                               const Diagnosis& diagnosis, const RepetitionOptions& options) {
    const auto& truths = diagnosis.confidence_set;
    if (truths.empty() || options.count == 0) return {};
    // The random draws behind the p values have another seed than the random errors of the
    // readings.
    const DiagnosisOptions quick{.draws = options.draws, .seed = options.seed};
    Repeated result{.of = options.count};
    for (std::size_t t = 0; t < truths.size(); ++t) {
        const std::size_t count = (options.count + truths.size() - 1 - t) / truths.size();
        if (count == 0) break;
        const LinearisedSpace linear(space, diagnosis, truths[t]);
        const Eigen::MatrixXd readings = repeated_readings(
            evidence, truths[t], options.seed + 1 + t, static_cast<Eigen::Index>(count));
        std::vector<char> same(count);
        side_by_side(
            count, options.threads,
            [&](std::size_t k) {
                if (options.progress) options.progress("repetitions", k, count);
            },
            [&](std::size_t k) {
                Evidence again = evidence;
                again.measured.value = readings.col(static_cast<Eigen::Index>(k));
                same[k] = confirms_verdict(diagnosis, diagnose(linear, again, quick)) ? 1 : 0;
            });
        result.same += static_cast<std::size_t>(std::ranges::count(same, 1));
    }
    return result;
}

}  // namespace pendular
