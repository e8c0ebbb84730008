#include "analysis/diagnosis/inexact_diagnosis.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "calib/fit/inexactness.h"

namespace pendular {

double inexactness_left(const Diagnosis& diagnosis, const Evidence& evidence) {
    const auto price_of_one_among = [](std::size_t offered) {
        return 2 * std::log(static_cast<double>(std::max<std::size_t>(offered, 1)));
    };
    const auto price = [&](const FittedModel& model) {
        double sum = static_cast<double>(model.chosen.size()) *
                     (2 + price_of_one_among(diagnosis.scan.size()));
        if (model.suspect)
            sum += 2 * static_cast<double>(evidence.suspects[*model.suspect].columns.cols()) +
                   price_of_one_among(evidence.suspects.size());
        return sum;
    };
    const auto likely = [&](const Fit& fit) {
        return likely_inexactness(evidence.measured, fit.prediction, fit.at_bound);
    };
    Inexactness best = likely(diagnosis.base.fit);
    double least = best.criterion();
    for (const FittedModel& each : diagnosis.tried) {
        if (!each.fit.converged) continue;
        const Inexactness with = likely(each.fit);
        if (const double value = with.criterion() + price(each); value < least)
            best = with, least = value;
    }
    return best.factor;
}

namespace {

/// Lets the errors of all fits allow for as much as each model leaves.
void allow_for_inexactness(Diagnosis& diagnosis, const Measured& measured) {
    const auto allow = [&](FittedModel& model) {
        Fit& fit = model.fit;
        fit.inexactness = likely_inexactness(measured, fit.prediction, fit.at_bound).factor;
    };
    allow(diagnosis.base);
    for (auto* models : {&diagnosis.tried, &diagnosis.fitting, &diagnosis.fitting_suspects})
        std::ranges::for_each(*models, allow);
    if (diagnosis.leading) allow(diagnosis.leading->model);
}

}  // namespace

InexactDiagnosis diagnose_inexact(const StudyModelSpace& models,
                                  const std::array<double, 2>& discrepancy,
                                  const Evidence& evidence, const DiagnosisOptions& options) {
    InexactDiagnosis result{diagnose(models, evidence, options), models, discrepancy, {}};
    result.as_expected = result.diagnosis.base.fit;
    const double factor =
        result.diagnosis.base.accepted ? 1 : inexactness_left(result.diagnosis, evidence);
    if (factor > 1) {
        const std::array larger = {factor * discrepancy[0], factor * discrepancy[1]};
        StudyModelSpace inexact = models.with_discrepancy(larger);
        Diagnosis again = diagnose(inexact, evidence, options);
        if (again.complete)
            return {std::move(again), std::move(inexact), larger, std::move(result.as_expected)};
    }
    allow_for_inexactness(result.diagnosis, evidence.measured);
    return result;
}

}  // namespace pendular
