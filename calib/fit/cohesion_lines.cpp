#include "calib/fit/cohesion_lines.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>
#include <tuple>
#include <utility>

#include "calib/fit/fit.h"
#include "data/input_error.h"
#include "sim/dem/run_parameters.h"

namespace pendular {
namespace {

/// Relative tolerance of the liquid contents of one group [1]: that of replicates' normal stresses.
constexpr double liquid_content_tolerance = 0.02;

bool alike(const Condition& a, const Condition& b) {
    return a.at_failure == b.at_failure &&
           agree(a.liquid_content, b.liquid_content, liquid_content_tolerance) &&
           agree(a.inertial_number, b.inertial_number, inertial_number_tolerance);
}

}  // namespace

bool agree(double a, double b, double tolerance) {
    return std::abs(a - b) <= tolerance * std::max(std::abs(a), std::abs(b));
}

std::vector<WetGroup> wet_groups(const std::vector<Reading>& readings) {
    std::vector<WetGroup> groups;
    for (std::size_t k = 0; k < readings.size(); ++k) {
        const Condition& own = readings[k].condition;
        if (own.dry()) {
            continue;
        }
        // Each reading joins the first group with whose first reading it agrees.
        const auto home = std::ranges::find_if(groups, [&](const WetGroup& group) {
            return alike(readings[group.members.front()].condition, own);
        });
        (home == groups.end() ? groups.emplace_back() : *home).members.push_back(k);
    }
    for (WetGroup& group : groups) {
        group.at_failure = readings[group.members.front()].condition.at_failure;
        for (const std::size_t k : group.members) {
            group.liquid_content += readings[k].condition.liquid_content;
            group.inertial_number += readings[k].condition.inertial_number;
        }
        const auto count = static_cast<double>(group.members.size());
        group.liquid_content /= count, group.inertial_number /= count;
    }
    std::ranges::sort(groups, {}, [](const WetGroup& g) {
        return std::tuple(g.liquid_content, g.inertial_number, g.at_failure);
    });
    return groups;
}

namespace {

/// Relative difference up to which two reduced pressures count as equal [1], as the normal stresses
/// of replicates do (`are_replicates`).
constexpr double reduced_pressure_tolerance = 0.02;

/// Points of a group of wet readings: stress ratio against 1/P*, with covariance.
struct Points {
    Eigen::VectorXd inverse_pressure;  ///< 1/P* [1]
    Eigen::VectorXd stress_ratio;
    Eigen::MatrixXd covariance;  ///< covariance of the stress ratios
    Eigen::MatrixXd weighting;   ///< covariance of the readings, whose inverse weights the points

    Eigen::Index size() const { return inverse_pressure.size(); }
    double reduced_pressure(Eigen::Index k) const { return 1 / inverse_pressure(k); }
    Points only(const std::vector<Eigen::Index>& which) const {
        return {inverse_pressure(which), stress_ratio(which), covariance(which, which),
                weighting(which, which)};
    }
};

const Condition& condition(const std::vector<Reading>& readings, Eigen::Index k) {
    return readings[static_cast<std::size_t>(k)].condition;
}

std::string name_of(const WetGroup& group) {
    return group.inertial_number == 0
               ? fmt::format("liquid content {:.3g}, quasi-static", group.liquid_content)
               : fmt::format("liquid content {:.3g}, inertial number {:.2g}", group.liquid_content,
                             group.inertial_number);
}

/// Readings of a group as points, in decreasing P*.
Points points_of(const WetGroup& group, const std::vector<Reading>& readings,
                 const LineValues& values, const GrainProperties& grains, const Liquid& liquid) {
    std::vector<Eigen::Index> order(group.members.begin(), group.members.end());
    std::ranges::stable_sort(order, std::greater<>(),
                             [&](Eigen::Index k) { return condition(readings, k).normal_stress; });
    const auto n = std::ssize(order);
    Points points{Eigen::VectorXd(n), Eigen::VectorXd(n), Eigen::MatrixXd(n, n),
                  Eigen::MatrixXd(n, n)};
    for (Eigen::Index i = 0; i < n; ++i) {
        const Eigen::Index k = order[static_cast<std::size_t>(i)];
        const double normal_stress = condition(readings, k).normal_stress;
        points.inverse_pressure(i) = 1 / reduced_pressure(normal_stress, grains, liquid);
        points.stress_ratio(i) = values.value(2 * k) / normal_stress;
        for (Eigen::Index j = 0; j < n; ++j) {
            const Eigen::Index l = order[static_cast<std::size_t>(j)];
            const double unit = normal_stress * condition(readings, l).normal_stress;
            points.covariance(i, j) = values.covariance(2 * k, 2 * l) / unit;
            points.weighting(i, j) = values.weighting(2 * k, 2 * l) / unit;
        }
    }
    return points;
}

/// Straight line as a model of stress ratios, with the intercept and the reduced cohesion as its
/// parameters. Its predictions contain only the stress ratio of each point.
class StraightLine : public Model {
  public:
    explicit StraightLine(const Eigen::VectorXd& inverse_pressure)
        : matrix_(inverse_pressure.size(), 2) {
        matrix_ << Eigen::VectorXd::Ones(inverse_pressure.size()), inverse_pressure;
    }
    const std::vector<Parameter>& parameters() const override { return parameters_; }
    Prediction predict(const Eigen::VectorXd& line, PredictionPart /*what*/) const override {
        const Eigen::MatrixXd exact = Eigen::MatrixXd::Zero(matrix_.rows(), matrix_.rows());
        return {matrix_ * line, matrix_, exact, exact};
    }
    ParameterBounds bounds() const override {
        return {Eigen::Vector2d::Constant(-unbounded), Eigen::Vector2d::Constant(unbounded)};
    }
    const Eigen::MatrixXd& matrix() const { return matrix_; }

