#include "analysis/next_measurement.h"

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>
#include <tuple>

namespace pendular {
namespace {

/// Of one rival at all points, with the slopes by its parameters.
struct Forecasts {
    std::vector<Forecast> at;
    std::vector<Eigen::MatrixXd> slopes;  ///< 2 x parameters each
};

Forecasts forecasts_of(const Rival& rival, const std::vector<Point>& points) {
    Forecasts result;
    // A few points at a time: the covariance of all with all is not wanted.
    for (const Point& point : points) {
        const Prediction said =
            rival.model->predict_conditions(rival.parameters, {point.condition});
        result.at.push_back(
            {.value = said.value,
             .from_parameters = said.jacobian * rival.covariance * said.jacobian.transpose(),
             .from_simulation = said.covariance});
        result.slopes.push_back(said.jacobian);
    }
    return result;
}

Eigen::Matrix2d noise_at(const Forecast& forecast, const Eigen::Vector2d& relative_noise) {
    return relative_noise.cwiseProduct(forecast.value).cwiseAbs2().asDiagonal();
}

/// What n readings tell of two rivals.
struct Separation {
    double criterion, noncentrality;
};

Separation separation(const Forecast& a, const Forecast& b, const Eigen::Matrix2d& noise, int n) {
    const Eigen::Vector2d difference = a.value - b.value;
    const Eigen::Matrix2d reading = noise / n,
                          simulation = 0.5 * (a.from_simulation + b.from_simulation),
                          parameters = a.from_parameters + b.from_parameters;
    const Eigen::Matrix2d twice = (2 * reading + parameters + 2 * simulation).inverse();
    const Eigen::Matrix2d once = (reading + parameters + simulation).inverse();
    return {difference.dot(twice * difference) + (2 * reading * twice).trace(),
            difference.dot(once * difference)};
}

std::vector<std::pair<std::size_t, std::size_t>> separated_by(const Plan& plan, int n) {
    std::vector<std::pair<std::size_t, std::size_t>> pairs;
    for (std::size_t i = 0; i < plan.forecasts.size(); ++i) {
        for (std::size_t j = i + 1; j < plan.forecasts.size(); ++j) {
            if (separation(plan.forecasts[i], plan.forecasts[j], plan.noise, n).noncentrality >=
                telling_noncentrality) {
                pairs.emplace_back(i, j);
            }
        }
    }
    return pairs;
}

Plan plan_for(std::size_t point, const std::vector<Forecasts>& forecasts,
              const Eigen::Vector2d& relative_noise, int most_repeats) {
    Plan plan{.point = point};
    for (const Forecasts& rival : forecasts) {
        plan.forecasts.push_back(rival.at[point]);
    }
    plan.noise = noise_at(plan.forecasts.front(), relative_noise);
    for (std::size_t i = 0; i < plan.forecasts.size(); ++i) {
        for (std::size_t j = i + 1; j < plan.forecasts.size(); ++j) {
            plan.separation +=
                separation(plan.forecasts[i], plan.forecasts[j], plan.noise, most_repeats)
                    .criterion;
        }
    }
    plan.separated = separated_by(plan, most_repeats);
    for (int n = 1; n <= most_repeats && !plan.separated.empty() && plan.repeats == 0; ++n) {
        if (separated_by(plan, n).size() == plan.separated.size()) {
            plan.repeats = n;
        }
    }
    return plan;
}

}  // namespace

std::vector<Plan> separating_plans(const std::vector<Rival>& rivals,
                                   const std::vector<Point>& points,
                                   const Eigen::Vector2d& relative_noise, int most_repeats) {
    std::vector<Forecasts> forecasts;
    for (const Rival& rival : rivals) {
        forecasts.push_back(forecasts_of(rival, points));
    }
    std::vector<Plan> plans;
    for (std::size_t point = 0; point < points.size(); ++point) {
        plans.push_back(plan_for(point, forecasts, relative_noise, most_repeats));
        Plan& plan = plans.back();
        plan.cost = points[point].first_cost + points[point].cost * std::max(1, plan.repeats);
    }
    std::ranges::stable_sort(plans, {}, [](const Plan& plan) {
        return std::tuple(-static_cast<double>(plan.separated.size()), plan.cost, -plan.separation);
    });
    return plans;
}

std::vector<Sharpening> sharpening_plans(const Rival& model, const std::vector<Point>& points,
                                         const Eigen::Vector2d& relative_noise, int repeats) {
    const Forecasts forecasts = forecasts_of(model, points);
    const Eigen::MatrixXd known = model.covariance.inverse();
    const Eigen::ArrayXd before = model.covariance.diagonal().array().sqrt();
    std::vector<Sharpening> plans;
    for (std::size_t point = 0; point < points.size(); ++point) {
        const Forecast& forecast = forecasts.at[point];
        const Eigen::MatrixXd& slopes = forecasts.slopes[point];
        const Eigen::Matrix2d error =
            noise_at(forecast, relative_noise) / repeats + forecast.from_simulation;
        const Eigen::MatrixXd after =
            (known + slopes.transpose() * error.inverse() * slopes).inverse();
        const Eigen::VectorXd errors = after.diagonal().cwiseSqrt();
        const double cost = points[point].first_cost + points[point].cost * repeats;
        plans.push_back({point, forecast, errors, (before / errors.array()).log().sum() / cost});
    }
    std::ranges::stable_sort(plans, std::greater<>(), &Sharpening::gain);
    return plans;
}

}  // namespace pendular
