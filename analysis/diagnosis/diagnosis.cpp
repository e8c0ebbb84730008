#include "analysis/diagnosis/diagnosis.h"

#include <fmt/format.h>

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>
#include <set>
#include <utility>

#include "analysis/diagnosis/explanation_search.h"
#include "analysis/diagnosis/side_by_side.h"
#include "data/input_error.h"

namespace pendular {
namespace {

/// Smallest predicted reduction of chi2 for which a candidate's signature is computed again, at the
/// estimated amplitude.
constexpr double worth_sharpening = 4;
constexpr int most_sharpenings = 3;
/// Smallest power at which a switch counts as identifiable [1].
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
        if (base_stands()) {
            settle_for_base();
        } else {
            search();
            conclude();
        }
        decide();
        order_scan();
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
    bool base_stands() const;
    void settle_for_base();
    void search();
    /// Whether the model with the candidates `larger` has all that the model with `smaller` has,
    /// and more: both are on the same ladder, the former on a higher level.
    bool contains(const EffectSet& larger, const EffectSet& smaller) const;
    void conclude();
    void conclude_in_part();
    void compare_signatures();
    void decide();
    void order_scan();

    const ModelSpace& space_;
    const Evidence& evidence_;
    const DiagnosisOptions& options_;
    Explanations explanations_;
    Explanation base_;
    std::optional<WeightedResiduals> residuals_;
    std::vector<Addition> additions_;
    std::vector<Signature> signatures_;
    std::vector<ScoreTest> suspect_tests_;
    Diagnosis result_;
};

void Diagnostician::fit_base() {
    const std::shared_ptr<const Model> model = space_.with({});
    const auto entries = evidence_.measured.value.size();
    const auto fitted = std::ssize(model->parameters()) + space_.internally_fitted_values();
    if (entries <= fitted) {
        throw InputError(
            fmt::format("{} measured values and {} fitted values leave no degree of "
                        "freedom to test the model with; add readings",
                        entries, fitted));
    }
    say("fit", 0, 1);
    base_ = explanations_.refit({}, {}, options_.start.value_or(start_of(*model)));
    residuals_ = explanations_.residuals_of(base_);
    result_.fit = base_.fit;
    result_.chi2 = base_.chi2;
    result_.dof = static_cast<int>(entries - fitted);
    result_.errors_assumed = evidence_.errors_assumed;
    base_.lack_of_fit_p = result_.lack_of_fit_p = explanations_.lack_of_fit_p(*residuals_);
}

void Diagnostician::sharpen(const Addition& addition, Signature& signature, ScoreTest& test) const {
    for (int turn = 0; turn < most_sharpenings && test.seen(); ++turn) {
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
    Addition addition = explanations_.addition(base_, k);
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
    base_.further_p = result_.further_p = family.p(smallest);
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
        finding.identifiable =
            addition(k).amplitude_at(value, finding.test.one_sided) > 0.999 * amplitude;
    }
}

bool Diagnostician::base_stands() const {
    return std::min(base_.lack_of_fit_p, base_.further_p) >= explanations_.half_significance();
}

void Diagnostician::settle_for_base() {
    base_.accepted = true;
    result_.confidence_set = {base_};
    for (const Finding& finding : result_.scan) {
        if (finding.identifiable && finding.power < options_.wanted_power) {
            result_.effects.push_back(name(finding.candidate));
        }
    }
    const bool any_seen = std::ranges::any_of(result_.scan, &Finding::identifiable);
    const bool all_seen = any_seen && result_.effects.empty() && !evidence_.errors_assumed;
    result_.verdict = all_seen ? Verdict::nothing_missing : Verdict::inconclusive;
}

void Diagnostician::search() {
    Found found = search_explanations(
        space_, evidence_, options_, explanations_,
        {base_, *residuals_, additions_, signatures_, result_.scan, suspect_tests_});
    for (const Explanation& each : found.tried) {
        if (each.chosen.size() == 1 && !each.suspect) {
            result_.scan[each.chosen.front()].refitted_reduction = base_.chi2 - each.chi2;
        }
    }
    // Beside effects that fit, a suspect measurement is a rival only if it explains the readings at
    // least as well as the best of them.
    double best_effect = INFINITY;
    if (!found.fitting_suspects.empty()) {
        for (const Explanation& each : found.fitting) {
            best_effect = std::min(best_effect, explanations_.akaike(each));
        }
    }
    for (const Explanation& each : found.fitting_suspects) {
        if (explanations_.akaike(each) <= best_effect)
            result_.suspects.push_back(evidence_.suspects[*each.suspect].name);
    }
    result_.tried = std::move(found.tried);
    result_.confidence_set =
        std::move(found.fitting.empty() ? found.fitting_suspects : found.fitting);
    std::erase_if(
        result_.confidence_set, [&, all = result_.confidence_set](const Explanation& each) {
            return std::ranges::any_of(
                all, [&](const Explanation& other) { return contains(each.chosen, other.chosen); });
        });
}

bool Diagnostician::contains(const EffectSet& larger, const EffectSet& smaller) const {
    const auto split = [&](const EffectSet& chosen) {
        std::pair<int, std::set<std::size_t>> parts{0, {}};  // highest level, and the others
        for (const std::size_t k : chosen) {
            const int level = space_.candidates()[k].level;
            parts.first = std::max(parts.first, level);
            if (level == 0) parts.second.insert(k);
        }
        return parts;
    };
    const auto [high, others] = split(larger);
    const auto [low, same] = split(smaller);
    return low > 0 && low < high && others == same;
}

void Diagnostician::conclude() {
    const auto& set = result_.confidence_set;
    if (set.empty()) {
        conclude_in_part();
        return;
    }
    if (set.front().suspect) {
        result_.verdict = Verdict::suspect_measurement;
        return;
    }
    // Effects that all fitting models share are missing. Models that share none are
    // indistinguishable.
    std::set<std::size_t> shared(set.front().chosen.begin(), set.front().chosen.end());
    std::set<std::size_t> any;
    for (const Explanation& each : set) {
        std::erase_if(shared, [&](std::size_t k) {
            return std::ranges::find(each.chosen, k) == each.chosen.end();
        });
        any.insert(each.chosen.begin(), each.chosen.end());
    }
    result_.verdict = shared.empty() ? Verdict::indistinguishable : Verdict::missing;
    for (const std::size_t k : shared.empty() ? any : shared) {
        result_.effects.push_back(name(k));
    }
    if (shared.empty()) compare_signatures();
}

void Diagnostician::conclude_in_part() {
    result_.complete = false;
    result_.leaders = find_leaders(result_.chi2, result_.dof, result_.tried, explanations_);
    result_.verdict = result_.leaders ? Verdict::missing : Verdict::unknown;
    if (!result_.leaders) return;
    for (const std::size_t k : result_.leaders->model.chosen) {
        result_.effects.push_back(name(k));
    }
}

void Diagnostician::compare_signatures() {
    const auto count = static_cast<Eigen::Index>(result_.effects.size());
    Eigen::MatrixXd directions(residuals_->size(), count);
    Eigen::Index column = 0;
    for (const std::string& effect : result_.effects) {
        const auto found = std::ranges::find(space_.candidates(), effect, &Candidate::name);
        const auto k = static_cast<std::size_t>(found - space_.candidates().begin());
        directions.col(column++) = result_.scan[k].test.basis.col(0);
    }
    result_.cosines = (directions.transpose() * directions).cwiseAbs();
}

void Diagnostician::decide() {
    const bool base = base_.accepted;
    for (Finding& finding : result_.scan) {
        const bool pointed_at =
            std::ranges::find(result_.effects, name(finding.candidate)) != result_.effects.end();
        const auto in_set = [&](const Explanation& each) {
            return std::ranges::find(each.chosen, finding.candidate) != each.chosen.end();
        };
        const auto accepted = [&](const Explanation& each) {
            return each.accepted && each.chosen == EffectSet{finding.candidate};
        };
        const auto unsettled = [&](const Explanation& each) {
            return each.chosen == EffectSet{finding.candidate} && !each.fit.converged;
        };
        if (!base && pointed_at) {
            finding.decision = !result_.complete                     ? "missing, with others"
                               : result_.verdict == Verdict::missing ? "missing"
                                                                     : "may be missing";
        } else if (!base && std::ranges::any_of(result_.confidence_set, in_set)) {
            finding.decision = "may be missing too";
        } else if (!base && std::ranges::any_of(result_.tried, accepted)) {
            finding.decision = "contains what is missing";
        } else if (std::ranges::any_of(result_.tried, unsettled)) {
            finding.decision = "refit not converged";
        } else if (!finding.identifiable && !looks_missing(finding)) {
            finding.decision = "cannot be seen";
        } else if (base) {
            finding.decision =
                finding.power < options_.wanted_power ? "cannot be excluded" : "absent";
        } else {
            const bool most =
                finding.refitted_reduction &&
                *finding.refitted_reduction >= most_of_misfit * (result_.chi2 - result_.dof);
            finding.decision = !looks_missing(finding) ? "no sign of it"
                               : most                  ? "explains most, not all"
                                                       : "does not explain it";
        }
    }
}

void Diagnostician::order_scan() {
    std::ranges::stable_sort(result_.scan, std::greater<>(), [](const Finding& finding) {
        return finding.refitted_reduction.value_or(finding.test.predicted_reduction);
    });
}

}  // namespace

std::string_view to_string(Verdict verdict) {
    switch (verdict) {
        case Verdict::nothing_missing:
            return "nothing-missing";
        case Verdict::inconclusive:
            return "inconclusive";
        case Verdict::missing:
            return "missing";
        case Verdict::indistinguishable:
            return "indistinguishable";
        case Verdict::unknown:
            return "unknown";
        default:
            return "suspect-measurement";
    }
}

Diagnosis diagnose(const ModelSpace& space, const Evidence& evidence,
                   const DiagnosisOptions& options) {
    return Diagnostician(space, evidence, options).run();
}

}  // namespace pendular
