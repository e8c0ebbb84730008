#include "reports/misfit_figures.h"

#include <fmt/format.h>

#include <algorithm>
#include <boost/math/interpolators/makima.hpp>
#include <cmath>
#include <numbers>
#include <string>
#include <utility>
#include <vector>

#include "calib/fit/fit.h"
#include "calib/fit/parameter_errors.h"
#include "data/effect_parameter.h"
#include "reports/figure.h"
#include "reports/figure_style.h"

namespace pendular {
namespace {

/// Largest number of parameters with a panel each, and of those with a panel for each pair.
constexpr std::size_t most_profiles = 8, most_in_pairs = 5;
/// Rise of chi2 at the ends of the intervals that hold 68 and 95 % of one parameter, and of the
/// regions that hold 68 and 95 % of two parameters [1].
constexpr double rise_68 = 1, rise_95 = 3.84, rise_68_of_two = 2.30, rise_95_of_two = 5.99;
/// Largest number of shared errors with a bar each.
constexpr std::size_t most_parts = 8;
/// Distance from the fit that a profile reaches, in standard errors [1], number of values with a
/// refit, and number of points drawn between each two of them.
constexpr double profile_reach = 3;
constexpr int refits_of_profile = 9, drawn_between = 8;
/// Least number of values that a profile is interpolated from [Boost.Math, makima].
constexpr std::size_t fewest_to_interpolate = 4;

/// Indices of the parameters whose standard error is smaller than their range.
std::vector<Eigen::Index> determined(const Calibration& c) {
    std::vector<Eigen::Index> result;
    for (std::size_t k = 0; k < c.parameters.size(); ++k) {
        const auto i = static_cast<Eigen::Index>(k);
        const double error = c.fit.standard_error(i), variance = c.fit.covariance(i, i);
        if (variance > 0 && error < c.parameters[k].upper - c.parameters[k].lower) {
            result.push_back(i);
        }
    }
    return result;
}

/// Axis of a parameter: label, and size of the unit of the axis in the SI unit.
struct ParameterAxis {
    std::string label;
    double unit = 1;
};

ParameterAxis axis_of(const Parameter& parameter) {
    if (parameter.name == "friction") return {"intergranular friction μ", 1};
    PrintedUnit unit = printed_unit({.name = parameter.name,
                                     .unit = parameter.unit,
                                     .lower = parameter.lower,
                                     .upper = parameter.upper});
    if (unit.name == "deg") unit.name = "°";
    if (unit.name.starts_with("u")) unit.name.replace(0, 1, "µ");
    return {plain_text(fmt::format("{} [{}]", parameter.name, unit.name)), unit.si};
}

/// Divides values along x by the unit of the axis.
void convert(std::vector<double>& values, double unit) {
    for (double& value : values)
        value /= unit;
}

Panel profile_panel(const Model& model, const Measured& measured, const Fit& best,
                    const Calibration& c, Eigen::Index k) {
    const Parameter& parameter = c.parameters[static_cast<std::size_t>(k)];
    const double fitted = c.fit.parameters(k), error = c.fit.standard_error(k);
    // chi2 lacks what widens the standard error: few replicates, and a larger discrepancy.
    const double share = c.fit.covariance(k, k) / (error * error);
    const ParameterAxis axis = axis_of(parameter);
    Panel panel{.x_label = axis.label, .y_label = "rise of χ^2"};
    Curve profile{.label = "all other parameters refitted",
                  .style = Curve::Style::line,
                  .colour = model_colour},
        parabola{.label = "parabola of the standard error",
                 .style = Curve::Style::dashed_line,
                 .colour = calibrated_colour};
    const Eigen::VectorXd values = Eigen::VectorXd::LinSpaced(
        refits_of_profile, std::max(parameter.lower, fitted - profile_reach * error),
        std::min(parameter.upper, fitted + profile_reach * error));
    const auto parabola_at = [&](double value) { return std::pow((value - fitted) / error, 2); };
    const Eigen::VectorXd rises = share * profile_rise(model, measured, best, k, values);
    // The difference from the parabola is interpolated, which is smoother than the rise itself.
    std::vector<double> at, beyond;
    for (Eigen::Index n = 0; n < values.size(); ++n) {
        if (!std::isfinite(rises(n))) continue;  // impossible readings
        at.push_back(values(n));
        beyond.push_back(rises(n) - parabola_at(values(n)));
    }
    if (at.size() >= fewest_to_interpolate) {
        const auto drawn = static_cast<Eigen::Index>(at.size() - 1) * drawn_between + 1;
        const Eigen::VectorXd points = Eigen::VectorXd::LinSpaced(drawn, at.front(), at.back());
        const boost::math::interpolators::makima<std::vector<double>> difference(
            std::vector<double>(at), std::move(beyond));
        for (const double value : points) {
            parabola.x.push_back(value);
            parabola.y.push_back(parabola_at(value));
            const double rise =
                parabola_at(value) + difference(std::clamp(value, at.front(), at.back()));
            if (rise > profile_reach * profile_reach) continue;  // above the axes
            profile.x.push_back(value);
            profile.y.push_back(rise);
        }
    }
    convert(profile.x, axis.unit);
    convert(parabola.x, axis.unit);
    panel.curves = {profile, parabola};
    panel.references = {{"68 % and 95 % of probability", rise_68, 0, false, "#888888"},
                        {"", rise_95, 0, false, "#888888"}};
    panel.x_range = {values(0) / axis.unit, values(values.size() - 1) / axis.unit};
    panel.y_range = {0, profile_reach * profile_reach};
    return panel;
}

Figure profile_figure(const StudyModel& study_model, const Calibration& c) {
    Figure figure{.name = "profile",
                  .title = "Profile likelihood of the fitted parameters",
                  .panels = {},
                  .columns = 2};
    const std::vector<Reading> fitted(c.readings.begin(),
                                      c.readings.begin() + static_cast<std::ptrdiff_t>(c.fitted));
    const ModelOfReadings model = study_model.at(fitted);
    const Measured measured = stack(fitted, study_model.direct());
    Fit best = c.fit;
    best.prediction = model.predict(best.parameters);  // a fit that was read from a file has none
    for (const Eigen::Index k : determined(c)) {
        if (figure.panels.size() == most_profiles) break;
        figure.panels.push_back(profile_panel(model, measured, best, c, k));
    }
    if (figure.panels.empty()) return figure;
    figure.panels.front().key = true;
    return figure;
}

/// Points of the ellipse at which chi2 of two parameters, as a parabola, rises by `rise` where all
/// other parameters are refitted.
Curve ellipse(const Calibration& c, Eigen::Index a, Eigen::Index b, double rise) {
    constexpr int points = 73;  // one every 5 degrees, and the first again
    Curve curve{.style = Curve::Style::line, .colour = model_colour};
    const Eigen::MatrixXd covariance = c.fit.total_covariance();
    const double sa = std::sqrt(covariance(a, a)), sb = std::sqrt(covariance(b, b)),
                 correlation = std::clamp(covariance(a, b) / (sa * sb), -1.0, 1.0);
    for (int n = 0; n < points; ++n) {
        const double angle = 2 * std::numbers::pi * n / (points - 1), r = std::sqrt(rise);
        curve.x.push_back(c.fit.parameters(a) + r * sa * std::cos(angle));
        curve.y.push_back(c.fit.parameters(b) +
                          r * sb *
                              (correlation * std::cos(angle) +
                               std::sqrt(1 - correlation * correlation) * std::sin(angle)));
    }
    return curve;
}

Panel pair_panel(const Calibration& c, Eigen::Index a, Eigen::Index b) {
    const ParameterAxis along = axis_of(c.parameters[static_cast<std::size_t>(a)]),
                        up = axis_of(c.parameters[static_cast<std::size_t>(b)]);
    Panel panel{.x_label = along.label, .y_label = up.label, .x_uncertain = true};
    Curve inner = ellipse(c, a, b, rise_68_of_two), outer = ellipse(c, a, b, rise_95_of_two);
    inner.label = "68 % of the probability of both";
    outer.label = "95 % of the probability of both";
    outer.style = Curve::Style::dashed_line;
    Curve best{.label = "fit, ± 1 standard error",
               .x = {c.fit.parameters(a)},
               .y = {c.fit.parameters(b)},
               .y_error = {c.fit.standard_error(b)},
               .x_error = {c.fit.standard_error(a)},
               .colour = calibrated_colour};
    for (Curve* const curve : {&inner, &outer, &best}) {
        convert(curve->x, along.unit);
        convert(curve->x_error, along.unit);
        convert(curve->y, up.unit);
        convert(curve->y_error, up.unit);
    }
    panel.curves = {inner, outer, best};
    return panel;
}

Figure corner_figure(const Calibration& c) {
    Figure figure{.name = "corner",
                  .title = "Confidence regions of the fitted parameters, two by two",
                  .panels = {},
                  .columns = 2};
    std::vector<Eigen::Index> shown = determined(c);
    shown.resize(std::min(shown.size(), most_in_pairs));
    for (std::size_t j = 1; j < shown.size(); ++j) {
        for (std::size_t i = 0; i < j; ++i) {
            figure.panels.push_back(pair_panel(c, shown[i], shown[j]));
        }
    }
    if (figure.panels.empty()) return figure;
    figure.panels.front().key = true;
    return figure;
}

/// Bars of the parts of the first parameter's error, the largest at the top.
Figure error_budget(const Calibration& c) {
    Figure figure{.name = "error_budget",
                  .title = plain_text("Parts of the standard error of the fitted " +
                                      c.parameters.front().name)};
    if (!c.fit.determines(0) || !(c.fit.instrument_error(0) > 0)) return figure;
    std::vector<std::pair<double, std::string>> parts = {
        {c.fit.measurement_error(0), "readings"}, {c.fit.simulation_error(0), "simulations"}};
    if (c.fit.discrepancy_error(0) > 0)
        parts.emplace_back(c.fit.discrepancy_error(0), "inexact model");
    for (const InstrumentError& each : largest_errors(c.fit, 0, true, most_parts))
        parts.emplace_back(std::abs(each.shift(0)), each.name);
    std::ranges::sort(parts);
    Panel panel{.x_label = "10^3 × part of the standard error", .y_label = ""};
    Curve bars{.label = "part; the squares of all parts add up",
               .style = Curve::Style::bars_across,
               .colour = model_colour};
    for (const auto& [size, name] : parts) {
        bars.x.push_back(in_thousandths * size);
        bars.y.push_back(static_cast<double>(bars.x.size()));
        panel.y_names.push_back(plain_text(name));
    }
    const double whole = in_thousandths * c.fit.standard_error(0);
    panel.curves = {bars};
    panel.references = {{"whole standard error", whole, 0, true, "#888888"}};
    panel.x_range = {0, 1.08 * whole};
    panel.key = true;
    figure.panels = {panel};
    return figure;
}

}  // namespace

std::vector<Figure> parameter_figures(const StudyModel& model, const Calibration& calibration) {
    Calibration c = calibration;
    c.parameters = model.model().parameters();  // a calibration read from a file lacks the ranges
    std::vector<Figure> figures = {profile_figure(model, c), corner_figure(c), error_budget(c)};
    std::erase_if(figures, [](const Figure& figure) { return figure.panels.empty(); });
    return figures;
}

}  // namespace pendular
