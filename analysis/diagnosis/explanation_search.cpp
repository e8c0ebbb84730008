#include "analysis/diagnosis/explanation_search.h"

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>
#include <functional>
#include <stdexcept>
#include <utility>

#include "analysis/diagnosis/ranking.h"
#include "analysis/diagnosis/side_by_side.h"

namespace pendular {
namespace {

/// Smallest reduction of chi2, in the linear estimate, that the second candidate of a pair must add
/// for a refit: the mean reduction by a parameter that explains nothing.
constexpr double worth_a_pair = 1;
/// Largest amount by which the predicted reduction of chi2 may be below the reduction by a rejected
/// model, so that a refit is still worth its time. Models whose chi2 differ by less may be rejected
/// or accepted for other reasons.
constexpr double all_the_same = 10;
/// Largest relative excess of a refit's reduction of chi2 over the linear estimate [1]. In 344 of
/// 346 refits, both differed by at most a fifth or 4 (docs/validation.md, Diagnosis).
constexpr double foretelling_error = 0.2;
/// Number of candidates that are refitted at a time. Chosen: each batch may rule out what the next
/// one would refit (`may_do_better`).
constexpr std::size_t best_singles = 6;

class ExplanationSearch {
  public:
    ExplanationSearch(const ModelSpace& space, const Evidence& evidence,
                      const DiagnosisOptions& options, const Explanations& explanations,
                      const Scanned& scanned)
        : space_(space),
          evidence_(evidence),
          options_(options),
          explanations_(explanations),
          scanned_(scanned) {}

    Found run() {
        search_singles();
        search_suspects();
        search_pairs();
        prefer_one_effect();
        return std::move(found_);
    }

  private:
    void say(std::string_view what, std::size_t done, std::size_t of) const {
        if (options_.progress) options_.progress(what, done, of);
    }
    bool is_switch(std::size_t k) const { return space_.candidates()[k].is_switch(); }
    const Addition& addition(std::size_t k) const { return scanned_.additions[k]; }

    void search_singles();
    void search_suspects();
    void search_pairs();
    /// Whether a model whose predicted reduction of chi2 is `drop` may have a lower chi2 than the
    /// models that were refitted and rejected.
    bool may_do_better(double drop) const;
    /// chi2 of the model with an effect set, in the linear approximation, with switches on and
    /// amplitudes within their bounds.
    double left_by(const EffectSet& chosen) const;
    /// Amplitude within the candidate's bounds that is nearest to `amplitude`.
    double within_bounds(std::size_t candidate, double amplitude) const;
    /// Model to be refitted: candidates to add, a suspect measurement, and starting values.
    struct Trial {
        EffectSet chosen;
        std::optional<std::size_t> suspect;
        Eigen::VectorXd start;
    };
    /// Refits the models and tests whether they fit, in parallel where there are enough of them.
    /// `what` names the work for the progress report.
    void try_all(std::string_view what, const std::vector<Trial>& trials);
    void take(FittedModel explanation);
    /// Akaike's criterion of the model, for errors as large as the best refitted model needs.
    double criterion(const FittedModel& model) const {
        return explanations_.criterion(model, factor_on_variance(found_.tried));
    }
    /// Criterion of the best of the models; infinite if there is none.
    double best_of(const std::vector<FittedModel>& models) const;
    /// chi2 below which a pair may be clearly better than all models that fit; infinite if none
    /// fits.
    double chi2_to_beat() const;
    /// Accepts less probable models with one effect too (DiagnosisOptions::least_p): where none
    /// fits, those that no other explanation outdoes; beside one that fits, those that the
    /// criterion does not rule out, although a further effect would improve them: a test at the 5 %
    /// level rejects one true model in twenty, and the rival would be named in its place.
    void keep_less_probable(std::vector<FittedModel>& singles,
                            const std::vector<FittedModel>& pairs);
    /// Decides between models with one effect, pairs and suspect measurements that fit.
    void prefer_one_effect();
    Eigen::VectorXd start_with(const EffectSet& chosen, const Eigen::MatrixXd& columns) const;

