#include "analysis/diagnosis/explanations.h"

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>
#include <iterator>
#include <map>
#include <memory>
#include <utility>

#include "analysis/diagnosis/ranking.h"

namespace pendular {
namespace {

/// Model with an additional error of the measurement: its parameters include an amplitude for each
/// column of a suspect measurement.
class WithSuspect : public Model {
  public:
    WithSuspect(const Model& inside, const SuspectMeasurement& suspect)
        : inside_(inside), columns_(suspect.columns), parameters_(inside.parameters()) {
        for (Eigen::Index k = 0; k < columns_.cols(); ++k) {
            parameters_.push_back({.name = suspect.name, .lower = -widest, .upper = widest});
        }
    }
    const std::vector<Parameter>& parameters() const override { return parameters_; }
    Prediction predict(const Eigen::VectorXd& parameters, PredictionPart what) const override {
        Prediction prediction = inside_.predict(own(parameters), what);
        prediction.value += columns_ * parameters.tail(columns_.cols());
        if (what != PredictionPart::values) {
            Eigen::MatrixXd jacobian(prediction.value.size(), size());
            jacobian << prediction.jacobian, columns_;
            prediction.jacobian = std::move(jacobian);
        }
        return prediction;
    }
    ParameterBounds bounds() const override {
        const ParameterBounds range = inside_.bounds();
        ParameterBounds all{Eigen::VectorXd::Constant(size(), -widest),
                            Eigen::VectorXd::Constant(size(), widest)};
        all.lower.head(range.lower.size()) = range.lower;
        all.upper.head(range.upper.size()) = range.upper;
        return all;
    }

  private:
    /// No limit in practice: 1 doubles readings, or shifts direct measurements by a standard error.
    static constexpr double widest = 1e3;
    Eigen::Index size() const { return static_cast<Eigen::Index>(parameters_.size()); }
    Eigen::VectorXd own(const Eigen::VectorXd& parameters) const {
        return parameters.head(size() - columns_.cols());
    }

