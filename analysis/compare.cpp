#include "analysis/compare.h"

#include <Eigen/Dense>
#include <algorithm>
#include <boost/math/distributions/chi_squared.hpp>
#include <boost/math/distributions/students_t.hpp>
#include <cmath>
#include <functional>

#include "data/replicates.h"

namespace pendular {
namespace {

using Covariate = std::function<double(std::size_t, const Reading&)>;

/// Pearson correlation and its two-sided p by Student's t.
std::pair<double, double> correlation(const std::vector<double>& x, const std::vector<double>& y) {
    const auto n = static_cast<double>(x.size());
    const Eigen::Map<const Eigen::ArrayXd> a(x.data(), static_cast<Eigen::Index>(x.size()));
    const Eigen::Map<const Eigen::ArrayXd> b(y.data(), static_cast<Eigen::Index>(y.size()));
    const Eigen::ArrayXd da = a - a.mean(), db = b - b.mean();
    const double scale = std::sqrt(da.square().sum() * db.square().sum());
    const double r = scale > 0 ? (da * db).sum() / scale : 0.0;
    const double t = std::abs(r) * std::sqrt((n - 2) / std::max(1e-12, 1 - r * r));
    return {r, 2 * boost::math::cdf(boost::math::complement(boost::math::students_t(n - 2), t))};
}

/// Whether a covariate was varied: by a tenth at least. Less is the scatter of set points, or, for
/// the height, the solid fraction itself seen again.
bool varies(const std::vector<double>& x) {
    const auto [low, high] = std::ranges::minmax(x);
    return high - low > 0.1 * std::max(std::abs(low), std::abs(high));
}

std::vector<Trend> trends_of(const std::vector<ReadingMisfit>& readings) {
    const std::vector<std::pair<std::string, Covariate>> covariates = {
        {"normal_stress", [](std::size_t, const Reading& r) { return r.condition.normal_stress; }},
        {"inertial_number",
         [](std::size_t, const Reading& r) { return r.condition.inertial_number; }},
        {"liquid_content",
         [](std::size_t, const Reading& r) { return r.condition.liquid_content; }},
        {"height", [](std::size_t, const Reading& r) { return r.condition.height.value_or(0); }},
        {"run order", [](std::size_t k, const Reading&) { return static_cast<double>(k); }}};
    std::vector<Trend> trends;
    for (const auto& [name, value] : covariates) {
        std::vector<double> x, y[2];
        for (std::size_t k = 0; k < readings.size(); ++k) {
            x.push_back(value(k, readings[k].reading));
            y[0].push_back(readings[k].normalised(0));
            y[1].push_back(readings[k].normalised(1));
        }
        if (readings.size() >= 5 && varies(x)) {
            const auto stress = correlation(x, y[0]), fraction = correlation(x, y[1]);
            trends.push_back(
                {name, {stress.first, fraction.first}, {stress.second, fraction.second}});
        }
    }
    return trends;
}

std::vector<ConditionMisfit> misfit_by_condition(const std::vector<Reading>& readings,
                                                 const std::vector<ReadingMisfit>& misfits) {
    std::vector<ConditionMisfit> groups;
    for (const auto& members : condition_groups(readings)) {
        ConditionMisfit group{readings[members.front()].condition, members, 0};
        for (const std::size_t k : members) {
            group.chi2 += misfits[k].chi2.sum();
        }
        groups.push_back(group);
    }
    return groups;
}

}  // namespace

std::vector<std::vector<std::size_t>> condition_groups(const std::vector<Reading>& readings) {
    std::vector<std::vector<std::size_t>> groups;
    for (std::size_t k = 0; k < readings.size(); ++k) {
        const auto group = std::ranges::find_if(groups, [&](const auto& members) {
            return are_replicates(readings[members.front()], readings[k]);
        });
        if (group == groups.end()) {
            groups.push_back({k});
        } else {
            group->push_back(k);
        }
    }
    return groups;
}

double Misfit::p() const {
    return dof > 0 ? boost::math::cdf(boost::math::complement(boost::math::chi_squared(dof), chi2))
                   : 1.0;
}

Comparison compare(const std::vector<Reading>& readings, const Prediction& prediction,
                   int parameters, std::size_t fitted) {
    const Measured measured = stack(readings);
    const Eigen::MatrixXd total = measured.covariance + prediction.covariance;
    const Eigen::VectorXd misfit = measured.value - prediction.value;
    const Eigen::VectorXd terms = misfit.cwiseProduct(total.llt().solve(misfit));
    Comparison result;
    const auto split = 2 * static_cast<Eigen::Index>(fitted);
    result.fitted = {terms.head(split).sum(), static_cast<int>(split) - parameters};
    result.predicted = {terms.tail(terms.size() - split).sum(),
                        static_cast<int>(terms.size() - split)};
    result.total = {result.fitted.chi2 + result.predicted.chi2,
                    result.fitted.dof + result.predicted.dof};
    for (std::size_t k = 0; k < readings.size(); ++k) {
        const auto at = static_cast<Eigen::Index>(2 * k);
        const Eigen::Vector2d errors = total.diagonal().segment<2>(at).cwiseSqrt();
        result.readings.push_back({readings[k], prediction.value.segment<2>(at),
                                   prediction.covariance.block<2, 2>(at, at), terms.segment<2>(at),
                                   misfit.segment<2>(at).cwiseQuotient(errors)});
        for (std::size_t observable = 0; observable < 2; ++observable) {
            const auto i = at + static_cast<Eigen::Index>(observable);
            result.by_observable[observable] += terms(i);
            result.rms_percent[observable] +=
                std::pow(prediction.value(i) / measured.value(i) - 1, 2) /
                static_cast<double>(readings.size());
        }
    }
    for (double& rms : result.rms_percent) {
        rms = 100 * std::sqrt(rms);
    }
    result.by_condition = misfit_by_condition(readings, result.readings);
    result.trends = trends_of(result.readings);
    return result;
}

Comparison compare(const Calibration& c) {
    return compare(c.readings, c.prediction, static_cast<int>(c.parameters.size()), c.fitted);
}

}  // namespace pendular
