#include "data/recordings/scatter.h"

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>
#include <map>

#include "data/quantities/statistics.h"

namespace pendular {
namespace {

/// Prior of the load exponent, and its largest value, that of an error that is constant in Pa: its
/// share of the stress is as 1/load [1].
constexpr double exponent_prior = 0.5, largest_exponent = 1;
/// Degrees of freedom below which no exponent is sought. Chosen: chance would decide it.
constexpr double fewest_for_exponent = 10;

/// Sets count as scattering differently if the probability of such a difference by chance is below
/// this.
constexpr double unlike = 0.005;
/// Smallest degrees of freedom with which a set, if the sets scatter differently, keeps its own
/// mean square: shrinking it would bias its errors.
constexpr double enough_alone = 5;

double load_variance(const ReplicatedValue& value, double exponent) {
    return std::pow(value.load, -2 * exponent);
}

double shape(const ReplicatedValue& value, double exponent) {
    return std::sqrt(load_variance(value, exponent) + value.rounding);
}

std::vector<std::size_t> distinct(const std::vector<ReplicatedValue>& values,
                                  std::size_t ReplicatedValue::*member) {
    std::vector<std::size_t> all;
    for (const ReplicatedValue& value : values) {
        all.push_back(value.*member);
    }
    std::ranges::sort(all);
    all.erase(std::unique(all.begin(), all.end()), all.end());
    return all;
}

/// Index of the class (condition or file) of each value among the distinct classes.
std::vector<Eigen::Index> indices(const std::vector<ReplicatedValue>& values,
                                  const std::vector<std::size_t>& classes,
                                  std::size_t ReplicatedValue::*member) {
    std::vector<Eigen::Index> result;
    for (const ReplicatedValue& value : values)
        result.push_back(std::ranges::lower_bound(classes, value.*member) - classes.begin());
    return result;
}

/// Weighted sums of values over the classes of two factors, such as conditions and files.
struct TwoWay {
    std::vector<Eigen::Index> first, second;  ///< class of each value in both factors
    Eigen::Index firsts = 0, seconds = 0;     ///< numbers of classes
    Eigen::VectorXd weights;

    Eigen::VectorXd sum_first(const Eigen::VectorXd& x) const { return sum(first, firsts, x); }
    Eigen::VectorXd sum_second(const Eigen::VectorXd& x) const { return sum(second, seconds, x); }
    TwoWay swapped() const { return {second, first, seconds, firsts, weights}; }

