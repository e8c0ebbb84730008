#include "reports/comparison_figures.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "reports/residual_figures.h"
#include "reports/shown.h"
#include "reports/wet_figures.h"

namespace pendular {
namespace {

const std::string friction_label = "intergranular friction μ";
const std::string inertial_label = "inertial number I = γ̇ (m/aσ_{22})^{1/2}";
double calibrated(const Calibration& c) {
    return c.fit.parameters(0);
}

std::vector<Reading> dry_readings(const Calibration& c) {
    std::vector<Reading> dry;
    std::ranges::copy_if(c.readings, std::back_inserter(dry),
                         [](const Reading& r) { return r.condition.dry(); });
    return dry;
}

/// Readings at the lowest inertial number, within 5 %: those of the calibration figure.
std::vector<Reading> slowest(const std::vector<Reading>& readings) {
    const double least = std::ranges::min(readings, {}, [](const Reading& r) {
                             return r.condition.inertial_number;
                         }).condition.inertial_number;
    std::vector<Reading> result;
    std::ranges::copy_if(readings, std::back_inserter(result), [&](const Reading& r) {
        return r.condition.inertial_number <= 1.05 * least;
    });
    return result;
}

/// Model with its standard error along a curve of conditions or frictions.
struct ModelCurve {
    std::vector<double> x;
    std::array<std::vector<double>, 2> value, error;

