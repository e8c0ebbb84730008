#include "workflow/next_json.h"

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>

#include "analysis/diagnosis/study_evidence.h"
#include "data/study/study.h"
#include "workflow/run_json.h"

namespace pendular {
namespace {

using Json = nlohmann::ordered_json;

Json point_json(const Point& point, const Study& study) {
    if (point.direct) {
        return {{"direct", point.direct->parameter},
                {"unit", point.direct->unit},
                {"stderr", point.direct->standard_error}};
    }
    const Condition& c = point.condition;
    Json json = {{"normal_stress", c.normal_stress},
                 {"inertial_number", c.inertial_number},
                 {"shear_rate", shear_rate_at(c.inertial_number, c.normal_stress, study.grains)},
                 {"liquid_content", c.liquid_content}};
    if (c.bead_volume) {
        json["bead_mass"] = mass_of(c, study);
    }
    if (const auto set = set_point_of(c, study)) {
        json["normal_force"] = set->normal_force;
        json["angular_velocity"] = set->angular_velocity;
    }
    json["time"] = c.time;
    json["wait"] = point.wait;
    return json;
}

Json forecast_json(const std::string& name, const Forecast& forecast) {
    const Eigen::VectorXd error = error_of(forecast);
    if (error.size() == 1) {
        return {{"rival", name}, {"direct", uncertain(forecast.value(0), error(0))}};
    }
    return {{"rival", name},
            {"shear_stress", uncertain(forecast.value(0), error(0))},
            {"solid_fraction", uncertain(forecast.value(1), error(1))}};
}

Json plan_json(const NextMeasurement& next, const Plan& plan) {
    Json json = {{"point", point_json(next.points[plan.point], next.study)},
                 {"repeats", plan.repeats},
                 {"cost", plan.cost},
                 {"criterion", plan.separation},
                 {"separated", Json::array()},
                 {"forecasts", Json::array()}};
    for (const auto& [i, j] : plan.separated) {
        json["separated"].push_back({next.rivals[i].name, next.rivals[j].name});
    }
    for (std::size_t k = 0; k < next.rivals.size(); ++k) {
        json["forecasts"].push_back(forecast_json(next.rivals[k].name, plan.forecasts[k]));
    }
    return json;
}

Json series_json(const NextMeasurement& next) {
    Json json = {{"readings", next.series.readings()},
                 {"cost", next.series.cost},
                 {"separated", Json::array()},
                 {"steps", Json::array()}};
    for (const auto& [i, j] : next.series.separated) {
        json["separated"].push_back({next.rivals[i].name, next.rivals[j].name});
    }
    for (const Series::Step& step : next.series.steps) {
        Json one = {{"point", point_json(next.points[step.point], next.study)},
                    {"readings", step.readings},
                    {"forecasts", Json::array()}};
        const Plan& plan = plan_at(next, step.point);
        for (std::size_t k = 0; k < next.rivals.size(); ++k) {
            one["forecasts"].push_back(forecast_json(next.rivals[k].name, plan.forecasts[k]));
        }
        json["steps"].push_back(std::move(one));
    }
    return json;
}

}  // namespace

Json to_json(const NextMeasurement& next) {
    Json json = {{"rivals", Json::array()}};
    for (const FittedModel& rival : next.rivals) {
        json["rivals"].push_back(rival.name);
    }
    if (!next.plans.empty()) {
        constexpr std::size_t others = 4;
        json["separable"] = !next.series.steps.empty();
        json["series"] = series_json(next);
        const Plan& shown = shown_plan(next);
        json.update(plan_json(next, shown));
        json["others"] = Json::array();
        for (const Plan& plan : next.plans) {
            if (&plan != &shown && json["others"].size() < others) {
                json["others"].push_back(plan_json(next, plan));
            }
        }
        return json;
    }
    if (next.sharpenings.empty()) return json;
    const Sharpening& best = next.sharpenings.front();
    json["point"] = point_json(next.points[best.point], next.study);
    json["repeats"] = next.most_repeats;
    json["standard_errors"] = Json::object();
    const auto& parameters = next.rivals.front().predictor->parameters();
    for (std::size_t k = 0; k < parameters.size(); ++k) {
        const auto i = static_cast<Eigen::Index>(k);
        json["standard_errors"][parameters[k].name] = {
            {"before", std::sqrt(next.rivals.front().fit.covariance(i, i))},
            {"after", best.standard_errors(i)}};
    }
    return json;
}

}  // namespace pendular