  private:
    static constexpr double unbounded = 1e9;  // far beyond any stress ratio
    std::vector<Parameter> parameters_ = {
        {.name = "intercept", .lower = -unbounded, .upper = unbounded},
        {.name = "reduced cohesion", .lower = -unbounded, .upper = unbounded}};
    Eigen::MatrixXd matrix_;
};

/// Indices of the points at or above the lowest fitted reduced pressure, and of the points below
/// it.
struct Split {
    std::vector<Eigen::Index> fitted, below;
};

Split split(const Points& points, const CohesionOptions& options) {
    Split result;
    for (Eigen::Index k = 0; k < points.size(); ++k) {
        (options.fits(points.reduced_pressure(k)) ? result.fitted : result.below).push_back(k);
    }
    return result;
}

/// Relative deviation (line - value)/value at each point below the limit, with its standard error.
/// The line is [1 1/P*] K y, with the estimator K of intercept and slope from the fitted stress
/// ratios y; errors of y and of the points below may be correlated.
std::vector<Overestimate> overestimates(const Points& all, const Split& which,
                                        const Eigen::MatrixXd& estimator,
                                        const Eigen::Vector2d& line) {
    std::vector<Overestimate> result;
    for (const Eigen::Index k : which.below) {
        const Eigen::RowVector2d at(1, all.inverse_pressure(k));
        const double value = all.stress_ratio(k), predicted = at * line;
        Eigen::RowVectorXd slope = Eigen::RowVectorXd::Zero(all.size());
        slope(which.fitted) = at * estimator / value;
        slope(k) = -predicted / (value * value);
        const double variance = slope * all.covariance * slope.transpose();
        // Where the model is itself a line, the variance is 0, and rounding may make it negative.
        result.push_back({all.reduced_pressure(k),
                          {(predicted - value) / value, std::sqrt(std::max(0.0, variance))}});
    }
    return result;
}

/// Fits the line. Its errors follow from the covariance C of the points: K C K', with the estimator
/// K = (A'WA)^-1 A'W.
CohesionLine line_through(const Points& all, const Split& which) {
    const Points fitted = all.only(which.fitted);
    const StraightLine line(fitted.inverse_pressure);
    const Fit fit =
        pendular::fit(line, {fitted.stress_ratio, fitted.weighting}, Eigen::Vector2d::Zero());
    const Eigen::MatrixXd estimator =
        fit.covariance * line.matrix().transpose() * fitted.weighting.inverse();
    const Eigen::Matrix2d covariance = estimator * fitted.covariance * estimator.transpose();
    const Eigen::Vector2d error = covariance.diagonal().cwiseSqrt();
    CohesionLine result;
    result.stress_ratio_intercept = {fit.parameters(0), error(0)};
    result.reduced_cohesion = {fit.parameters(1), error(1)};
    result.correlation = covariance(0, 1) / (error(0) * error(1));
    result.points = static_cast<int>(fitted.size());
    result.chi2 = fit.chi2;
    result.dof = fit.dof;
    result.lowest_reduced_pressure = 1 / fitted.inverse_pressure.maxCoeff();
    result.below = overestimates(all, which, estimator, fit.parameters);
    return result;
}

bool has_two_distinct(const Points& points) {
    return points.size() > 1 &&
           !agree(points.inverse_pressure.minCoeff(), points.inverse_pressure.maxCoeff(),
                  reduced_pressure_tolerance);
}

std::string list_of_pressures(const Points& points, const std::vector<Eigen::Index>& which) {
    std::vector<std::string> texts;
    double last = 0;
    for (const Eigen::Index k : which) {
        const double pressure = points.reduced_pressure(k);
        if (agree(std::exchange(last, pressure), pressure, reduced_pressure_tolerance))
            continue;  // a replicate
        texts.push_back(fmt::format("{:.3g}", pressure));
    }
    return fmt::format("{}", fmt::join(texts, ", "));
}

/// Explains which readings of a group are not on its line.
std::string note_on(const WetGroup& group, const Points& all, const Split& which, bool has_line,
                    double limit) {
    if (has_line)
        return fmt::format(
            "The cohesion line through the readings for {} is fitted to points with P* >= {:.3g}; "
            "it leaves out those at P* = {}",
            name_of(group), limit, list_of_pressures(all, which.below));
    std::vector<Eigen::Index> every = which.fitted;
    every.insert(every.end(), which.below.begin(), which.below.end());
    return fmt::format(
        "There is no cohesion line through the readings for {}: it needs points at two reduced "
        "pressures P* of {:.3g} or more that differ by 2 %; there are points at P* = {}",
        name_of(group), limit, list_of_pressures(all, every));
}

}  // namespace

void check_options(const CohesionOptions& options) {
    if (!(options.lowest_reduced_pressure > 0) || !std::isfinite(options.lowest_reduced_pressure)) {
        throw InputError(fmt::format("lowest reduced pressure {}: it must be above 0",
                                     options.lowest_reduced_pressure));
    }
    const double rate = options.inertial_number.value_or(0);
    if (!(rate >= 0) || rate > dem::largest_inertial_number) {
        throw InputError(fmt::format(
            "inertial number {:.3g}: it must be between 0 (quasi-static limit) and {}, above which "
            "grains no longer flow densely",
            rate, dem::largest_inertial_number));
    }
}

bool CohesionOptions::fits(double reduced_pressure) const {
    constexpr double rounding = 1e-9;  // of the conversion between stresses and P*
    return reduced_pressure >= lowest_reduced_pressure * (1 - rounding);
}

double stress_ratio(const CohesionLine& line, double reduced_pressure) {
    return line.stress_ratio_intercept.value + line.reduced_cohesion.value / reduced_pressure;
}

std::vector<CohesionLine> cohesion_lines(const std::vector<Reading>& readings,
                                         const LineValues& values, const GrainProperties& grains,
                                         const Liquid& liquid, const CohesionOptions& options,
                                         std::vector<std::string>* notes) {
    std::vector<CohesionLine> result;
    const double unit = pull_off_force(grains, liquid) / (grains.diameter * grains.diameter);
    for (const WetGroup& group : wet_groups(readings)) {
        if (group.at_failure) continue;  // a line is one of steady shear
        const Points all = points_of(group, readings, values, grains, liquid);
        const Split which = split(all, options);
        const bool has_line = has_two_distinct(all.only(which.fitted));
        if (notes && !(has_line && which.below.empty()))
            notes->push_back(note_on(group, all, which, has_line, options.lowest_reduced_pressure));
        if (!has_line) continue;
        CohesionLine line = line_through(all, which);
        line.source = values.source;
        line.liquid_content = group.liquid_content;
        line.inertial_number = group.inertial_number;
        line.cohesion = {line.reduced_cohesion.value * unit,
                         line.reduced_cohesion.standard_error * unit};
        result.push_back(std::move(line));
    }
    return result;
}

}  // namespace pendular
