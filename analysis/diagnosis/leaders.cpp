#include "analysis/diagnosis/leaders.h"

#include <algorithm>
#include <cmath>
#include <map>

#include "analysis/diagnosis/ranking.h"

namespace pendular {
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