  private:
    Eigen::VectorXd sum(const std::vector<Eigen::Index>& classes, Eigen::Index count,
                        const Eigen::VectorXd& x) const {
        Eigen::VectorXd sums = Eigen::VectorXd::Zero(count);
        for (Eigen::Index k = 0; k < x.size(); ++k)
            sums(classes[static_cast<std::size_t>(k)]) += weights(k) * x(k);
        return sums;
    }
};

/// Sums of the weights of each class of the second factor, by class of the first factor.
std::vector<std::map<Eigen::Index, double>> shared_weights(const TwoWay& layout) {
    std::vector<std::map<Eigen::Index, double>> shared(static_cast<std::size_t>(layout.firsts));
    for (std::size_t k = 0; k < layout.first.size(); ++k)
        shared[static_cast<std::size_t>(layout.first[k])][layout.second[k]] +=
            layout.weights(static_cast<Eigen::Index>(k));
    return shared;
}

/// Effects of both factors by weighted least squares, z = first + second + error. The effects of
/// the first factor are eliminated, so that the time is that of solving for as many unknowns as the
/// second factor has classes.
struct Effects {
    Eigen::VectorXd first, second;
};

Effects fit_effects(const TwoWay& layout, const Eigen::VectorXd& z) {
    const Eigen::VectorXd ones = Eigen::VectorXd::Ones(z.size());
    const Eigen::VectorXd weight_first = layout.sum_first(ones), sum_first = layout.sum_first(z);
    Eigen::MatrixXd normal = layout.sum_second(ones).asDiagonal();
    Eigen::VectorXd right = layout.sum_second(z);
    const auto shared = shared_weights(layout);
    for (std::size_t i = 0; i < shared.size(); ++i) {
        const auto at = static_cast<Eigen::Index>(i);
        for (const auto& [j, weight] : shared[i]) {
            right(j) -= weight * sum_first(at) / weight_first(at);
            for (const auto& [k, other] : shared[i])
                normal(j, k) -= weight * other / weight_first(at);
        }
    }
    Effects effects;
    effects.second = normal.completeOrthogonalDecomposition().solve(right);  // singular: a constant
    effects.first = sum_first;
    for (std::size_t i = 0; i < shared.size(); ++i) {
        const auto at = static_cast<Eigen::Index>(i);
        for (const auto& [j, weight] : shared[i])
            effects.first(at) -= weight * effects.second(j);
        effects.first(at) /= weight_first(at);
    }
    return effects;
}

/// Sum of the weights of the values, less what the means of the conditions take up.
double free_weight(const TwoWay& by_condition) {
    double total = by_condition.weights.sum();
    for (const auto& files : shared_weights(by_condition)) {
        double sum = 0, squares = 0;
        for (const auto& [file, weight] : files) {
            sum += weight;
            squares += weight * weight;
        }
        total -= squares / sum;
    }
    return total;
}

}  // namespace

ScatterSums analyse_scatter(const std::vector<ReplicatedValue>& values, double exponent,
                            bool tell_files) {
    const auto n = static_cast<Eigen::Index>(values.size());
    const auto files = distinct(values, &ReplicatedValue::file),
               conditions = distinct(values, &ReplicatedValue::condition);
    TwoWay layout{indices(values, conditions, &ReplicatedValue::condition),
                  indices(values, files, &ReplicatedValue::file), std::ssize(conditions),
                  std::ssize(files), Eigen::VectorXd(n)};
    Eigen::VectorXd z(n);
    double run_variance = 0, step_share = 0;
    for (Eigen::Index k = 0; k < n; ++k) {
        const ReplicatedValue& value = values[static_cast<std::size_t>(k)];
        const double size = shape(value, exponent);
        z(k) = value.deviation;
        layout.weights(k) = 1 / (size * size);
        run_variance += value.within / (size * size);
        step_share += load_variance(value, exponent) / (size * size);
    }
    const Eigen::VectorXd whitening = layout.weights.cwiseSqrt();
    const Eigen::VectorXd means =
        layout.sum_first(z).cwiseQuotient(layout.sum_first(Eigen::VectorXd::Ones(n)));
    ScatterSums sums;
    sums.left_over = whitening.cwiseProduct(z - means(layout.first));
    const double all = sums.left_over.squaredNorm(),
                 freedom = static_cast<double>(n - layout.firsts),
                 between_files = static_cast<double>(layout.seconds) - 1;
    sums.within = all;
    sums.freedom_within = freedom;
    if (tell_files && between_files >= 1 && freedom - between_files >= 1) {
        const bool few_files = layout.seconds < layout.firsts;
        const Effects effects = fit_effects(few_files ? layout : layout.swapped(), z);
        const auto& [of_condition, of_file] =
            few_files ? effects : Effects{effects.second, effects.first};
        sums.left_over =
            whitening.cwiseProduct(z - of_condition(layout.first) - of_file(layout.second));
        sums.within = sums.left_over.squaredNorm();
        sums.freedom_within = freedom - between_files;
        sums.between = std::max(0.0, all - sums.within);
        sums.freedom_between = between_files;
        sums.steps = free_weight(layout);
    }
    sums.run_variance = n > 0 ? run_variance / step_share * sums.freedom_within : 0;
    return sums;
}

LoadExponent load_exponent(const std::vector<std::vector<ReplicatedValue>>& sets) {
    double freedom = 0;
    for (const auto& values : sets) {
        freedom += analyse_scatter(values, 0).freedom_within;
    }
    if (freedom < fewest_for_exponent) return {};
    // -2 log(likelihood times prior), with the variance of each set at its maximum likelihood.
    const auto badness = [&](double exponent) {
        double sum = std::pow(exponent / exponent_prior, 2);
        for (const auto& values : sets) {
            const ScatterSums sums = analyse_scatter(values, exponent);
            if (sums.freedom_within < 1 || !(sums.within > 0)) continue;
            double log_shape = 0;
            for (const ReplicatedValue& value : values) {
                log_shape +=
                    2 * std::log(shape(value, exponent)) / static_cast<double>(values.size());
            }
            sum += sums.freedom_within * (std::log(sums.within / sums.freedom_within) + log_shape);
        }
        return sum;
    };
    constexpr int steps = 40;  // of 0.025, far below the error of an exponent
    double best = 0, least = INFINITY;
    for (int k = 0; k <= steps; ++k) {
        const double exponent = largest_exponent * k / steps, here = badness(exponent);
        if (here < least) least = here, best = exponent;
    }
    constexpr double step = 0.1;  // over the steps of the grid, below the width of the prior
    const double curvature =
        (badness(best + step) + badness(best - step) - 2 * least) / (step * step);
    return {.value = best,
            .standard_error = curvature > 0 ? std::sqrt(2 / curvature) : exponent_prior,
            .evidence = badness(0) - least};
}

namespace {

/// Returns x > 0 with trigamma(x) = y, by Newton's method on 1/trigamma, which is nearly linear.
double inverse_trigamma(double y) {
    double x = 0.5 + 1 / y;
    for (int turn = 0; turn < 50; ++turn) {
        const double value = trigamma(x), step = 1e-4 * x;
        const double slope = (1 / trigamma(x + step) - 1 / trigamma(x - step)) / (2 * step);
        const double next = std::max(x / 10, x - (1 / value - 1 / y) / slope);
        if (std::abs(next - x) < 1e-10 * x) return next;
        x = next;
    }
    return x;
}

}  // namespace

namespace {

/// Probability that mean squares differ so much by chance if all sets have one variance: Bartlett's
/// test.
double scatter_alike_p(const std::vector<MeanSquare>& own, const MeanSquare& pooled) {
    double statistic = 0, inverse = 0, sets = 0, freedom = 0;
    for (const MeanSquare& each : own) {
        if (each.freedom < 1 || !(each.value > 0)) continue;
        statistic += each.freedom * std::log(pooled.value / each.value);
        inverse += 1 / each.freedom;
        freedom += each.freedom;
        ++sets;
    }
    const double correction = 1 + (inverse - 1 / freedom) / (3 * (sets - 1));
    return chi_squared_tail(std::max(0.0, statistic / correction), sets - 1);
}

}  // namespace

std::vector<MeanSquare> moderated(const std::vector<MeanSquare>& own) {
    MeanSquare pooled;
    std::vector<double> logs;
    double spread_by_chance = 0;
    for (const MeanSquare& each : own) {
        pooled.value += each.freedom * each.value;
        pooled.freedom += each.freedom;
        if (each.freedom >= 1 && each.value > 0) {
            logs.push_back(std::log(each.value) - digamma(each.freedom / 2) +
                           std::log(each.freedom / 2));
            spread_by_chance += trigamma(each.freedom / 2);
        }
    }
    if (pooled.freedom > 0) pooled.value /= pooled.freedom;
    const std::vector<MeanSquare> alike(own.size(), pooled);
    if (logs.size() < 2) return alike;
    const auto count = static_cast<double>(logs.size());
    double mean = 0, spread = 0;
    for (const double each : logs)
        mean += each / count;
    for (const double each : logs)
        spread += (each - mean) * (each - mean) / (count - 1);
    const double beyond_chance = spread - spread_by_chance / count;
    if (beyond_chance <= 0 || scatter_alike_p(own, pooled) > unlike) return alike;
    const double prior_freedom = 2 * inverse_trigamma(beyond_chance);
    const double prior = std::exp(mean + digamma(prior_freedom / 2) - std::log(prior_freedom / 2));
    std::vector<MeanSquare> result;
    for (const MeanSquare& each : own) {
        if (each.freedom >= enough_alone) {
            result.push_back(each);
            continue;
        }
        const double freedom = std::min(prior_freedom + each.freedom, pooled.freedom);
        result.push_back(
            {(prior_freedom * prior + each.freedom * each.value) / (prior_freedom + each.freedom),
             freedom});
    }
    return result;
}

}  // namespace pendular
