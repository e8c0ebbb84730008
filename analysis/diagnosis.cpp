#include "analysis/diagnosis.h"

#include <fmt/format.h>

#include <Eigen/Dense>
#include <algorithm>
#include <atomic>
#include <cmath>
#include <future>
#include <set>
#include <stdexcept>
#include <utility>

#include "analysis/explanations.h"
#include "data/input_error.h"

namespace pendular {
namespace {

/// A change is seen anew at the amplitude that it seems to have, where it is not small.
constexpr double worth_sharpening = 4;
constexpr int most_sharpenings = 3;
/// From this p on, of the test alone, a candidate is not refitted.
constexpr double worth_refitting = 0.05;
/// A switch is identifiable if it is seen at least so often.
constexpr double hardly_seen = 0.1;
/// A pair is refitted where its second part takes at least this off chi2 by the linear estimate.
constexpr double worth_a_pair = 1;
/// Models whose chi2 differ by less may be refused or stand for other reasons than that.
constexpr double all_the_same = 10;
/// By how much a refit may lower chi2 more than the linear estimate says.
constexpr double foretelling_error = 0.2;
/// Candidates that are refitted together.
constexpr std::size_t best_singles = 6;
/// Refits for which another instance of the space is worth making.
constexpr std::size_t worth_another_thread = 3;

/// One diagnosis from its fit to its verdict.
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
    void sharpen(std::size_t k, ScoreTest& test);
    Finding finding_of(std::size_t k, const ScoreTest& test) const;
    void judge_power(const FamilyOfTests& family);
    bool base_stands() const;
    void settle_for_base();
    void search();
    static bool looks_missing(const Finding& finding) {
        return finding.test.seen() && finding.test.p() < worth_refitting;
    }
    void search_singles();
    void search_suspects();
    void search_pairs();
    /// Whether a model that takes this off chi2 by the linear estimate may do better than those
    /// that were refitted and refused.
    bool may_do_better(double drop) const;
    /// chi2 that a choice would leave were everything linear: switches on, amplitudes within
    /// bounds.
    double left_by(const Choice& chosen) const;
    /// The amplitude nearest to this one that a candidate can have.
    double within_bounds(std::size_t candidate, double amplitude) const;
    /// A model to be refitted.
    struct Trial {
        Choice chosen;
        std::optional<std::size_t> suspect;
        Eigen::VectorXd start;
    };
    /// Refits and judges them, side by side where there are further instances of the space.
    void try_all(std::string_view what, const std::vector<Trial>& trials);
    void take(Explanation explanation);
    Eigen::VectorXd start_with(const Choice& chosen, const Eigen::MatrixXd& columns) const;
    void conclude();
    void compare_signatures();
    void decide();
    void order_scan();

