#include "analysis/diagnosis/diagnosis.h"

#include <fmt/format.h>

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>
#include <utility>

#include "analysis/diagnosis/explanation_search.h"
#include "analysis/diagnosis/side_by_side.h"
#include "calib/fit/inexactness.h"
#include "data/input_error.h"

namespace pendular {
namespace {

/// Smallest predicted reduction of chi2 for which a candidate's signature is computed again, at the
/// estimated amplitude: that of an amplitude of two standard errors. Less may be chance.
constexpr double worth_sharpening = 4;
/// Largest number of these computations for one candidate. Chosen: amplitudes that have not settled
/// after them are left to the refit.
constexpr int most_sharpenings = 3;
/// Smallest power at which a switch counts as identifiable [1]. Chosen: below it, nine of
/// ten such measurements would not show the switch.
constexpr double hardly_seen = 0.1;

/// Candidate effect with the score test (test without a refit) of the model with it alone added.
struct TestedCandidate {
    Addition addition;    ///< predictions as a function of the effect's amplitude
    Signature signature;  ///< change of the readings per unit of amplitude
    ScoreTest test;       ///< result of the score test
};

/// Carries out one diagnosis, from the fit to the verdict.
class Diagnostician {
  public:
    Diagnostician(const ModelSpace& space, const Evidence& evidence,
                  const DiagnosisOptions& options)
        : space_(space),
          evidence_(evidence),
          options_(options),
          explanations_(space, evidence, options) {}

    Diagnosis run() {
        fit_base();
        scan();
        result_.base.accepted = result_.base.p() >= options_.significance;
        if (!result_.base.accepted) {
            search();
            result_.holds_up_to = largest_rejected();
        }
        order_scan();
        conclude_anew(result_, space_, options_, {});
        result_.change_errors = std::move(explanations_.errors);
        return std::move(result_);
    }

  private:
    void say(std::string_view what, std::size_t done, std::size_t of) const {
        if (options_.progress) options_.progress(what, done, of);
    }
    bool is_switch(std::size_t k) const { return space_.candidates()[k].is_switch(); }
    const std::string& name(std::size_t k) const { return space_.candidates()[k].name; }
    const Addition& addition(std::size_t k) const { return additions_[k]; }

    void fit_base();
    void scan();
    TestedCandidate test_alone(std::size_t k) const;
    void sharpen(const Addition& addition, Signature& signature, ScoreTest& test) const;
    Finding finding_of(std::size_t k, const ScoreTest& test) const;
    void judge_power(const FamilyOfTests& family);
    void search();
    bool rejected_at(double factor) const;
    double largest_rejected() const;
    void order_scan();

