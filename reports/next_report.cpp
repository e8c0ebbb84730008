#include "reports/next_steps.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <numbers>

#include "data/quantities/number.h"
#include "data/study/study.h"
#include "reports/figure.h"
#include "reports/figure_style.h"
#include "reports/fit_report.h"
#include "reports/with_error.h"
#include "reports/words.h"

namespace pendular {
namespace {

/// Text of the set points of the rheometer: ", set 0.98 N and about 2.9 rpm"; empty without a cell.
std::string set_points(const Condition& c, const Study& study) {
    constexpr double rpm = 2 * std::numbers::pi / 60;
    const auto set = set_point_of(c, study);
    if (!set) return "";
    // Two digits without an exponent: 250, not 2.5e+02.
    const double speed = std::stod(fmt::format("{:.2g}", set->angular_velocity / rpm));
    return fmt::format(", set {:.3g} N and about {:g} rpm", set->normal_force, speed);
}

/// Text of a condition: "300 Pa, I = 0.03 (shear rate 1.2 1/s, set 0.98 N and about 2.9 rpm), dry,
/// 60 g of beads".
std::string where(const Condition& c, const Study& study) {
    std::string text = fmt::format("{} Pa, I = {:.2g} (shear rate {:.3g} 1/s{})",
                                   short_text(c.normal_stress), c.inertial_number,
                                   shear_rate_at(c.inertial_number, c.normal_stress, study.grains),
                                   set_points(c, study));
    text += c.dry() ? ", dry" : fmt::format(", liquid content {:.3g}", c.liquid_content);
    return c.bead_volume ? text + fmt::format(", {:.3g} g of beads", 1e3 * mass_of(c, study))
                         : text;
}

std::string where(const Point& point, const Study& study) {
    if (!point.direct) {
        constexpr double hour = 3600;
        return where(point.condition, study) +
               (point.wait > 0 ? fmt::format(", after a wait of {:.3g} h", point.wait / hour) : "");
    }
    return point.direct->parameter +
           (point.direct->by.empty() ? "" : fmt::format(" ({})", point.direct->by));
}

std::string readings(int count) {
    return count == 1 ? "1 reading" : fmt::format("{} readings", count);
}

/// Text of `count` measurements at a point: "3 readings, each with a new filling, at 300 Pa, I =
/// 0.03 (shear rate 1.2 1/s), dry", "1 direct measurement of torque-offset.torque".
std::string to_measure(const Point& point, int count, const Study& study) {
    if (!point.direct) {
        return fmt::format("{} at {}",
                           count == 1 ? "1 reading with a new filling"
                                      : fmt::format("{} readings, each with a new filling,", count),
                           where(point, study));
    }
    return fmt::format(
        "{} of {}",
        count == 1 ? "1 direct measurement" : fmt::format("{} direct measurements", count),
        where(point, study));
}

std::vector<std::string> pair_names(const NextMeasurement& next, bool separated) {
    std::vector<std::string> names;
    const auto& known = next.series.separated;
    for (std::size_t i = 0; i < next.rivals.size(); ++i) {
        for (std::size_t j = i + 1; j < next.rivals.size(); ++j) {
            const bool is = std::ranges::find(known, std::pair(i, j)) != known.end();
            if (is == separated) {
                names.push_back(fmt::format("{} and {}", next.rivals[i].name, next.rivals[j].name));
            }
        }
    }
    return names;
}

std::string semicolons(const std::vector<std::string>& names) {
    return fmt::format("{}", fmt::join(names, "; "));
}

/// Adds lines with the prediction of each rival, a model that fits, at the point of a plan.
void add_forecasts(std::vector<std::string>& lines, const NextMeasurement& next, const Plan& plan) {
    if (const auto& direct = next.points[plan.point].direct) {
        lines.push_back(
            fmt::format("  {:<44} {:>30}", "if the missing effect is", direct->parameter));
        for (std::size_t k = 0; k < next.rivals.size(); ++k) {
            const Forecast& forecast = plan.forecasts[k];
            lines.push_back(
                fmt::format("  {:<44} {:>30}", next.rivals[k].name,
                            with_error(forecast.value(0), error_of(forecast)(0), direct->unit)));
        }
        lines.push_back(fmt::format("  (standard error of one measurement: {})",
                                    with_unit(direct->standard_error, direct->unit)));
        return;
    }
    lines.push_back(fmt::format("  {:<44} {:>22} {:>22}", "if the missing effect is",
                                "shear stress [Pa]", "solid fraction [1]"));
    for (std::size_t k = 0; k < next.rivals.size(); ++k) {
        const Forecast& forecast = plan.forecasts[k];
        const Eigen::VectorXd error = error_of(forecast);
        lines.push_back(fmt::format("  {:<44} {:>22} {:>22}", next.rivals[k].name,
                                    with_error(forecast.value(0), error(0)),
                                    with_error(forecast.value(1), error(1))));
    }
    const Eigen::Vector2d noise = plan.noise.diagonal().cwiseSqrt();
    lines.push_back(fmt::format("  (standard deviation of one reading: {:.2g} Pa and {:.2g})",
                                noise(0), noise(1)));
}

std::vector<std::string> separating_lines(const NextMeasurement& next) {
    const auto measure = [&](const Series::Step& step) {
        return to_measure(next.points[step.point], step.readings, next.study);
    };
    const auto& steps = next.series.steps;
    std::vector<std::string> lines;
    if (steps.empty()) {
        const Plan& best = shown_plan(next);
        std::vector<std::string> names;
        std::ranges::transform(next.rivals, std::back_inserter(names), &FittedModel::name);
        lines.push_back(fmt::format(
            "No plan of up to {}, with at most {} at one condition, tells {}{} apart. Their "
            "predictions differ most at {}.",
            readings(next.most_readings), next.most_repeats, names.size() > 2 ? "any two of " : "",
            joined(names, "and"), where(next.points[best.point], next.study)));
        add_forecasts(lines, next, best);
        return lines;
    }
    const std::string apart = semicolons(pair_names(next, true));
    if (steps.size() == 1) {
        lines.push_back(fmt::format("Take {}. In 8 of 10 cases, this tells {} apart.",
                                    measure(steps[0]), apart));
        add_forecasts(lines, next, plan_at(next, steps[0].point));
    } else {
        lines.push_back(
            fmt::format("Take these {} measurements. In 8 of 10 cases, they tell "
                        "{} apart together.",
                        next.series.readings(), apart));
        for (const Series::Step& step : steps) {
            lines.push_back(measure(step));
            add_forecasts(lines, next, plan_at(next, step.point));
        }
    }
    if (const auto left = pair_names(next, false); !left.empty()) {
        lines.push_back(fmt::format("These measurements do not tell apart: {}.", semicolons(left)));
    }
    return lines;
}

std::vector<std::string> sharpening_lines(const NextMeasurement& next) {
    const Sharpening& best = next.sharpenings.front();
    const FittedModel& model = next.rivals.front();
    std::vector<std::string> lines = {
        fmt::format("Optional: take {}. Of all conditions considered, readings at "
                    "this condition reduce the standard errors of the fitted parameters most.",
                    to_measure(next.points[best.point], next.most_repeats, next.study))};
    const auto& parameters = model.predictor->parameters();
    for (std::size_t k = 0; k < parameters.size(); ++k) {
        const auto i = static_cast<Eigen::Index>(k);
        lines.push_back(
            fmt::format("  {}: standard error {} -> {}", parameters[k].name,
                        with_unit(std::sqrt(model.fit.covariance(i, i)), parameters[k].unit),
                        with_unit(best.standard_errors(i), parameters[k].unit)));
    }
    lines.emplace_back(
        "  (errors of a fit to all readings, for comparison with each other only; the errors to "
        "report are those of 'pendular calibrate')");
    return lines;
}

/// Whether two conditions differ only in the inertial number.
bool at_other_number(const Condition& a, const Condition& b) {
    return a.normal_stress == b.normal_stress && a.liquid_content == b.liquid_content &&
           a.bead_volume == b.bead_volume && a.time == b.time;
}

/// Whether two conditions differ only in the normal stress, at equal shear rate (`same_rate`) or at
/// equal inertial number.
bool beside(const Condition& a, const Condition& b, const Study& study, bool same_rate) {
    const auto rate = [&](const Condition& c) {
        return shear_rate_at(c.inertial_number, c.normal_stress, study.grains);
    };
    const auto close = [](double x, double y) { return std::abs(x - y) <= 1e-6 * std::abs(y); };
    return a.liquid_content == b.liquid_content && a.bead_volume == b.bead_volume &&
           a.time == b.time &&
           (same_rate ? close(rate(a), rate(b)) : close(a.inertial_number, b.inertial_number));
}

}  // namespace

std::vector<std::string> plan_lines(const NextMeasurement& next) {
    if (next.points.empty()) {
        return {
            "No reading can be planned: the simulations in atlas and store cover none of the "
            "conditions that the rheometer can reach. 'pendular campaign' makes simulations "
            "there."};
    }
    return next.plans.empty() ? sharpening_lines(next) : separating_lines(next);
}

Output next_output(const NextMeasurement& next, const StudyDiagnosis& diagnosis,
                   const std::vector<NextStep>& steps, bool has_rig) {
    const std::vector<std::string> plan = plan_lines(next);
    std::vector<std::string> lines = steps.empty() ? plan : step_lines(steps, plan);
    Output output;
    output.answer(lines.front());
    lines.erase(lines.begin());
    output.lines(std::move(lines));
    add_limits(output, diagnosis.models->simulation().emulator().runs(), diagnosis.readings,
               next.rivals.front().fit.parameters(0));
    const bool possible = !next.points.empty();
    if (std::ranges::any_of(steps, &NextStep::readings) && !has_rig) {
        output.note(
            "study.toml has no section [rig] with the settings that the rheometer can reach: the "
            "plan stays near the conditions already measured. 'pendular next --help' shows an "
            "example.");
    }
    if (!possible && !steps.empty()) {
        output.note(plan.front());
    } else if (possible && next.unsupported > 0) {
        output.note(
            fmt::format("The simulations in atlas and store do not cover {} of {} conditions; the "
                        "plan leaves them out. 'pendular campaign' makes simulations there.",
                        next.unsupported, next.unsupported + next.points.size()));
    }
    return output;
}

namespace {

/// Models with a curve: `look_of_series` has as many looks with shapes and dashes of their own.
constexpr std::size_t most_rivals = most_named_series;

/// Plans along the normal stress, or along the inertial number where only one normal stress can be
/// set, and the places of the readings to make there, in the figure of a next measurement.
struct NextCurves {
    bool over_number = false;
    std::vector<const Plan*> along;
    std::vector<double> places;  ///< normal stress [Pa] or inertial number [1]