    void add(double at, const FlowModel::Point& point) {
        x.push_back(at);
        for (Eigen::Index o = 0; o < 2; ++o) {
            value[static_cast<std::size_t>(o)].push_back(point.value(o));
            error[static_cast<std::size_t>(o)].push_back(std::sqrt(point.covariance(o, o)));
        }
    }
    void draw_in(Panel& panel, std::size_t o, const std::string& label) const {
        panel.curves.push_back({.label = label + ", ± 1 standard error",
                                .style = Curve::Style::band,
                                .x = x,
                                .y = value[o],
                                .y_error = error[o],
                                .colour = model_colour,
                                .in_key = false});
        panel.curves.push_back({.label = label,
                                .style = Curve::Style::line,
                                .x = x,
                                .y = value[o],
                                .y_error = {},
                                .colour = model_colour});
    }
};

/// Solid fraction of a run at the study's stiffness, stress ratio as it is.
Shown at_study_stiffness(const dem::RunResult& run, double share) {
    const Mean &ratio = run[dem::Observable::stress_ratio],
               &fraction = run[dem::Observable::solid_fraction];
    const double shift =
        share * dem::rigidity_shift(fraction.value, run[dem::Observable::mean_overlap].value);
    return {{ratio.value, fraction.value - shift}, {ratio.standard_error, fraction.standard_error}};
}

Curve runs_curve(const Calibration& c, const Condition& condition, std::size_t o,
                 double inertial_number) {
    Curve curve{.label = fmt::format("simulations, I = {:.3g}", inertial_number),
                .colour = run_colour,
                .symbol = {Shape::circle, Filling::hollow}};
    for (const auto& run : c.runs) {
        if (!run.crystallised && !run.parameters.wetting &&
            std::abs(run.parameters.inertial_number / inertial_number - 1) < 0.01) {
            const Shown one = at_study_stiffness(
                run,
                stiffness_share(run.parameters.stiffness_number, condition, c.grains, c.fidelity));
            curve.x.push_back(run.parameters.friction);
            curve.y.push_back(one.value[o]);
            curve.y_error.push_back(one.error[o]);
        }
    }
    return curve;
}

Figure calibration_figure(const Calibration& c, const SimulationModel& model) {
    const std::vector<Reading> used = slowest(dry_readings(c));
    const Shown measured = mean_of(used);
    const Condition condition = used.front().condition;
    const Supported range = model.supported();
    ModelCurve curve;
    for (int k = 0; k <= 60; ++k) {
        const double friction = range.lower(0) + (range.upper(0) - range.lower(0)) * k / 60;
        curve.add(friction, model.predict_at(Eigen::VectorXd::Constant(1, friction), condition));
    }
    Figure figure{.name = "calibration",
                  .title = fmt::format("Calibrated friction μ = {:.3f} ± {:.3f}", calibrated(c),
                                       c.fit.standard_error(0)),
                  .panels = {},
                  .stacked = true};
    const double slow = model.inertial_numbers().front();
    const bool limit = condition.inertial_number == 0;
    for (std::size_t o = 0; o < 2; ++o) {
        Panel panel{.x_label = friction_label,
                    .y_label = o == 0 ? stress_ratio_label : solid_fraction_label};
        panel.references.push_back({"measured, ± 1 standard error", measured.value[o],
                                    measured.error[o], false, measured_colour});
        panel.references.push_back({"calibrated, ± 1 standard error", calibrated(c),
                                    c.fit.standard_error(0), true, calibrated_colour});
        panel.curves.push_back(runs_curve(c, condition, o, slow));
        curve.draw_in(
            panel, o,
            limit ? "model, I → 0" : fmt::format("model, I = {:.3g}", condition.inertial_number));
        panel.key = o == 0 ? Key::bottom_right : Key::none;
        figure.panels.push_back(panel);
    }
    return figure;
}

Figure inertial_figure(const Calibration& c, const SimulationModel& model) {
    const auto& levels = model.inertial_numbers();
    const std::vector<Reading> dry = dry_readings(c);
    Condition condition = dry.front().condition;
    const double low = levels.front() / 4, high = levels.back() * 2;
    ModelCurve curve;
    // Faster than simulated there is no model to show; slower it is extrapolated.
    for (int k = 0; k <= 60 && levels.size() > 1; ++k) {
        condition.inertial_number = low * std::pow(levels.back() / low, k / 60.0);
        curve.add(condition.inertial_number, model.predict_at(c.fit.parameters, condition));
    }
    Figure figure{.name = "inertial_number",
                  .title = "Against the inertial number, at the calibrated friction",
                  .panels = {},
                  .stacked = true};
    for (std::size_t o = 0; o < 2; ++o) {
        Panel panel{.x_label = inertial_label,
                    .y_label = o == 0 ? stress_ratio_label : solid_fraction_label,
                    .log_x = true};
        Curve points{.label = "measured", .colour = measured_colour};
        std::vector<Reading> quasi_static;
        for (const auto& reading : dry) {
            if (reading.condition.inertial_number <= 0) {
                quasi_static.push_back(reading);
                continue;
            }
            const Shown one = shown(reading);
            points.x.push_back(reading.condition.inertial_number);
            points.y.push_back(one.value[o]);
            points.y_error.push_back(one.error[o]);
        }
        if (!quasi_static.empty()) {
            const Shown one = mean_of(quasi_static);
            panel.references.push_back(
                {"measured, quasi-static", one.value[o], one.error[o], false, measured_colour});
            condition.inertial_number = 0;
            const auto limit = model.predict_at(c.fit.parameters, condition);
            const auto i = static_cast<Eigen::Index>(o);
            panel.references.push_back({"model, I → 0", limit.value(i),
                                        std::sqrt(limit.covariance(i, i)), false,
                                        calibrated_colour});
        }
        if (!points.x.empty()) {
            panel.curves.push_back(points);
        }
        if (levels.size() > 1) {
            curve.draw_in(panel, o, "model");
        } else {
            condition.inertial_number = levels.front();
            const auto only = model.predict_at(c.fit.parameters, condition);
            const auto i = static_cast<Eigen::Index>(o);
            panel.curves.push_back({.label = "model",
                                    .x = {levels.front()},
                                    .y = {only.value(i)},
                                    .y_error = {std::sqrt(only.covariance(i, i))},
                                    .colour = model_colour,
                                    .symbol = {.shape = Shape::square}});
        }
        panel.x_range = {low, high};
        panel.key = o == 0 ? Key::top_left : Key::none;
        panel.headroom = o == 0 ? 0.3 : 0;
        figure.panels.push_back(panel);
    }
    return figure;
}

Figure parity_figure(const Comparison& comparison) {
    Figure figure{.name = "parity", .title = "Model against measurement", .panels = {}};
    for (std::size_t o = 0; o < 2; ++o) {
        Panel panel{.x_label = o == 0 ? "measured shear stress |σ_{12}| [Pa]"
                                      : "measured solid fraction Φ_S",
                    .y_label = o == 0 ? "predicted shear stress |σ_{12}| [Pa]"
                                      : "predicted solid fraction Φ_S"};
        Curve points{.label = "reading, ± 1 standard error", .colour = model_colour};
        for (const auto& misfit : comparison.readings) {
            const auto i = static_cast<Eigen::Index>(o);
            points.x.push_back(misfit.reading.value(i));
            points.y.push_back(misfit.predicted(i));
            points.y_error.push_back(
                std::sqrt(misfit.reading.covariance(i, i) + misfit.predicted_covariance(i, i)));
        }
        panel.curves.push_back(points);
        panel.diagonal = true;
        panel.key = o == 0 ? Key::top_left : Key::none;
        figure.panels.push_back(panel);
    }
    return figure;
}

}  // namespace

std::vector<Figure> comparison_figures(const StudyModel& study_model,
                                       const Calibration& calibration,
                                       const Comparison& comparison) {
    const SimulationModel& model = study_model.simulation();
    std::vector<Figure> figures;
    if (!dry_readings(calibration).empty()) {
        figures = {calibration_figure(calibration, model), inertial_figure(calibration, model)};
    }
    std::ranges::move(wet_figures(study_model, calibration, calibration.cohesion),
                      std::back_inserter(figures));
    figures.push_back(parity_figure(comparison));
    std::ranges::move(residual_figures(comparison), std::back_inserter(figures));
    return figures;
}

}  // namespace pendular
