#include "reports/misfit_figures.h"

#include <fmt/format.h>

#include <algorithm>

#include "calib/fit/calibrate_study.h"
#include "calib/fit/predicted_readings.h"
#include "calib/fit/reading_order.h"
#include "calib/fit/structural_cohesion.h"
#include "reports/figure_style.h"
#include "reports/model_curve.h"
#include "reports/symbol.h"

namespace pendular {
namespace {

const std::string liquid_content_label = "liquid content Φ_L/Φ_S";

/// Data of the wet figures: all readings at one inertial number, so that each is drawn once and one
/// curve of the model passes each liquid content.
struct WetStudy {
    const StudyModel& study_model;
    const Predictor& model;
    const Calibration& fitted;     ///< calibration with the readings as they were measured
    double inertial_number;        ///< of the steady readings [1]
    bool moved;                    ///< whether readings were measured at other inertial numbers
    LineValues measured;           ///< values of the readings at `inertial_number`
    Calibration calibration;       ///< with readings and predictions at `inertial_number`
    std::vector<WetGroup> groups;  ///< wet readings by content
    const std::vector<CohesionLine>& lines;
    double limit;  ///< lowest P* of the points that the lines are fitted to [1]

    double friction() const { return calibration.fit.parameters(0); }
    double inverse_pressure(const Condition& condition) const {
        return 1 /
               reduced_pressure(condition.normal_stress, calibration.grains, *calibration.liquid);
    }
    double normal_stress(double inverse_pressure) const {
        return 1 /
               (inverse_pressure * reduced_pressure(1, calibration.grains, *calibration.liquid));
    }
    double largest_inverse_pressure(const std::vector<std::size_t>& members) const {
        double largest = 0;
        for (const std::size_t k : members) {
            largest = std::max(largest, inverse_pressure(calibration.readings[k].condition));
        }
        return largest;
    }
    /// Whether the model is the simulation alone, without effects or closures, so that figures call
    /// it "simulated".
    bool simulated() const {
        return study_model.effects().empty() && calibration.model.base == "dem";
    }
    std::string model_word() const { return simulated() ? "simulated" : "model"; }
    std::string at_readings() const { return simulated() ? "simulated" : "model at the readings"; }
    /// Pull-off force F0 [µN] of the study's liquid, which the axes use.
    double force() const { return 1e6 * pull_off_force(calibration.grains, *calibration.liquid); }
    /// Pull-off force F0 [µN] of the liquid as changed by effects.
    double fitted_force() const {
        const Condition& wet = calibration.readings[groups.front().members.front()].condition;
        const auto liquid = study_model.imposed(calibration.fit.parameters, {wet}).front().liquid;
        return liquid ? 1e6 * pull_off_force(calibration.grains, *liquid) : force();
    }
};

/// The calibration with the readings and predictions of `at`. Only drawing uses it: what is fitted
/// to the readings, such as an unseen prediction, needs them as they were measured.
Calibration with_readings(Calibration c, ReadingsAtOneRate at) {
    c.readings = std::move(at.readings);
    c.prediction = std::move(at.predicted);
    return c;
}

WetStudy wet_study(const StudyModel& model, const Calibration& c, const CohesionOptions& cohesion) {
    ReadingsAtOneRate at = at_one_inertial_number(model.model(), c);
    const double inertial_number = at.inertial_number;
    bool moved = false;
    for (std::size_t k = 0; k < c.readings.size(); ++k)
        moved = moved ||
                at.readings[k].condition.inertial_number != c.readings[k].condition.inertial_number;
    LineValues measured = at.measured;
    Calibration drawn = with_readings(c, std::move(at));
    std::vector<WetGroup> groups = wet_groups(drawn.readings);
    return {.study_model = model,
            .model = model.model(),
            .fitted = c,
            .inertial_number = inertial_number,
            .moved = moved,
            .measured = std::move(measured),
            .calibration = std::move(drawn),
            .groups = std::move(groups),
            .lines = c.cohesion_lines,
            .limit = cohesion.lowest_reduced_pressure};
}

std::string content_text(double liquid_content) {
    return fmt::format("Φ_L/Φ_S = {:.3g}", liquid_content);
}

/// Text of the study's pull-off force: "F_0 = 32.4 µN", or "F_0 = 32.4 µN as stated" where the
/// fitted liquid has another.
std::string force_text(const WetStudy& study) {
    const bool fitted = !agree(study.force(), study.fitted_force(), 1e-6);
    return fmt::format("F_0 = {:.3g} µN{}", study.force(), fitted ? " as stated" : "");
}

std::string title(const std::string& what, const WetStudy& study) {
    std::string text = fmt::format("{}, {}{}, friction μ = {:.3f}", what,
                                   study.moved ? "readings brought to " : "",
                                   inertial_text(study.inertial_number), study.friction());
    std::vector<const Effect*> of_grains = study.study_model.effects(), of_instrument;
    std::erase_if(of_grains, [&](const Effect* effect) {
        if (effect->of_instrument()) of_instrument.push_back(effect);
        return effect->of_instrument();
    });
    if (!of_grains.empty()) text += ", with " + names_of(of_grains);
    if (!of_instrument.empty()) text += ", corrected for " + names_of(of_instrument);
    if (!agree(study.force(), study.fitted_force(), 1e-6)) {
        text += fmt::format(" (F_0 = {:.3g} µN)", study.fitted_force());
    }
    return text;
}

std::string measured_line_text(const WetStudy& study) {
    return fmt::format("measured, line for P* ≥ {:.2g}", study.limit);
}

std::string colour_of(double liquid_content) {
    return std::string(code_of(liquid_content).colour);
}

/// Curve without points yet, in the colour of one liquid content.
Curve points_of(const std::string& kind, double liquid_content, const Symbol& symbol) {
    return {.label = fmt::format("{}, {}", kind, content_text(liquid_content)),
            .colour = colour_of(liquid_content),
            .symbol = symbol,
            .in_key = false};
}

/// Beginning of the labels of a group's curves.
std::string kind_of(const WetGroup& group) {
    return group.at_failure ? "points of failure, " : "";
}

/// Curve of the model for a group of readings, from nearly dry to the largest 1/P* of the group.
ModelCurve model_of(const WetStudy& study, const CurveGroup& series) {
    constexpr int steps = 60;  // straight pieces too short to be seen
    const double end = study.largest_inverse_pressure(series.members);
    const ConditionPath path = series.path(study.calibration.readings, along_inverse_normal_stress);
    std::vector<double> x;
    std::vector<Condition> conditions;
    for (int k = 1; k <= steps; ++k) {
        x.push_back(end * k / steps);
        conditions.push_back(path.at(1 / study.normal_stress(x.back())));
    }
    return {x, predict_unseen(study.model, study.fitted, conditions), conditions};
}

/// Draws the model curves of one liquid content, several where the predictions differ between
/// masses of beads or files. A curve that does not represent the predictions of its readings is
/// left out.
void draw_model(Panel& panel, const WetStudy& study, const WetGroup& group, std::size_t o) {
    for (const CurveGroup& series :
         curve_groups(group.members, study.model, study.calibration, along_inverse_normal_stress,
                      {Apart::bead_volume, Apart::file})) {
        if (!series.curve) continue;
        Curve look = points_of(kind_of(group) + "model", group.liquid_content, {});
        if (!series.name.empty()) look.label += ", " + series.name;
        model_of(study, series).draw_in(panel, o, look, look.label);
    }
}

void draw_points(Panel& panel, const WetStudy& study, const WetGroup& group, std::size_t o) {
    const Calibration& c = study.calibration;
    Curve simulated = points_of(kind_of(group) + study.at_readings(), group.liquid_content,
                                simulated_symbol(study.friction(), group.liquid_content));
    Curve measured = points_of(kind_of(group) + "measured", group.liquid_content, measured_symbol);
    for (const std::size_t k : group.members) {
        const Condition& condition = c.readings[k].condition;
        const double x = study.inverse_pressure(condition);
        add_point(simulated, x,
                  shown(c.prediction, static_cast<Eigen::Index>(k), condition.normal_stress), o);
        add_point(measured, x, shown(c.readings[k]), o);
    }
    panel.curves.push_back(measured);
    panel.curves.push_back(simulated);
}

/// Draws the dry readings and their predictions at 1/P* = 0: as one mean point, or one by one where
/// the model predicts different values for them.
void draw_dry(Panel& panel, const WetStudy& study, std::size_t o) {
    const Calibration& c = study.calibration;
    std::vector<std::size_t> dry;
    for (std::size_t k = 0; k < c.readings.size(); ++k) {
        const Condition& condition = c.readings[k].condition;
        if (condition.dry() && !condition.at_failure) dry.push_back(k);
    }
    if (dry.empty()) {
        return;
    }
    Curve simulated{.label = study.at_readings() + ", dry",
                    .colour = colour_of(0),
                    .symbol = simulated_symbol(study.friction(), 0),
                    .in_key = false};
    Curve measured = simulated;
    measured.label = "measured, dry";
    measured.symbol = measured_symbol;
    const auto add = [&](const std::vector<std::size_t>& places) {
        const MeasuredAndModel means = means_of(places, c, study.measured.covariance);
        add_point(simulated, 0, means.model, o);
        add_point(measured, 0, means.measured, o);
    };
    if (mean_suffices(dry, c)) {
        add(dry);
    } else {
        for (const std::size_t k : dry)
            add({k});
    }
    panel.curves.push_back(measured);
    panel.curves.push_back(simulated);
}

/// Source of a cohesion line in a figure: "measured", or "simulated" or "model".
std::string source_of(const CohesionLine& line, const WetStudy& study) {
    return line.source == "measured" ? line.source : study.model_word();
}

void draw_lines(Panel& panel, const WetStudy& study, double end) {
    for (const CohesionLine& line : study.lines) {
        Curve curve =
            points_of("cohesion line, " + source_of(line, study), line.liquid_content, {});
        curve.style =
            line.source == "measured" ? Curve::Style::dotted_line : Curve::Style::dashed_line;
        curve.x = {0, end};
        curve.y = {line.stress_ratio_intercept.value, stress_ratio(line, 1 / end)};
        panel.curves.push_back(curve);
    }
}

/// Entry of a key that explains a line style or symbol for all liquid contents.
Curve kind(const std::string& label, Curve::Style style, const Symbol& symbol = {}) {
    return {.label = label, .style = style, .colour = explaining_colour, .symbol = symbol};
}

/// Adds the key: the symbol of each liquid content, then the style of each kind of data.
void explain(Panel& panel, const WetStudy& study, bool with_dry, bool with_lines) {
    using Style = Curve::Style;
    const auto code = [&](double content, const std::string& label) {
        Curve curve = points_of("", content, simulated_symbol(study.friction(), content));
        curve.label = label;
        curve.in_key = true;
        panel.curves.push_back(curve);
    };
    std::string last;
    for (const WetGroup& group : study.groups) {
        const std::string text = content_text(group.liquid_content);
        if (std::exchange(last, text) != text) code(group.liquid_content, text);
    }
    if (with_dry) {
        code(0, "dry");
    }
    panel.curves.push_back(kind("measured", Style::points, measured_symbol));
    panel.curves.push_back(
        kind(study.at_readings(), Style::points, {shape_of(study.friction()), Filling::hollow}));
    panel.curves.push_back(kind("model", Style::line));
    panel.curves.push_back(kind("± 1 standard error", Style::band));
    if (with_lines) {
        panel.curves.push_back(kind(measured_line_text(study), Style::dotted_line));
        panel.curves.push_back(kind(study.model_word() + ", likewise", Style::dashed_line));
    }
    panel.key = Key::outside;
}

/// Panel of the stress ratio (o = 0) or the solid fraction (o = 1) against 1/P*.
Panel pressure_panel(const WetStudy& study, std::size_t o) {
    Panel panel{.x_label = fmt::format("inverse reduced pressure 1/P* = F_0/(a^2σ_{{22}}), {}",
                                       force_text(study)),
                .y_label = o == 0 ? stress_ratio_label : solid_fraction_label};
    double end = 0;
    for (const WetGroup& group : study.groups) {
        end = std::max(end, 1.06 * study.largest_inverse_pressure(group.members));
        draw_model(panel, study, group, o);
    }
    panel.x_range = {0, end};
    if (o == 0) {
        draw_lines(panel, study, end);
    }
    const std::size_t before = panel.curves.size();
    draw_dry(panel, study, o);
    const bool with_dry = panel.curves.size() > before;
    for (const WetGroup& group : study.groups) {
        draw_points(panel, study, group, o);
    }
    explain(panel, study, with_dry, o == 0 && !study.lines.empty());
    return panel;
}

Figure stress_ratio_figure(const WetStudy& study) {
    Panel panel = pressure_panel(study, 0);
    if (1 / study.limit < panel.x_range->second) {
        panel.references.push_back({.label = fmt::format("P* = {:.2g}", study.limit),
                                    .value = 1 / study.limit,
                                    .vertical = true});
    }
    return {.name = "stress_ratio_wet",
            .title = title("Strength of wet grains", study),
            .panels = {panel}};
}

Figure solid_fraction_figure(const WetStudy& study) {
    return {.name = "solid_fraction_wet",
            .title = title("Solid fraction of wet grains", study),
            .panels = {pressure_panel(study, 1)}};
}

/// Draws the reduced cohesion of each cohesion line, in the symbol of its liquid content.
void draw_cohesions(Panel& panel, const WetStudy& study) {
    for (const CohesionLine& line : study.lines) {
        const double content = line.liquid_content;
        Curve curve =
            points_of(source_of(line, study), content,
                      line.source == "measured" ? measured_symbol
                                                : simulated_symbol(study.friction(), content));
        curve.x = {content};
        curve.y = {line.reduced_cohesion.value};
        curve.y_error = {line.reduced_cohesion.standard_error};
        panel.curves.push_back(curve);
    }
}

Figure cohesion_figure(const WetStudy& study, const std::vector<StructuralCohesion>& structural) {
    Panel panel{.x_label = liquid_content_label,
                .y_label = "reduced cohesion c* = a^2c/F_0, " + force_text(study),
                .log_x = true,
                .key = Key::top_left,
                .headroom = 0.32};
    Curve rumpf{.label = "μ*_0Φ_SZ*/π (Rumpf)",
                .colour = "#b9770e",
                .symbol = {Shape::diamond, Filling::hollow}},
        generalised{.label = "μ*_0Φ_SZ*/π − a^2σ^{cap}_{12}/F_0",
                    .colour = "#b9770e",
                    .symbol = {Shape::star, Filling::hollow}};
    for (const auto& one : structural) {
        for (auto* curve : {&rumpf, &generalised}) {
            const Estimate& estimate = curve == &rumpf ? one.rumpf : one.generalised;
            curve->x.push_back(one.liquid_content);
            curve->y.push_back(estimate.value);
            curve->y_error.push_back(estimate.standard_error);
        }
    }
    panel.curves.push_back(kind(measured_line_text(study), Curve::Style::points, measured_symbol));
    panel.curves.push_back(kind(study.model_word() + ", likewise", Curve::Style::points,
                                {shape_of(study.friction()), Filling::hollow}));
    panel.curves.push_back(rumpf);
    panel.curves.push_back(generalised);
    draw_cohesions(panel, study);
    return {
        .name = "reduced_cohesion", .title = title("Reduced cohesion", study), .panels = {panel}};
}

}  // namespace

std::vector<Figure> wet_figures(const StudyModel& model, const Calibration& calibration,
                                const CohesionOptions& cohesion) {
    if (wet_groups(calibration.readings).empty()) {
        return {};
    }
    const WetStudy study = wet_study(model, calibration, cohesion);
    std::vector<Figure> figures{stress_ratio_figure(study), solid_fraction_figure(study)};
    const auto structural = structural_cohesions(model, study.calibration, cohesion);
    if (!study.lines.empty() || !structural.empty()) {
        figures.push_back(cohesion_figure(study, structural));
    }
    return figures;
}

}  // namespace pendular