    const ModelSpace& space_;
    const Evidence& evidence_;
    const DiagnosisOptions& options_;
    Explanations explanations_;
    std::optional<WeightedResiduals> residuals_;
    std::vector<Addition> additions_;
    std::vector<Signature> signatures_;
    std::vector<ScoreTest> suspect_tests_;
    Diagnosis result_;
};

void Diagnostician::fit_base() {
    const std::shared_ptr<const Model> model = space_.with({});
    const auto entries = evidence_.measured.informative();
    const auto fitted = std::ssize(model->parameters()) + space_.internally_fitted_values();
    if (entries <= fitted) {
        throw InputError(
            fmt::format("{} measured values and {} fitted values leave no degree of "
                        "freedom to test the model with; add readings",
                        entries, fitted));
    }
    say("fit", 0, 1);
    result_.base = explanations_.refit({}, {}, start_of(*model));
    residuals_ = explanations_.residuals_of(result_.base);
    result_.dof = static_cast<int>(entries - fitted);
    result_.errors_assumed = evidence_.errors_assumed;
    result_.base.lack_of_fit_p = explanations_.lack_of_fit_p(*residuals_);
}

void Diagnostician::sharpen(const Addition& addition, Signature& signature, ScoreTest& test) const {
    for (int turn = 0; turn < most_sharpenings && test.seen(); ++turn) {
        // A change that was taken within a quarter of the estimate is near enough: chosen, since a
        // refit follows for all effects that matter.
        const double ratio = test.estimate(0) / signature.taken_at;
        if (test.predicted_reduction < worth_sharpening || (ratio > 0.8 && ratio < 1.25)) {
            return;
        }
        const double taken_at = signature.taken_at;
        addition.retake(signature, test.estimate(0));
        if (signature.taken_at == taken_at) {
            return;  // the amplitude is at its bound
        }
        // The power is computed near the neutral value.
        const double length = test.length, information = test.information;
        test = score_test(*residuals_, signature, false);
        test.length = length, test.information = information;
    }
}

Finding Diagnostician::finding_of(std::size_t k, const ScoreTest& test) const {
    Finding finding{.candidate = k, .test = test};
    if (!test.seen() || test.estimate.size() != 1) {
        return finding;
    }
    if (is_switch(k)) {
        finding.value = test.estimate(0);
        finding.standard_error = test.standard_error;
        return finding;
    }
    const auto value = [&](double amplitude) {
        return addition(k).value_at(amplitude, test.one_sided);
    };
    const double estimate = test.estimate(0);
    finding.value = value(estimate);
    // Where the response is quadratic in the parameter, it has no slope within one standard error
    // of zero.
    const double low = test.one_sided ? std::max(estimate, 0.0) : estimate - test.standard_error;
    const double high = (test.one_sided ? std::max(estimate, 0.0) : estimate) + test.standard_error;
    finding.standard_error = std::abs(value(high) - value(low)) / (test.one_sided ? 1 : 2);
    return finding;
}

TestedCandidate Diagnostician::test_alone(std::size_t k) const {
    Addition addition = explanations_.addition(result_.base, k);
    Signature signature = addition.signature(true);
    ScoreTest test = score_test(*residuals_, signature, is_switch(k));
    if (!is_switch(k) && test.seen() && test.estimate.size() == 1) {
        sharpen(addition, signature, test);
    }
    return {std::move(addition), std::move(signature), std::move(test)};
}

void Diagnostician::scan() {
    const std::size_t count = space_.candidates().size();
    std::vector<std::optional<TestedCandidate>> tested(count);
    side_by_side(
        count, options_.threads, [&](std::size_t k) { say("scan", k, count); },
        [&](std::size_t k) { tested[k].emplace(test_alone(k)); });
    say("scan", count, count);
    std::vector<ScoreTest> tests;
    for (std::size_t k = 0; k < count; ++k) {
        additions_.push_back(std::move(tested[k]->addition));
        signatures_.push_back(std::move(tested[k]->signature));
        explanations_.errors[k] = signatures_[k].errors;
        result_.scan.push_back(finding_of(k, tested[k]->test));
        tests.push_back(std::move(tested[k]->test));
    }
    suspect_tests_ = explanations_.suspect_tests(*residuals_);
    tests.insert(tests.end(), suspect_tests_.begin(), suspect_tests_.end());
    const FamilyOfTests family(tests, *residuals_, explanations_.draws());
    double smallest = 1;
    for (const ScoreTest& test : tests) {
        smallest = std::min(smallest, test.p());
    }
    result_.base.further_p = family.p(smallest);
    for (Finding& finding : result_.scan) {
        finding.p = family.p(finding.test.p());
    }
    for (const ScoreTest& test : suspect_tests_) {
        result_.suspect_p.push_back(family.p(test.p()));
    }
    judge_power(family);
}

void Diagnostician::judge_power(const FamilyOfTests& family) {
    const double limit = family.limit(explanations_.half_significance());
    for (Finding& finding : result_.scan) {
        if (!finding.test.seen()) continue;
        const std::size_t k = finding.candidate;
        finding.power = finding.test.power(1, limit);
        const double amplitude = finding.test.detectable(options_.wanted_power, limit);
        if (is_switch(k)) {
            finding.detectable = amplitude;
            finding.identifiable = finding.power > hardly_seen;
            continue;
        }
        const EffectParameter& p = space_.candidates()[k].parameters.front();
        const double value = addition(k).value_at(amplitude, finding.test.one_sided);
        finding.detectable = std::abs(value - p.neutral);
        // A smaller amplitude was cut off at the bounds of the parameter, beyond rounding.
        finding.identifiable =
            addition(k).amplitude_at(value, finding.test.one_sided) > 0.999 * amplitude;
    }
}

void Diagnostician::search() {
    Found found = search_explanations(
        space_, evidence_, options_, explanations_,
        {result_.base, *residuals_, additions_, signatures_, result_.scan, suspect_tests_});
    for (const FittedModel& each : found.tried) {
        if (each.chosen.size() == 1 && !each.suspect) {
            result_.scan[each.chosen.front()].refitted_reduction =
                result_.base.fit.chi2 - each.fit.chi2;
        }
    }
    if (!found.fitting_suspects.empty()) {
        for (auto* fitting : {&found.fitting, &found.fitting_suspects}) {
            for (FittedModel& each : *fitting) {
                each.criterion = explanations_.criterion(each);
            }
        }
    }
    for (const FittedModel& each : found.fitting_suspects) {
        result_.suspect_names.push_back(evidence_.suspects[*each.suspect].name);
    }
    result_.tried = std::move(found.tried);
    result_.fitting = std::move(found.fitting);
    result_.fitting_suspects = std::move(found.fitting_suspects);
    if (result_.fitting.empty() && result_.fitting_suspects.empty()) {
        result_.leading = find_leaders(result_.excess(), result_.tried, explanations_);
    }
}

/// Whether the study's model is rejected with its discrepancy larger by a factor.
bool Diagnostician::rejected_at(double factor) const {
    FittedModel inexact = result_.base;
    Prediction& prediction = inexact.fit.prediction;
    prediction.covariance += (factor * factor - 1) * prediction.discrepancy;
    const WeightedResiduals residuals = explanations_.residuals_of(inexact);
    const double half = explanations_.half_significance();
    if (explanations_.lack_of_fit_p(residuals, true) < half) return true;
    std::vector<ScoreTest> tests = explanations_.suspect_tests(residuals);
    for (std::size_t k = 0; k < signatures_.size(); ++k)
        tests.push_back(score_test(residuals, signatures_[k], is_switch(k)));
    double smallest = 1;
    for (const ScoreTest& test : tests) {
        smallest = std::min(smallest, test.p());
    }
    return FamilyOfTests(tests, residuals, explanations_.draws()).p(smallest) < half;
}

double Diagnostician::largest_rejected() const {
    if (result_.base.fit.prediction.discrepancy.size() == 0) return 0;
    if (rejected_at(most_inexact)) return most_inexact;
    constexpr double close = 1.1;  // chosen: a tenth more or less decides nothing
    double below = 1, above = most_inexact;
    while (above / below > close) {
        const double middle = std::sqrt(below * above);
        (rejected_at(middle) ? below : above) = middle;
    }
    return below;
}

void Diagnostician::order_scan() {
    std::ranges::stable_sort(result_.scan, std::greater<>(), [](const Finding& finding) {
        return finding.refitted_reduction.value_or(finding.test.predicted_reduction);
    });
}

/// Cosines between the signatures of the effects that a diagnosis names.
Eigen::MatrixXd cosines_between(const Diagnosis& d, const std::vector<Candidate>& candidates) {
    const auto count = static_cast<Eigen::Index>(d.effects.size());
    Eigen::MatrixXd directions(d.base.fit.prediction.value.size(), count);
    for (const Finding& finding : d.scan) {
        const auto named = std::ranges::find(d.effects, candidates[finding.candidate].name);
        if (named != d.effects.end())
            directions.col(named - d.effects.begin()) = finding.test.basis.col(0);
    }
    return (directions.transpose() * directions).cwiseAbs();
}

}  // namespace

void conclude_anew(Diagnosis& diagnosis, const ModelSpace& space, const DiagnosisOptions& options,
                   const Circumstances& circumstances) {
    static_cast<Conclusion&>(diagnosis) =
        conclude(space.candidates(), diagnosis, options.wanted_power, circumstances);
    diagnosis.cosines.resize(0, 0);
    if (diagnosis.verdict == Verdict::indistinguishable) {
        diagnosis.cosines = cosines_between(diagnosis, space.candidates());
    }
}

Diagnosis diagnose(const ModelSpace& space, const Evidence& evidence,
                   const DiagnosisOptions& options) {
    return Diagnostician(space, evidence, options).run();
}

namespace {

/// Factor [1] on the expected discrepancy of the model with which the likeliest of all explanations
/// describes the readings: the study's model, or one that was refitted with an effect,
/// a pair or an error of measurement. Explanations are compared by
///     chi2 + ln det Sigma + ((ln factor)/(ln 2))^2 + 2 k (1 + ln m)
/// at their likeliest factor (`likely_inexactness`), with k effects among m candidates, or else
/// with the k columns of one of m suspect measurements (2 k + 2 ln m). An effect thus has to
/// explain more than the differences between conditions that an inexact model leaves, and a pair
/// more than an effect with such differences. Source: Foster and George, Ann. Stat. 22 (1994) 1947,
/// for the price of the search.
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