    const ModelSpace& space_;
    const Evidence& evidence_;
    const DiagnosisOptions& options_;
    const Explanations& explanations_;
    const Scanned& scanned_;
    Found found_;
};

Eigen::VectorXd ExplanationSearch::start_with(const EffectSet& chosen,
                                              const Eigen::MatrixXd& columns) const {
    // Solution of the linear problem: all amplitudes together, and the change of the parameters.
    const Eigen::MatrixXd whitened = scanned_.residuals.whiten(columns);
    const Eigen::VectorXd amplitudes =
        scanned_.residuals.project(whitened).colPivHouseholderQr().solve(
            scanned_.residuals.residuals());
    std::vector<double> added;
    Eigen::VectorXd applied = amplitudes;
    Eigen::Index column = 0;
    for (const std::size_t k : chosen) {
        if (is_switch(k)) {
            applied(column++) = 1;
            continue;
        }
        const bool one_sided = scanned_.signatures[k].one_sided;
        const double least = one_sided ? 0.1 : -INFINITY;  // slopes may vanish at neutral
        applied(column) = std::max(amplitudes(column), least);
        added.push_back(addition(k).value_at(applied(column++), one_sided));
    }
    for (; column < columns.cols(); ++column) {
        added.push_back(amplitudes(column));
    }
    const Eigen::VectorXd own =
        scanned_.base.fit.parameters - scanned_.residuals.parameter_shift_of(whitened * applied);
    Eigen::VectorXd start(own.size() + static_cast<Eigen::Index>(added.size()));
    start << own,
        Eigen::Map<Eigen::VectorXd>(added.data(), static_cast<Eigen::Index>(added.size()));
    return start;
}

/// Model refitted with candidates or a suspect measurement and tested; empty where the fit reaches
/// an amplitude that is impossible for these readings.
std::optional<FittedModel> explained(const Explanations& explanations, const EffectSet& chosen,
                                     std::optional<std::size_t> suspect,
                                     const Eigen::VectorXd& start) {
    try {
        FittedModel explanation = explanations.refit(chosen, suspect, start);
        explanations.judge(explanation);
        return explanation;
    } catch (const std::domain_error&) {
        return {};
    }
}

void ExplanationSearch::try_all(std::string_view what, const std::vector<Trial>& trials) {
    std::vector<std::optional<FittedModel>> found(trials.size());
    side_by_side(
        trials.size(), options_.threads, [&](std::size_t k) { say(what, k, trials.size()); },
        [&](std::size_t k) {
            found[k] =
                explained(explanations_, trials[k].chosen, trials[k].suspect, trials[k].start);
        });
    say(what, trials.size(), trials.size());
    for (auto& each : found) {
        if (each) take(std::move(*each));
    }
}

void ExplanationSearch::take(FittedModel explanation) {
    if (explanation.accepted) {
        (explanation.suspect ? found_.fitting_suspects : found_.fitting).push_back(explanation);
    }
    found_.tried.push_back(std::move(explanation));
}

double ExplanationSearch::best_of(const std::vector<FittedModel>& models) const {
    double best = INFINITY;
    for (const FittedModel& each : models) {
        best = std::min(best, criterion(each));
    }
    return best;
}

double ExplanationSearch::chi2_to_beat() const {
    double best = INFINITY;
    for (const auto* models : {&found_.fitting, &found_.fitting_suspects}) {
        for (const FittedModel& each : *models)
            best = std::min(best, each.fit.chi2);
    }
    return best - clearly_better * factor_on_variance(found_.tried);
}

void ExplanationSearch::keep_less_probable(std::vector<FittedModel>& singles,
                                           const std::vector<FittedModel>& pairs) {
    const bool others_fit = !singles.empty();
    const double limit =
        others_fit ? best_of(singles) + ruled_out
                   : std::min(best_of(found_.fitting_suspects), best_of(pairs) + clearly_better);
    for (FittedModel& each : found_.tried) {
        if (each.accepted || each.suspect || each.chosen.size() != 1 || !each.fit.converged ||
            !each.fit.determines_all())
            continue;
        const double p = others_fit ? 2 * each.lack_of_fit_p : each.p();
        if (p < options_.least_p || criterion(each) > limit) continue;
        each.accepted = true;
        singles.push_back(each);
    }
}

void ExplanationSearch::prefer_one_effect() {
    std::vector<FittedModel> singles, pairs;
    for (FittedModel& each : found_.fitting) {
        (each.chosen.size() == 1 ? singles : pairs).push_back(std::move(each));
    }
    keep_less_probable(singles, pairs);
    if (!pairs.empty()) {
        const double limit = best_of(singles) - clearly_better;
        std::erase_if(pairs, [&](const FittedModel& each) { return criterion(each) > limit; });
    }
    found_.fitting = std::move(singles);
    found_.fitting.insert(found_.fitting.end(), pairs.begin(), pairs.end());
}

void ExplanationSearch::search_singles() {
    std::vector<const Finding*> worth;
    for (const Finding& finding : scanned_.findings) {
        if (looks_missing(finding)) worth.push_back(&finding);
    }
    std::ranges::sort(worth, std::greater<>(),
                      [](const Finding* finding) { return finding->test.predicted_reduction; });
    // The best candidates first, then candidates that may do better than the rejected models.
    for (std::size_t from = 0; from < worth.size(); from += best_singles) {
        std::vector<Trial> trials;
        for (std::size_t k = from; k < std::min(from + best_singles, worth.size()); ++k) {
            const EffectSet chosen = {worth[k]->candidate};
            if (may_do_better(worth[k]->test.predicted_reduction)) {
                trials.push_back(
                    {chosen,
                     {},
                     start_with(chosen, scanned_.signatures[worth[k]->candidate].change)});
            }
        }
        if (!trials.empty()) try_all("refits", trials);
    }
}

void ExplanationSearch::search_suspects() {
    std::vector<std::size_t> worth;
    for (std::size_t k = 0; k < scanned_.suspect_tests.size(); ++k) {
        const ScoreTest& test = scanned_.suspect_tests[k];
        if (test.p() < significant_p && may_do_better(test.predicted_reduction)) worth.push_back(k);
    }
    std::ranges::sort(worth, {}, [&](std::size_t k) { return scanned_.suspect_tests[k].p(); });
    worth.resize(std::min(worth.size(), options_.most_suspects));
    std::vector<Trial> trials;
    for (const std::size_t k : worth) {
        trials.push_back({{}, k, start_with({}, evidence_.suspects[k].columns)});
    }
    try_all("suspects", trials);
}

bool ExplanationSearch::may_do_better(double drop) const {
    double best = 0;
    for (const FittedModel& each : found_.tried) {
        if (!each.accepted && each.fit.converged)
            best = std::max(best, scanned_.base.fit.chi2 - each.fit.chi2);
    }
    return drop * (1 + foretelling_error) + all_the_same > best;
}

double ExplanationSearch::left_by(const EffectSet& chosen) const {
    Eigen::VectorXd left = scanned_.residuals.project(scanned_.residuals.residuals());
    struct Column {
        Eigen::VectorXd change;
        std::size_t candidate;
        bool bounded;  ///< the only parameter of its candidate
    };
    std::vector<Column> columns;
    for (const std::size_t k : chosen) {
        const Eigen::MatrixXd change =
            scanned_.residuals.project(scanned_.residuals.whiten(scanned_.signatures[k].change));
        if (is_switch(k)) {
            left -= change;
            continue;
        }
        for (Eigen::Index c = 0; c < change.cols(); ++c) {
            columns.push_back({change.col(c), k, change.cols() == 1});
        }
    }
    // An amplitude that would leave its bounds is fixed at the bound, and the other amplitudes are
    // computed again.
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

double ExplanationSearch::within_bounds(std::size_t candidate, double amplitude) const {
    const bool one_sided = scanned_.signatures[candidate].one_sided;
    if (one_sided && amplitude < 0) return 0;
    const double there = addition(candidate).amplitude_at(
        addition(candidate).value_at(amplitude, one_sided), one_sided);
    constexpr double rounding = 1e-6;  // of the way from amplitude to value and back
    return std::abs(there - amplitude) < rounding * (1 + std::abs(amplitude)) ? amplitude : there;
}

void ExplanationSearch::search_pairs() {
    struct EffectPair {
        EffectSet chosen;
        double left;
    };
    std::vector<std::size_t> seen;
    std::vector<double> left_alone(scanned_.signatures.size(), scanned_.residuals.chi2());
    for (const Finding& finding : scanned_.findings) {
        if (finding.test.seen()) {
            seen.push_back(finding.candidate);
            left_alone[finding.candidate] =
                std::min(left_alone[finding.candidate], left_by({finding.candidate}));
        }
    }
    // Where a model fits already, only pairs that would be clearly better.
    const double enough = chi2_to_beat();
    std::vector<EffectPair> pairs;
    for (const std::size_t i : seen) {
        for (const std::size_t j : seen) {
            if (i >= j) continue;
            const double left = left_by({i, j});
            // Where one member of a pair adds nothing, the other was not sufficient alone.
            if (left < std::min({enough, left_alone[i], left_alone[j]}) - worth_a_pair &&
                may_do_better(scanned_.base.fit.chi2 - left)) {
                pairs.push_back({{i, j}, left});
            }
        }
    }
    std::ranges::sort(pairs, {}, &EffectPair::left);
    pairs.resize(std::min(pairs.size(), options_.most_pairs));
    std::vector<Trial> trials;
    for (const EffectPair& pair : pairs) {
        Eigen::MatrixXd columns(scanned_.residuals.size(), 0);
        for (const std::size_t k : pair.chosen) {
            columns.conservativeResize(Eigen::NoChange,
                                       columns.cols() + scanned_.signatures[k].change.cols());
            columns.rightCols(scanned_.signatures[k].change.cols()) = scanned_.signatures[k].change;
        }
        trials.push_back({pair.chosen, {}, start_with(pair.chosen, columns)});
    }
    try_all("pairs", trials);
}

}  // namespace

bool looks_missing(const Finding& finding) {
    return finding.test.seen() && finding.test.p() < significant_p;
}

Found search_explanations(const ModelSpace& space, const Evidence& evidence,
                          const DiagnosisOptions& options, const Explanations& explanations,
                          const Scanned& scanned) {
    return ExplanationSearch(space, evidence, options, explanations, scanned).run();
}

}  // namespace pendular
