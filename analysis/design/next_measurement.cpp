#include "analysis/design/next_measurement.h"

#include <fmt/format.h>

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>
#include <optional>
#include <tuple>

#include "analysis/design/point.h"

namespace pendular {
namespace {

/// `count` values from the lower to the upper end of a range, evenly spaced in the logarithm; only
/// the lower end where the range is a single value.
std::vector<double> steps(const Span& span, int count) {
    if (span.greatest <= span.least * (1 + 1e-9)) {
        return {span.least};
    }
    std::vector<double> values;
    for (int k = 0; k < count; ++k) {
        values.push_back(span.least * std::pow(span.greatest / span.least,
                                               static_cast<double>(k) / (count - 1)));
    }
    return values;
}

/// Forecasts of one rival model at all points, with their derivatives by the parameters.
struct Forecasts {
    std::vector<Forecast> at;             ///< forecast at each point
    std::vector<Eigen::MatrixXd> slopes;  ///< derivatives at each point, entries x parameters
};

Forecasts forecasts_of(const FittedModel& rival, const std::vector<Point>& points) {
    Forecasts result;
    // One point at a time, since the covariance between points is not needed.
    for (const Point& point : points) {
        const Prediction predicted = predicted_at(rival, {point});
        result.at.push_back({.value = predicted.value,
                             .from_parameters = predicted.jacobian * rival.fit.covariance *
                                                predicted.jacobian.transpose(),
                             .from_simulation = predicted.covariance});
        result.slopes.push_back(predicted.jacobian);
    }
    return result;
}

Eigen::MatrixXd noise_of(const Point& point, const Forecast& forecast,
                         const Eigen::Vector2d& relative_noise) {
    return noise_at({point}, forecast.value, relative_noise).asDiagonal();
}

double cost_of(const Point& point, int readings) {
    return point.first_cost + point.wait_cost + point.cost * readings;
}

/// Separation of two rivals by n readings: T (`criterion`) and D' S_1^-1 D (`noncentrality`) of
/// `separating_plans`.
struct Separation {
    double criterion, noncentrality;
};

Separation separation(const Forecast& a, const Forecast& b, const Eigen::MatrixXd& noise, int n) {
    const Eigen::VectorXd difference = a.value - b.value;
    const Eigen::MatrixXd reading = noise / n,
                          simulation = 0.5 * (a.from_simulation + b.from_simulation),
                          parameters = a.from_parameters + b.from_parameters;
    const Eigen::MatrixXd twice = (2 * reading + parameters + 2 * simulation).inverse();
    const Eigen::MatrixXd once = (reading + parameters + simulation).inverse();
    return {difference.dot(twice * difference) + (2 * reading * twice).trace(),
            difference.dot(once * difference)};
}

std::vector<std::pair<std::size_t, std::size_t>> separated_by(const Plan& plan, int n) {
    std::vector<std::pair<std::size_t, std::size_t>> pairs;
    for (std::size_t i = 0; i < plan.forecasts.size(); ++i) {
        for (std::size_t j = i + 1; j < plan.forecasts.size(); ++j) {
            const double enough = plan.noise.rows() == 1 ? telling_directly : telling_noncentrality;
            if (separation(plan.forecasts[i], plan.forecasts[j], plan.noise, n).noncentrality >=
                enough) {
                pairs.emplace_back(i, j);
            }
        }
    }
    return pairs;
}

Plan plan_for(std::size_t point, const Point& at, const std::vector<Forecasts>& forecasts,
              const Eigen::Vector2d& relative_noise, int most_repeats) {
    Plan plan{.point = point};
    for (const Forecasts& rival : forecasts) {
        plan.forecasts.push_back(rival.at[point]);
    }
    plan.noise = noise_of(at, plan.forecasts.front(), relative_noise);
    for (std::size_t i = 0; i < plan.forecasts.size(); ++i) {
        for (std::size_t j = i + 1; j < plan.forecasts.size(); ++j) {
            const Separation most =
                separation(plan.forecasts[i], plan.forecasts[j], plan.noise, most_repeats);
            plan.separation += most.criterion;
            plan.noncentrality += most.noncentrality;
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

/// Direct measurements of effects that the study defines, whose accuracy the study states there and
/// neither in the rig's tables nor as a result.
std::vector<StatedDirect> written_direct(const Study& study, const Rig& rig) {
    std::vector<StatedDirect> all;
    for (const WrittenEffect& written : study.written_effects) {
        const auto known = [&](const std::vector<StatedDirect>& stated) {
            return std::ranges::find(stated, written.name, &StatedDirect::effect) != stated.end();
        };
        if (written.measured_to == 0 || known(rig.direct) || known(study.direct)) continue;
        all.push_back({.effect = written.name,
                       .error = fmt::format("{} {}", written.measured_to, written.unit),
                       .effect_position = written.name_position,
                       .error_position = written.position});
    }
    return all;
}

}  // namespace

std::vector<Point> points_of(const Rig& rig, const ResolvedStudy& resolved, double time) {
    const Study& study = resolved;
    // Chosen: neighbouring points of the grid predict nearly the same, and the time to compare all
    // points grows with their number.
    constexpr int stresses = 7, rates = 4;
    // Gives planned readings a height, which is known only once they are made. Only effects
    // depend on it.
    constexpr double typical_solid_fraction = 0.6;
    std::vector<std::optional<double>> fillings(rig.bead_volumes.begin(), rig.bead_volumes.end());
    if (fillings.empty()) {
        fillings.push_back(study.cell && study.cell->bead_volume > 0
                               ? std::optional(study.cell->bead_volume)
                               : std::nullopt);
    }
    std::vector<Point> points;
    const auto add = [&](double stress, double number, double content,
                         const std::optional<double>& filling, double wait) {
        constexpr double hour = 3600;
        Point point{.condition = {.normal_stress = stress,
                                  .inertial_number = number,
                                  .liquid_content = content,
                                  .bead_volume = filling,
                                  .time = time + wait},
                    .wait = wait,
                    .wait_cost = rig.hour_cost * wait / hour,
                    .cost = content > 0 ? rig.wet_cost : 1};
        if (filling && study.cell) {
            AnnularCell cell = *study.cell;
            // Within 2 %, as replicates, the beads are those that are in the cell.
            const bool other = std::abs(*filling / cell.bead_volume - 1) > 0.02;
            point.first_cost = cell.bead_volume > 0 && other ? rig.filling_cost : 0;
            cell.bead_volume = *filling;
            point.condition.height = height(typical_solid_fraction, cell);
        }
        points.push_back(point);
    };
    for (const auto& filling : fillings) {
        for (const double content : rig.liquid_contents) {
            for (const double rate :
                 steps(rig.shear_rate ? *rig.shear_rate : *rig.inertial_number, rates)) {
                for (const double stress : steps(rig.normal_stress, stresses)) {
                    for (const double wait : rig.waits) {
                        add(stress,
                            rig.shear_rate ? inertial_number(rate, stress, study.grains) : rate,
                            content, filling, wait);
                    }
                }
            }
        }
    }
    for (const StatedDirect& stated : rig.direct) {
        points.push_back({.direct = direct_measurement(stated, study, resolved.catalogue()),
                          .cost = stated.cost});
    }
    for (const StatedDirect& stated : written_direct(study, rig)) {
        points.push_back({.direct = direct_measurement(stated, study, resolved.catalogue())});
    }
    return points;
}

Rig rig_of(const std::vector<Reading>& readings) {
    Rig rig{.normal_stress = {INFINITY, 0}, .inertial_number = Span{INFINITY, 0}};
    rig.liquid_contents.clear();
    for (const Reading& reading : readings) {
        const Condition& c = reading.condition;
        const auto widen = [](Span& span, double value) {
            span = {std::min(span.least, value), std::max(span.greatest, value)};
        };
        widen(rig.normal_stress, c.normal_stress);
        widen(*rig.inertial_number, c.inertial_number);
        if (std::ranges::none_of(rig.liquid_contents, [&](double known) {
                return std::abs(known - c.liquid_content) < 1e-9;
            })) {
            rig.liquid_contents.push_back(c.liquid_content);
        }
    }
    if (rig.inertial_number->least <= 0) {
        // A logarithmic scale cannot start from zero. From this number, the stress ratio of
        // dry grains is within 1 % of the quasi-static limit.
        constexpr double slow = 1e-3;
        rig.inertial_number = Span{slow, std::max(slow, rig.inertial_number->greatest)};
    }
    return rig;
}

Eigen::Vector2d relative_errors(const std::vector<Reading>& readings) {
    Eigen::Vector2d sum = Eigen::Vector2d::Zero();
    for (const Reading& reading : readings) {
        sum += reading.covariance.diagonal().cwiseQuotient(reading.value.cwiseAbs2());
    }
    return (sum / static_cast<double>(readings.size())).cwiseSqrt();
}

std::vector<Plan> separating_plans(const std::vector<FittedModel>& rivals,
                                   const std::vector<Point>& points,
                                   const Eigen::Vector2d& relative_noise, int most_repeats) {
    std::vector<Forecasts> forecasts;
    for (const FittedModel& rival : rivals) {
        forecasts.push_back(forecasts_of(rival, points));
    }
    std::vector<Plan> plans;
    for (std::size_t point = 0; point < points.size(); ++point) {
        plans.push_back(plan_for(point, points[point], forecasts, relative_noise, most_repeats));
        Plan& plan = plans.back();
        plan.cost = cost_of(points[point], std::max(1, plan.repeats));
    }
    std::ranges::stable_sort(plans, {}, [](const Plan& plan) {
        return std::tuple(-static_cast<double>(plan.separated.size()), plan.cost, -plan.separation);
    });
    return plans;
}

Series next_series(const std::vector<Plan>& plans, const std::vector<FittedModel>& rivals,
                   const std::vector<Point>& points, const Eigen::Vector2d& relative_noise,
                   const Rig& rig) {
    const Plan& best = plans.front();
    Series alone;
    if (best.repeats > 0) alone = {{{best.point, best.repeats}}, best.separated, best.cost};
    if (best.separated.size() == rivals.size() * (rivals.size() - 1) / 2) return alone;
    Series series = separating_series(rivals, points, relative_noise, rig.repeats, rig.readings);
    return series.separated.size() > alone.separated.size() ? series : alone;
}

std::vector<Sharpening> sharpening_plans(const FittedModel& model, const std::vector<Point>& points,
                                         const Eigen::Vector2d& relative_noise, int repeats) {
    const Forecasts forecasts = forecasts_of(model, points);
    const Eigen::MatrixXd known = model.fit.covariance.inverse();
    const Eigen::ArrayXd before = model.fit.covariance.diagonal().array().sqrt();
    std::vector<Sharpening> plans;
    for (std::size_t point = 0; point < points.size(); ++point) {
        const Forecast& forecast = forecasts.at[point];
        const Eigen::MatrixXd& slopes = forecasts.slopes[point];
        const Eigen::MatrixXd error =
            noise_of(points[point], forecast, relative_noise) / repeats + forecast.from_simulation;
        const Eigen::MatrixXd after =
            (known + slopes.transpose() * error.inverse() * slopes).inverse();
        const Eigen::VectorXd errors = after.diagonal().cwiseSqrt();
        const double cost = cost_of(points[point], repeats);
        plans.push_back({point, forecast, errors, (before / errors.array()).log().sum() / cost});
    }
    std::ranges::stable_sort(plans, std::greater<>(), &Sharpening::gain);
    return plans;
}

}  // namespace pendular