    const Model& inside_;
    Eigen::MatrixXd columns_;
    std::vector<Parameter> parameters_;
};

/// Number of draws that decide where a statistic is far above all of them: a tenth of
/// `DiagnosisOptions::draws`.
constexpr Eigen::Index first_draws = 600;

/// Whether a statistic is so far above all drawn values that further draws would not reach it: by
/// more than three standard deviations of the logarithm of the drawn values. Among values with a
/// tail as heavy as 1/x (two degrees of freedom), one in 30,000 is so far above.
bool far_above(double observed, const Eigen::VectorXd& drawn) {
    const Eigen::ArrayXd logarithm = drawn.array().max(1e-300).log();
    const double deviation = std::sqrt((logarithm - logarithm.mean()).square().mean());
    return std::log(observed) > logarithm.maxCoeff() + 3 * deviation;
}

}  // namespace

WeightedResiduals residuals_of(const Model& model, const Measured& measured, const Fit& fit) {
    Prediction prediction = fit.prediction;
    const ParameterBounds bounds = model.bounds();
    for (std::size_t k = 0; k < model.parameters().size(); ++k) {
        const Parameter& p = model.parameters()[k];
        const auto i = static_cast<Eigen::Index>(k);
        const double least = std::max(p.lower, bounds.lower(i)),
                     greatest = std::min(p.upper, bounds.upper(i)),
                     close = 1e-6 * (greatest - least), at = fit.parameters(i);
        if (at - least < close || greatest - at < close) {
            prediction.jacobian.col(i).setZero();
        }
    }
    return {measured, prediction};
}

Explanations::Explanations(const ModelSpace& space, const Evidence& evidence,
                           const DiagnosisOptions& options)
    : space_(space),
      evidence_(evidence),
      options_(options),
      draws_(std::make_shared<NullDraws>(evidence.measured, evidence.errors, options.seed,
                                         options.draws)) {
    errors.resize(space.candidates().size());
}

Explanations::Explanations(const ModelSpace& space, const Explanations& other)
    : space_(space), evidence_(other.evidence_), options_(other.options_), draws_(other.draws_) {
    errors.resize(space.candidates().size());
}

FittedModel Explanations::refit(const EffectSet& chosen, std::optional<std::size_t> suspect,
                                const Eigen::VectorXd& start) const {
    FittedModel result{.chosen = chosen, .suspect = suspect};
    for (const std::size_t k : chosen) {
        result.effects.push_back(space_.candidates()[k].name);
    }
    const std::shared_ptr<const Model> model = space_.with(chosen);
    result.fit = suspect ? fit(WithSuspect(*model, evidence_.suspects[*suspect]),
                               evidence_.measured, start, refit_effort)
                         : fit(*model, evidence_.measured, start, refit_effort);
    return result;
}

WeightedResiduals Explanations::residuals_of(const FittedModel& explanation) const {
    return pendular::residuals_of(*space_.with(explanation.chosen), evidence_.measured,
                                  explanation.fit);
}

double Explanations::criterion(const FittedModel& explanation, double variance_factor) const {
    return akaike(explanation, variance_factor, residuals_of(explanation).log_determinant());
}

double Explanations::lack_of_fit_p(const WeightedResiduals& residuals, bool roughly) const {
    const Eigen::MatrixXd means = residuals.means_over(evidence_.conditions);
    const double observed = (means.transpose() * residuals.residuals()).squaredNorm();
    const auto drawn = [&](Eigen::Index draws) {
        return Eigen::VectorXd(
            draws_->along(residuals, means, draws).colwise().squaredNorm().transpose());
    };
    if (roughly) {
        const Eigen::VectorXd first = drawn(std::min(first_draws, draws_->count()));
        if (far_above(observed, first)) return NullDraws::p(observed, first);
    }
    return NullDraws::p(observed, drawn(draws_->count()));
}

std::vector<ScoreTest> Explanations::suspect_tests(const WeightedResiduals& residuals,
                                                   std::optional<std::size_t> but) const {
    std::vector<ScoreTest> tests;
    for (std::size_t k = 0; k < evidence_.suspects.size(); ++k) {
        if (k != but) {
            tests.push_back(
                score_test(residuals, {.change = evidence_.suspects[k].columns}, false));
        }
    }
    return tests;
}

Addition Explanations::addition(const FittedModel& explanation, std::size_t candidate) const {
    const std::shared_ptr<const Model> model = space_.with(explanation.chosen);
    const Eigen::VectorXd parameters =
        explanation.fit.parameters.head(std::ssize(model->parameters()));
    Eigen::VectorXd values = explanation.fit.prediction.value;
    if (explanation.suspect) {
        values = model->predict(parameters, PredictionPart::values).value;
    }
    return {space_, explanation.chosen, candidate, parameters, std::move(values)};
}

std::vector<ScoreTest> Explanations::further_tests(const WeightedResiduals& residuals,
                                                   const FittedModel& explanation) const {
    std::vector<ScoreTest> tests = suspect_tests(residuals, explanation.suspect);
    for (std::size_t k = 0; k < space_.candidates().size(); ++k) {
        if (std::ranges::find(explanation.chosen, k) == explanation.chosen.end()) {
            Signature signature = addition(explanation, k).signature(false);
            signature.errors = errors[k];
            tests.push_back(score_test(residuals, signature, space_.candidates()[k].is_switch()));
        }
    }
    return tests;
}

void Explanations::judge(FittedModel& explanation) const {
    const WeightedResiduals residuals = residuals_of(explanation);
    explanation.lack_of_fit_p = lack_of_fit_p(residuals, true);
    // A parameter without a determined value explains nothing, however small chi2 is.
    if (!explanation.fit.converged || !explanation.fit.determines_all() ||
        explanation.lack_of_fit_p < options_.least_p / 2) {
        return;
    }
    const auto tests = further_tests(residuals, explanation);
    double smallest = 1;
    for (const ScoreTest& test : tests) {
        smallest = std::min(smallest, test.p());
    }
    explanation.further_p = FamilyOfTests(tests, residuals, *draws_).p(smallest);
    explanation.accepted = explanation.p() >= options_.significance;
}

namespace {

/// Share of repetitions in which an effect must be part of the leading model [1]: as sure as a test
/// with `significant_p`.
constexpr double sure = 0.95;

/// Criterion of each model in each repetition: draws x models.
Eigen::MatrixXd criteria(const std::vector<FittedModel>& tried, const Explanations& explanations) {
    const double factor = factor_on_variance(tried);
    const NullDraws& draws = explanations.draws();
    Eigen::MatrixXd result(draws.count(), static_cast<Eigen::Index>(tried.size()));
    for (std::size_t m = 0; m < tried.size(); ++m) {
        const WeightedResiduals residuals = explanations.residuals_of(tried[m]);
        const Eigen::MatrixXd along = draws.along(residuals, residuals.residuals());
        const double level = akaike(tried[m], factor, residuals.log_determinant());
        result.col(static_cast<Eigen::Index>(m)) =
            along.row(0).transpose().array() * (2 / std::sqrt(factor)) + level;
    }
    return result;
}

}  // namespace

double share_explained(double excess, const FittedModel& by) {
    const double left = std::max(0.0, by.fit.chi2 - by.fit.dof);
    return excess > 0 ? 1 - left / excess : 0;
}

std::optional<Leaders> find_leaders(double excess, const std::vector<FittedModel>& tried,
                                    const Explanations& explanations) {
    if (tried.empty()) return {};
    const Eigen::MatrixXd criterion = criteria(tried, explanations);
    const auto draws = criterion.rows();
    std::map<std::size_t, double> share;
    std::vector<std::size_t> leading(static_cast<std::size_t>(draws));
    for (Eigen::Index draw = 0; draw < draws; ++draw) {
        Eigen::Index best = 0;
        criterion.row(draw).minCoeff(&best);
        leading[static_cast<std::size_t>(draw)] = static_cast<std::size_t>(best);
        for (const std::size_t k : tried[static_cast<std::size_t>(best)].chosen) {
            share[k] += 1 / static_cast<double>(draws);
        }
    }
    EffectSet leaders;
    for (const auto& [candidate, of_draws] : share) {
        if (of_draws >= sure) leaders.push_back(candidate);
    }
    const auto alone = std::ranges::find_if(tried, [&](const FittedModel& each) {
        return each.chosen == leaders && !each.suspect && each.fit.converged;
    });
    if (leaders.empty() || alone == tried.end()) return {};
    Leaders result{.model = *alone, .explained = share_explained(excess, *alone)};
    const auto rivals = std::ranges::count_if(
        leading, [&](std::size_t m) { return !std::ranges::includes(tried[m].chosen, leaders); });
    result.rival_share = static_cast<double>(rivals) / static_cast<double>(draws);
    if (result.explained < most_of_misfit) return {};
    return result;
}

}  // namespace pendular