    double place_of(const Condition& condition) const {
        return over_number ? condition.inertial_number : condition.normal_stress;
    }
};

/// Curves along one of the two quantities through the condition `at`.
NextCurves curves_along(const NextMeasurement& next, const std::vector<Plan>& plans,
                        const Condition& at, bool over_number) {
    const bool same_rate = next.study.rig && next.study.rig->shear_rate;
    const auto shown = [&](std::size_t point) {
        const Condition& condition = next.points[point].condition;
        return !next.points[point].direct &&
               (over_number ? at_other_number(condition, at)
                            : beside(condition, at, next.study, same_rate));
    };
    NextCurves curves{.over_number = over_number, .along = {}, .places = {}};
    for (const Plan& plan : plans) {
        if (shown(plan.point)) curves.along.push_back(&plan);
    }
    std::ranges::sort(curves.along, {}, [&](const Plan* plan) {
        return curves.place_of(next.points[plan->point].condition);
    });
    for (const Series::Step& each : next.series.steps) {
        const double place = curves.place_of(next.points[each.point].condition);
        if (shown(each.point) && std::ranges::find(curves.places, place) == curves.places.end())
            curves.places.push_back(place);
    }
    if (next.series.steps.empty()) curves.places.push_back(curves.place_of(at));
    return curves;
}

NextCurves curves_of(const NextMeasurement& next, const std::vector<Plan>& plans) {
    const auto& steps = next.series.steps;
    const auto step = std::ranges::find_if(
        steps, [&](std::size_t point) { return !next.points[point].direct; }, &Series::Step::point);
    const std::size_t first = step == steps.end()
                                  ? std::ranges::max_element(plans, {}, &Plan::noncentrality)->point
                                  : step->point;
    const Condition& at = next.points[first].condition;
    NextCurves curves = curves_along(next, plans, at, false);
    return curves.along.size() > 1 ? curves : curves_along(next, plans, at, true);
}

/// Difference of a model's prediction from that of the first model [%], along the axis.
Curve difference(const NextMeasurement& next, const NextCurves& curves, std::size_t model,
                 Eigen::Index observable) {
    Curve line = model_line(plain_text(next.rivals[model].name),
                            look_of_series(model, std::min(next.rivals.size(), most_rivals)));
    for (const Plan* plan : curves.along) {
        const Forecast& forecast = plan->forecasts[model];
        const double whole = plan->forecasts.front().value(observable) / 100;
        line.x.push_back(curves.place_of(next.points[plan->point].condition));
        line.y.push_back(forecast.value(observable) / whole - 100);
        line.y_error.push_back(error_of(forecast)(observable) / whole);
    }
    return line;
}

Panel next_panel(const NextMeasurement& next, const NextCurves& curves, Eigen::Index observable) {
    Panel panel{.x_label = curves.over_number ? "inertial number I" : "normal stress σ_{22} [Pa]",
                .y_label = observable == 0 ? "difference in stress ratio [%]"
                                           : "difference in solid fraction [%]",
                .log_x = true,
                .key = observable == 0};
    for (const double place : curves.places) {
        panel.references.push_back({"measure here", place, 0, true, measured_colour});
    }
    for (std::size_t k = 0; k < std::min(next.rivals.size(), most_rivals); ++k) {
        const Curve line = difference(next, curves, k, observable);
        Curve band = line, bare = line;
        band.style = Curve::Style::band;
        band.dash.clear();
        band.in_key = false;
        bare.y_error.clear();
        bare.in_table = false;
        bare.banded = true;
        bare.label += ", ± 1 standard error";
        panel.curves.push_back(band);
        panel.curves.push_back(bare);
    }
    return panel;
}

}  // namespace

Figure next_figure(const NextMeasurement& next) {
    Figure figure{.name = "next", .title = "", .panels = {}, .stacked = true};
    std::vector<Plan> plans;
    std::ranges::copy_if(next.plans, std::back_inserter(plans),
                         [&](const Plan& plan) { return !next.points[plan.point].direct; });
    if (plans.empty()) return figure;
    const NextCurves curves = curves_of(next, plans);
    if (curves.along.size() < 2) return figure;  // nothing varies
    figure.title = fmt::format("Predictions of the models that fit, relative to {}{}",
                               plain_text(next.rivals[0].name),
                               curves.places.empty() ? "; a direct measurement tells them apart"
                                                     : ", and suggested readings");
    figure.panels = {next_panel(next, curves, 0), next_panel(next, curves, 1)};
    return figure;
}

}  // namespace pendular
