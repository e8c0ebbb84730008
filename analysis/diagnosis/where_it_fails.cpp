#include "analysis/diagnosis/where_it_fails.h"

#include <algorithm>

#include "analysis/diagnosis/evidence.h"
#include "analysis/diagnosis/score_statistic.h"

namespace pendular {
namespace {

std::vector<DeviatingGroup> offending_of(const Evidence& evidence,
                                         const WeightedResiduals& residuals,
                                         const NullDraws& draws) {
    std::vector<ScoreTest> tests;
    for (const SuspectMeasurement& suspect : evidence.suspects) {
        tests.push_back(score_test(residuals, {.change = suspect.columns}, false));
    }
    const FamilyOfTests family(tests, residuals, draws);
    std::vector<DeviatingGroup> result;
    for (std::size_t k = 0; k < tests.size(); ++k) {
        const double p = family.p(tests[k].p());
        if (p < significant_p) {
            result.push_back({evidence.suspects[k].name, p});
        }
    }
    std::ranges::stable_sort(result, {}, &DeviatingGroup::p);
    return result;
}

}  // namespace

WhereItFails where_it_fails(const std::vector<Reading>& readings, const ReplicateScatter& scatter,
                            const Prediction& prediction, const std::vector<Parameter>& parameters,
                            const std::vector<DirectMeasurement>& direct, std::uint64_t seed) {
    const Evidence evidence = evidence_of(readings, scatter, direct);
    const WeightedResiduals residuals(evidence.measured, prediction);
    const NullDraws draws(evidence.measured, evidence.errors, seed, DiagnosisOptions{}.draws);
    return {check_fit(residuals, entries_of(readings, parameters, direct.size()),
                      covariates_of(readings, prediction.value, direct.size()), draws),
            offending_of(evidence, residuals, draws)};
}

}  // namespace pendular