    const ModelSpace& space_;
    const Evidence& evidence_;
    const DiagnosisOptions& options_;
    Explanations explanations_;
    std::vector<std::unique_ptr<ModelSpace>> other_spaces_;  ///< of further threads, once needed
    Explanation base_;
    std::optional<WeightedResiduals> residuals_;
    std::vector<Addition> additions_;
    std::vector<Signature> signatures_;
    std::vector<ScoreTest> suspect_tests_;
    std::vector<Explanation> standing_suspects_;
    Diagnosis result_;
};

void Diagnostician::fit_base() {
    const Model& model = space_.with({});
    const auto entries = evidence_.measured.value.size();
    const auto parameters = static_cast<Eigen::Index>(model.parameters().size());
    if (entries <= parameters) {
        throw InputError(fmt::format(
            "{} measured values and {} calibrated parameters: nothing is left to judge the model "
            "by; add readings",
            entries, parameters));
    }
    say("fit", 0, 1);
    base_ = explanations_.refit({}, {}, options_.start.value_or(start_of(model)));
    residuals_ = explanations_.residuals_of(base_);
    result_.fit = base_.fit;
    result_.chi2 = base_.chi2;
    result_.dof = static_cast<int>(entries - parameters);
    result_.errors_assumed = evidence_.errors_assumed;
    base_.lack_of_fit_p = result_.lack_of_fit_p = explanations_.lack_of_fit_p(*residuals_);
}

void Diagnostician::sharpen(std::size_t k, ScoreTest& test) {
    Signature& signature = signatures_[k];
    for (int turn = 0; turn < most_sharpenings && test.seen(); ++turn) {
        const double ratio = test.estimate(0) / signature.taken_at;
        if (test.predicted_drop < worth_sharpening || (ratio > 0.8 && ratio < 1.25)) {
            return;
        }
        const double taken_at = signature.taken_at;
        addition(k).retake(signature, test.estimate(0));
        if (signature.taken_at == taken_at) {
            return;  // at its bound
        }
        const double information = test.information;
        test = score_test(*residuals_, signature, false);
        test.information = information;  // about neutral, where power is asked for
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
    // Where the parameter's square counts, one standard error about zero is no slope.
    const double low = test.one_sided ? std::max(estimate, 0.0) : estimate - test.standard_error;
    const double high = (test.one_sided ? std::max(estimate, 0.0) : estimate) + test.standard_error;
    finding.standard_error = std::abs(value(high) - value(low)) / (test.one_sided ? 1 : 2);
    return finding;
}

void Diagnostician::scan() {
    const std::size_t count = space_.candidates().size();
    std::vector<ScoreTest> tests;
    for (std::size_t k = 0; k < count; ++k) {
        say("scan", k, count);
        additions_.push_back(explanations_.addition(base_, k));
        signatures_.push_back(addition(k).signature(true));
        explanations_.errors[k] = signatures_[k].errors;
        ScoreTest test = score_test(*residuals_, signatures_[k], is_switch(k));
        if (!is_switch(k) && test.seen() && test.estimate.size() == 1) {
            sharpen(k, test);
        }
        result_.scan.push_back(finding_of(k, test));
        tests.push_back(std::move(test));
    }
    say("scan", count, count);
    suspect_tests_ = explanations_.suspect_tests(*residuals_);
    tests.insert(tests.end(), suspect_tests_.begin(), suspect_tests_.end());
    const FamilyOfTests family(tests, explanations_.draws());
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

Eigen::VectorXd Diagnostician::start_with(const Choice& chosen,
                                          const Eigen::MatrixXd& columns) const {
    // Of the linear problem: all amplitudes together, and what the parameters then change by.
    const Eigen::MatrixXd whitened = residuals_->whiten(columns);
    const Eigen::VectorXd amplitudes =
        residuals_->project(whitened).colPivHouseholderQr().solve(residuals_->residuals());
    std::vector<double> added;
    Eigen::VectorXd applied = amplitudes;
    Eigen::Index column = 0;
    for (const std::size_t k : chosen) {
        if (is_switch(k)) {
            applied(column++) = 1;
            continue;
        }
        const bool one_sided = signatures_[k].one_sided;
        const double least = one_sided ? 0.1 : -INFINITY;  // off neutral, where slopes may vanish
        applied(column) = std::max(amplitudes(column), least);
        added.push_back(addition(k).value_at(applied(column++), one_sided));
    }
    for (; column < columns.cols(); ++column) {
        added.push_back(amplitudes(column));
    }
    const Eigen::VectorXd own = base_.fit.parameters - residuals_->absorbed_by(whitened * applied);
    Eigen::VectorXd start(own.size() + static_cast<Eigen::Index>(added.size()));
    start << own,
        Eigen::Map<Eigen::VectorXd>(added.data(), static_cast<Eigen::Index>(added.size()));
    return start;
}

/// Refitted and judged; none where so much of it is wanted that nothing real could show these
/// readings.
std::optional<Explanation> explained(const Explanations& explanations, const Choice& chosen,
                                     std::optional<std::size_t> suspect,
                                     const Eigen::VectorXd& start) {
    try {
        Explanation explanation = explanations.refit(chosen, suspect, start);
        explanations.judge(explanation);
        return explanation;
    } catch (const std::domain_error&) {
        return {};
    }
}

void Diagnostician::try_all(std::string_view what, const std::vector<Trial>& trials) {
    std::vector<std::optional<Explanation>> found(trials.size());
    std::atomic<std::size_t> next = 0;
    const auto work = [&](const Explanations& explanations, const auto& before_each) {
        for (std::size_t k = next++; k < trials.size(); k = next++) {
            before_each(k);
            found[k] =
                explained(explanations, trials[k].chosen, trials[k].suspect, trials[k].start);
        }
    };
    const std::size_t threads =
        options_.another ? std::min(options_.threads, trials.size() / worth_another_thread) : 1;
    other_spaces_.resize(std::max(other_spaces_.size(), threads));
    std::vector<std::future<void>> helpers;
    for (std::size_t thread = 1; thread < threads; ++thread) {
        helpers.push_back(std::async(std::launch::async, [&, thread] {
            auto& space = other_spaces_[thread];
            if (!space) space = options_.another();
            work(Explanations(explanations_, *space), [](std::size_t) {});
        }));
    }
    try {
        work(explanations_, [&](std::size_t k) { say(what, k, trials.size()); });
    } catch (...) {
        next = trials.size();  // the others end soon, and are waited for
        throw;
    }
    for (auto& helper : helpers) {
        helper.get();
    }
    say(what, trials.size(), trials.size());
    for (auto& each : found) {
        if (each) take(std::move(*each));
    }
}

void Diagnostician::take(Explanation explanation) {
    if (explanation.chosen.size() == 1 && !explanation.suspect) {
        result_.scan[explanation.chosen.front()].refit_drop = base_.chi2 - explanation.chi2;
    }
    if (explanation.accepted) {
        (explanation.suspect ? standing_suspects_ : result_.confidence_set).push_back(explanation);
    }
    result_.tried.push_back(std::move(explanation));
}

void Diagnostician::search_singles() {
    std::vector<const Finding*> worth;
    for (const Finding& finding : result_.scan) {
        if (looks_missing(finding)) worth.push_back(&finding);
    }
    std::ranges::sort(worth, std::greater<>(),
                      [](const Finding* finding) { return finding->test.predicted_drop; });
    // The best first, then those that may do better than what was refused of them.
    for (std::size_t from = 0; from < worth.size(); from += best_singles) {
        std::vector<Trial> trials;
        for (std::size_t k = from; k < std::min(from + best_singles, worth.size()); ++k) {
            const Choice chosen = {worth[k]->candidate};
            if (may_do_better(worth[k]->test.predicted_drop)) {
                trials.push_back(
                    {chosen, {}, start_with(chosen, signatures_[worth[k]->candidate].change)});
            }
        }
        if (!trials.empty()) try_all("refits", trials);
    }
}

void Diagnostician::search_suspects() {
    std::vector<std::size_t> worth;
    for (std::size_t k = 0; k < suspect_tests_.size(); ++k) {
        const ScoreTest& test = suspect_tests_[k];
        if (test.p() < worth_refitting && may_do_better(test.predicted_drop)) worth.push_back(k);
    }
    std::ranges::sort(worth, {}, [&](std::size_t k) { return suspect_tests_[k].p(); });
    worth.resize(std::min(worth.size(), options_.most_suspects));
    std::vector<Trial> trials;
    for (const std::size_t k : worth) {
        trials.push_back({{}, k, start_with({}, evidence_.suspects[k].columns)});
    }
    try_all("suspects", trials);
}

bool Diagnostician::may_do_better(double drop) const {
    double best = 0;
    for (const Explanation& each : result_.tried) {
        if (!each.accepted && each.fit.converged) best = std::max(best, base_.chi2 - each.chi2);
    }
    return drop * (1 + foretelling_error) + all_the_same > best;
}

double Diagnostician::left_by(const Choice& chosen) const {
    Eigen::VectorXd left = residuals_->project(residuals_->residuals());
    struct Column {
        Eigen::VectorXd change;
        std::size_t candidate;
        bool bounded;  ///< the only parameter of its candidate
    };
    std::vector<Column> columns;
    for (const std::size_t k : chosen) {
        const Eigen::MatrixXd change =
            residuals_->project(residuals_->whiten(signatures_[k].change));
        if (is_switch(k)) {
            left -= change;
            continue;
        }
        for (Eigen::Index c = 0; c < change.cols(); ++c) {
            columns.push_back({change.col(c), k, change.cols() == 1});
        }
    }
    // An amplitude that would leave its bounds stays there, and the others are found anew.
    while (!columns.empty()) {
        Eigen::MatrixXd all(left.size(), static_cast<Eigen::Index>(columns.size()));
        for (std::size_t c = 0; c < columns.size(); ++c) {
            all.col(static_cast<Eigen::Index>(c)) = columns[c].change;
        }
        const Eigen::VectorXd amplitudes = all.colPivHouseholderQr().solve(left);
        const auto beyond = std::ranges::find_if(columns, [&](const Column& column) {
            const double wanted = amplitudes(&column - columns.data());
            return column.bounded && within_bounds(column.candidate, wanted) != wanted;
        });
        if (beyond == columns.end()) {
            return (left - all * amplitudes).squaredNorm();
        }
        left -=
            within_bounds(beyond->candidate, amplitudes(beyond - columns.begin())) * beyond->change;
        columns.erase(beyond);
    }
    return left.squaredNorm();
}

double Diagnostician::within_bounds(std::size_t candidate, double amplitude) const {
    const bool one_sided = signatures_[candidate].one_sided;
    if (one_sided && amplitude < 0) return 0;
    const double there = addition(candidate).amplitude_at(
        addition(candidate).value_at(amplitude, one_sided), one_sided);
    constexpr double rounding = 1e-6;
    return std::abs(there - amplitude) < rounding * (1 + std::abs(amplitude)) ? amplitude : there;
}

void Diagnostician::search_pairs() {
    struct Pair {
        Choice chosen;
        double left;
    };
    std::vector<std::size_t> seen;
    std::vector<double> left_alone(signatures_.size(), residuals_->chi2());
    for (const Finding& finding : result_.scan) {
        if (finding.test.seen()) {
            seen.push_back(finding.candidate);
            left_alone[finding.candidate] =
                std::min(left_alone[finding.candidate], left_by({finding.candidate}));
        }
    }
    std::vector<Pair> pairs;
    for (const std::size_t i : seen) {
        for (const std::size_t j : seen) {
            if (i >= j) continue;
            const double left = left_by({i, j});
            // Where one part brings nothing beside the other, that one was not enough alone.
            if (left < std::min(left_alone[i], left_alone[j]) - worth_a_pair &&
                may_do_better(base_.chi2 - left)) {
                pairs.push_back({{i, j}, left});
            }
        }
    }
    std::ranges::sort(pairs, {}, &Pair::left);
    pairs.resize(std::min(pairs.size(), options_.most_pairs));
    std::vector<Trial> trials;
    for (const Pair& pair : pairs) {
        Eigen::MatrixXd columns(residuals_->size(), 0);
        for (const std::size_t k : pair.chosen) {
            columns.conservativeResize(Eigen::NoChange,
                                       columns.cols() + signatures_[k].change.cols());
            columns.rightCols(signatures_[k].change.cols()) = signatures_[k].change;
        }
        trials.push_back({pair.chosen, {}, start_with(pair.chosen, columns)});
    }
    try_all("pairs", trials);
}

void Diagnostician::search() {
    search_singles();
    search_suspects();
    for (const Explanation& each : standing_suspects_) {
        result_.suspects.push_back(evidence_.suspects[*each.suspect].name);
    }
    if (result_.confidence_set.empty()) result_.confidence_set = standing_suspects_;
    if (result_.confidence_set.empty()) search_pairs();
}

void Diagnostician::conclude() {
    const auto& set = result_.confidence_set;
    if (set.empty()) {
        result_.verdict = Verdict::unknown;
        return;
    }
    if (set.front().suspect) {
        result_.verdict = Verdict::suspect_measurement;
        return;
    }
    // What all of them share is missing; without that, they cannot be told apart.
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
        const auto unsettled = [&](const Explanation& each) {
            return each.chosen == Choice{finding.candidate} && !each.fit.converged;
        };
        if (!base && pointed_at) {
            finding.decision = result_.verdict == Verdict::missing ? "missing" : "may be missing";
        } else if (!base && std::ranges::any_of(result_.confidence_set, in_set)) {
            finding.decision = "may be missing too";
        } else if (std::ranges::any_of(result_.tried, unsettled)) {
            finding.decision = "its fit did not settle";
        } else if (!finding.identifiable) {
            finding.decision = "cannot be seen";
        } else if (base) {
            finding.decision =
                finding.power < options_.wanted_power ? "cannot be excluded" : "absent";
        } else {
            finding.decision = looks_missing(finding) ? "does not explain it" : "no sign of it";
        }
    }
}

void Diagnostician::order_scan() {
    std::ranges::stable_sort(result_.scan, std::greater<>(), [](const Finding& finding) {
        return finding.refit_drop.value_or(finding.test.predicted_drop);
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
