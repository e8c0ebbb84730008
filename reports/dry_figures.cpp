#include "reports/misfit_figures.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <iterator>

#include "calib/model/run_design.h"
#include "calib/model/study_state.h"
#include "reports/figure_style.h"
#include "reports/model_curve.h"
#include "reports/symbol.h"

namespace pendular {
namespace {

const std::string friction_label = "intergranular friction μ";
const std::string inertial_label = "inertial number I = γ̇ (m/aσ_{22})^{1/2}";
constexpr Eigen::Index curve_steps = 60;  ///< straight pieces too short to be seen

/// Inertial numbers that span those of the readings, none below the fidelity's lowest.
std::vector<double> simulated_inertial_numbers(const Calibration& c) {
    return inertial_numbers_for(conditions_of(c.readings), c.fidelity.lowest_inertial_number);
}

/// Data of the dry figures.
struct DryStudy {
    const StudyModel& model;
    const Calibration& calibration;
    std::vector<std::size_t> readings;  ///< indices of the dry readings in the calibration

    double friction() const { return calibration.fit.parameters(0); }
    const Condition& condition(std::size_t place) const {
        return calibration.readings[place].condition;
    }
    Shown measured(std::size_t place) const { return shown(calibration.readings[place]); }
    Shown predicted(std::size_t place) const {
        return shown(calibration.prediction, static_cast<Eigen::Index>(place),
                     condition(place).normal_stress);
    }
    /// Effects of the model on dry readings: those on the instrument, or all others.
    std::vector<const Effect*> effects(bool on_instrument) const {
        std::vector<const Effect*> result;
        std::ranges::copy_if(model.effects(), std::back_inserter(result), [&](const Effect* e) {
            return e->touches != Touches::wet && e->of_instrument() == on_instrument;
        });
        return result;
    }
};

/// Indices of the dry readings in steady shear at the lowest inertial number, within 5 %, for the
/// figure `calibration`; points of failure where there is no steady shear.
std::vector<std::size_t> slowest_of(const DryStudy& study) {
    const auto number = [&](std::size_t k) { return study.condition(k).inertial_number; };
    std::vector<std::size_t> steady;
    std::ranges::copy_if(study.readings, std::back_inserter(steady),
                         [&](std::size_t k) { return !study.condition(k).at_failure; });
    const std::vector<std::size_t>& from = steady.empty() ? study.readings : steady;
    const double least = number(std::ranges::min(from, {}, number));
    std::vector<std::size_t> result;
    std::ranges::copy_if(from, std::back_inserter(result),
                         [&](std::size_t k) { return number(k) <= 1.05 * least; });
    return result;
}

/// Stress ratio of a run, and its solid fraction corrected to the study's stiffness. `share`: share
/// of the rigidity shift to subtract [1].
Shown at_study_stiffness(const dem::RunResult& run, double share) {
    const Mean &ratio = run[dem::Observable::stress_ratio],
               &fraction = run[dem::Observable::solid_fraction];
    const double shift =
        share * dem::rigidity_shift(fraction.value, run[dem::Observable::overlap].value);
    return {{ratio.value, fraction.value - shift}, {ratio.standard_error, fraction.standard_error}};
}

/// Points of dry runs without effects at an inertial number, against friction, corrected to the
/// study's stiffness.
Curve runs_curve(const DryStudy& study, const Condition& condition, std::size_t o,
                 double inertial_number) {
    const Calibration& c = study.calibration;
    const std::string without = names_of(study.effects(false));
    Curve curve{
        .label = fmt::format("simulations{}, {}", without.empty() ? "" : " without " + without,
                             inertial_text(inertial_number)),
        .colour = run_colour,
        .symbol = {Shape::circle, Filling::hollow}};
    for (const auto& run : c.runs) {
        if (!run.crystallised && !run.parameters.wetting && run.parameters.effects.empty() &&
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

/// Curve of the model's true flow at a condition against friction, with the other parameters as
/// fitted.
ModelCurve against_friction(const DryStudy& study, const Condition& condition) {
    const Predictor& flow = study.model.flow();
    Eigen::VectorXd parameters = study.model.flow_parameters(study.calibration.fit.parameters);
    const ParameterBounds range = study.model.simulation().bounds();
    std::vector<double> x;
    Prediction all{
        .value = Eigen::VectorXd(2 * (curve_steps + 1)),
        .jacobian = {},
        .covariance = Eigen::MatrixXd::Zero(2 * (curve_steps + 1), 2 * (curve_steps + 1)),
        .run_noise = {}};
    for (Eigen::Index k = 0; k <= curve_steps; ++k) {
        x.push_back(range.lower(0) +
                    (range.upper(0) - range.lower(0)) * static_cast<double>(k) / curve_steps);
        parameters(0) = x.back();
        const Prediction one = flow.predict(parameters, {condition});
        all.value.segment<2>(2 * k) = one.value;
        all.covariance.block<2, 2>(2 * k, 2 * k) = one.covariance;
    }
    return {x, all, std::vector<Condition>(x.size(), condition)};
}

/// Mean of readings, corrected to one condition and to an ideal instrument: each reading is shifted
/// by the difference that the fitted model predicts.
Shown corrected_mean(const DryStudy& study, const std::vector<std::size_t>& places,
                     const Condition& condition) {
    const Shown there =
        shown(study.model.flow().predict(
                  study.model.flow_parameters(study.calibration.fit.parameters), {condition}),
              0, condition.normal_stress);
    std::vector<Shown> all;
    for (const std::size_t k : places) {
        all.push_back(study.measured(k));
        for (std::size_t o = 0; o < 2; ++o) {
            all.back().value[o] += there.value[o] - study.predicted(k).value[o];
        }
    }
    return mean_of(all);
}

Figure calibration_figure(const DryStudy& study) {
    const Calibration& c = study.calibration;
    const std::vector<std::size_t> used = slowest_of(study);
    const Condition& condition = study.condition(used.front());
    const Shown measured = corrected_mean(study, used, condition);
    const ModelCurve curve = against_friction(study, condition);
    const std::string corrected = names_of(study.effects(true)),
                      with = names_of(study.effects(false));
    Figure figure{
        .name = "calibration",
        .title = fmt::format("Friction coefficient fitted to the dry readings, μ = {:.3f} ± "
                             "{:.3f}{}",
                             study.friction(), c.fit.standard_error(0),
                             corrected.empty() ? "" : ", with " + corrected),
        .panels = {},
        .stacked = true};
    const double slow = simulated_inertial_numbers(c).front();
    for (std::size_t o = 0; o < 2; ++o) {
        Panel panel{.x_label = friction_label,
                    .y_label = o == 0 ? stress_ratio_label : solid_fraction_label};
        panel.references.push_back(
            {corrected.empty()
                 ? measured_text
                 : fmt::format("measured, corrected for {}, ± 1 standard error", corrected),
             measured.value[o], measured.error[o], false, measured_colour});
        panel.references.push_back({"fitted μ, ± 1 standard error", study.friction(),
                                    c.fit.standard_error(0), true, calibrated_colour});
        panel.curves.push_back(runs_curve(study, condition, o, slow));
        if (panel.curves.back().x.empty()) panel.curves.pop_back();  // all of another number
        const std::string label =
            fmt::format("model{}, {}, ± 1 standard error", with.empty() ? "" : " with " + with,
                        inertial_text(condition.inertial_number));
        curve.draw_in(panel, o, {.label = label, .colour = model_colour}, label);
        panel.key = o == 0;
        figure.panels.push_back(panel);
    }
    return figure;
}

/// Data of the figure against the inertial number: readings divided into series that one model
/// curve each can represent.
struct InertialFigure {
    const DryStudy& study;
    std::vector<CurveGroup> series;
    double low, high;               ///< ends of the inertial number axis [1]
    double fastest;                 ///< largest inertial number at which the model is drawn [1]
    bool curves;                    ///< whether the model is known at more than one inertial number
    std::vector<ModelCurve> model;  ///< model curve of each series

    bool parted() const { return series.size() > 1; }
    /// Place of the quasi-static limit on the axis of inertial numbers [1].
    double place_of_limit() const { return low * std::pow(high / low, 0.03); }
    /// Label of the data `what` of a series.
    std::string of(const std::string& what, const CurveGroup& one) const {
        return one.name.empty() ? what : what + ", " + one.name;
    }
};

InertialFigure inertial_figure_of(const DryStudy& study) {
    const Calibration& c = study.calibration;
    const auto levels = simulated_inertial_numbers(c);
    // The axis holds every reading: at constant speed, some are slower than all simulations.
    double slowest = INFINITY, fastest = 0;
    for (const std::size_t k : study.readings) {
        const double number = study.condition(k).inertial_number;
        if (number > 0) slowest = std::min(slowest, number);
        fastest = std::max(fastest, number);
    }
    InertialFigure figure{
        .study = study,
        .series = curve_groups(study.readings, study.model.model(), c, along_inertial_number,
                               {Apart::normal_stress, Apart::bead_volume, Apart::file}),
        .low = std::min(levels.front() / 4, slowest / 1.5),
        .high = std::max(levels.back() * 2, fastest * 1.5),
        .fastest = levels.back(),
        .curves = levels.size() > 1,
        .model = {}};
    for (const CurveGroup& one : figure.series) {
        const ConditionPath path = one.path(c.readings, along_inertial_number);
        std::vector<double> x;
        std::vector<Condition> conditions;
        // The curve ends at the largest simulated inertial number and is extrapolated to lower
        // ones.
        for (Eigen::Index k = 0; k <= curve_steps; ++k) {
            x.push_back(figure.low *
                        std::pow(figure.fastest / figure.low, k / double{curve_steps}));
            conditions.push_back(path.at(x.back()));
        }
        figure.model.emplace_back(x, study.model.model().predict(c.fit.parameters, conditions),
                                  conditions);
    }
    return figure;
}

/// Draws the mean of the quasi-static readings (I = 0) and the mean of the model's predictions for
/// these readings, as horizontal lines.
void draw_limit(Panel& panel, const std::vector<std::size_t>& quasi_static, const Calibration& c,
                std::size_t o) {
    if (quasi_static.empty()) return;
    const auto [measured, model] = means_of(quasi_static, c, stack(c.readings).covariance);
    panel.references.push_back({"measured, I → 0, ± 1 standard error", measured.value[o],
                                measured.error[o], false, measured_colour});
    panel.references.push_back(
        {"model, I → 0, ± 1 standard error", model.value[o], model.error[o], false, model_colour});
}

/// Draws the readings of series `s` with its model curve, or the prediction of each reading where a
/// curve does not represent them.
void draw_series(Panel& panel, const InertialFigure& figure, std::size_t s, std::size_t o) {
    const CurveGroup& one = figure.series[s];
    const DryStudy& study = figure.study;
    const bool curve = figure.curves && one.curve;
    const SeriesLook look = figure.parted() ? look_of_series(s, figure.series.size())
                                            : SeriesLook{.colour = model_colour};
    Curve measured = measured_points(figure.of("measured", one), look);
    Curve model = model_points(figure.of(model_at_readings_text, one), look);
    Curve line = model_line(figure.of("model", one), look);
    if (figure.parted()) {
        measured.in_key = model.in_key = line.in_key = false;
    } else {
        measured.label = measured_text;
        measured.colour = measured_colour;
        line.label = model_text;
    }
    std::vector<std::size_t> quasi_static;
    for (const std::size_t k : one.members) {
        const double number = study.condition(k).inertial_number;
        if (number <= 0 && !figure.parted()) {
            quasi_static.push_back(k);
            continue;
        }
        // A logarithmic axis has no zero: the quasi-static limit is drawn near the left edge.
        const double x = number > 0 ? number : figure.place_of_limit();
        add_point(measured, x, study.measured(k), o);
        add_point(model, x, study.predicted(k), o);
    }
    draw_limit(panel, quasi_static, study.calibration, o);
    const std::string band = figure.parted() ? line.label + ", ± 1 standard error" : line.label;
    if (curve) figure.model[s].draw_in(panel, o, line, band);
    if (!measured.x.empty()) panel.curves.push_back(measured);
    model.drawn = !curve;
    if (!model.x.empty()) panel.curves.push_back(model);
}

/// Adds the key for several series: the look of each series, then of each kind of data.
void explain_series(Panel& panel, const InertialFigure& figure) {
    std::vector<std::string> names;
    for (const CurveGroup& one : figure.series)
        names.push_back(one.name);
    std::ranges::move(series_entries(names), std::back_inserter(panel.curves));
    panel.curves.push_back(kind_entry(measured_text, Curve::Style::points));
    const auto drawn = [&](const CurveGroup& one) { return figure.curves && one.curve; };
    if (std::ranges::any_of(figure.series, drawn))
        panel.curves.push_back(kind_entry(model_text, Curve::Style::line));
    if (!std::ranges::all_of(figure.series, drawn))
        panel.curves.push_back(
            kind_entry(model_at_readings_text, Curve::Style::points, Filling::hollow));
}

bool has_limit(const DryStudy& study) {
    return std::ranges::any_of(
        study.readings, [&](std::size_t k) { return study.condition(k).inertial_number <= 0; });
}

Figure inertial_figure(const DryStudy& study) {
    const InertialFigure plan = inertial_figure_of(study);
    std::vector<const Effect*> effects = study.effects(true);
    std::ranges::copy(study.effects(false), std::back_inserter(effects));
    Figure figure{.name = "inertial_number",
                  .title = fmt::format("Dry readings against the inertial number, friction μ = "
                                       "{:.3f}{}",
                                       study.friction(),
                                       effects.empty() ? "" : ", with " + names_of(effects)),
                  .panels = {},
                  .stacked = true};
    for (std::size_t o = 0; o < 2; ++o) {
        Panel panel{.x_label = inertial_label,
                    .y_label = o == 0 ? stress_ratio_label : solid_fraction_label,
                    .log_x = true};
        if (plan.parted() && has_limit(study)) panel.x_label += "; left edge: I → 0";
        for (std::size_t s = 0; s < plan.series.size(); ++s) {
            draw_series(panel, plan, s, o);
        }
        panel.x_range = {plan.low, plan.high};
        if (o == 0 && plan.parted()) explain_series(panel, plan);
        panel.key = o == 0;
        figure.panels.push_back(panel);
    }
    return figure;
}

}  // namespace

std::vector<Figure> dry_figures(const StudyModel& model, const Calibration& calibration) {
    DryStudy study{model, calibration, {}};
    for (std::size_t k = 0; k < calibration.readings.size(); ++k) {
        if (calibration.readings[k].condition.dry()) study.readings.push_back(k);
    }
    if (study.readings.empty()) return {};
    return {calibration_figure(study), inertial_figure(study)};
}

}  // namespace pendular
