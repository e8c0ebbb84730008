#include "reports/misfit_figures.h"

#include <fmt/format.h>

#include <algorithm>
#include <iterator>

#include "calib/fit/calibrate_study.h"
#include "calib/fit/cohesion_lines.h"
#include "calib/fit/predicted_readings.h"
#include "calib/fit/structural_cohesion.h"
#include "reports/figure_style.h"
#include "reports/model_curve.h"

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
    std::string at_readings() const { return simulated() ? "simulated" : model_at_readings_text; }
    /// Distinct liquid contents, from the smallest.
    std::vector<double> contents() const {
        std::vector<double> all;
        for (const WetGroup& group : groups) {
            if (std::ranges::find(all, group.liquid_content) == all.end())
                all.push_back(group.liquid_content);
        }
        std::ranges::sort(all);
        return all;
    }
    /// Look of the readings with a liquid content, and of their model.
    SeriesLook look(double liquid_content) const {
        const std::vector<double> all = contents();
        const auto place = std::ranges::lower_bound(all, liquid_content) - all.begin();
        return look_of_series(static_cast<std::size_t>(place), all.size());
    }
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
    return fmt::format("cohesion line through readings at P* ≥ {:.2g}", study.limit);
}

std::string label_of(const std::string& kind, double liquid_content) {
    return fmt::format("{}, {}", kind, content_text(liquid_content));
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

/// Series of a group of readings, each with a curve of its own.
std::vector<CurveGroup> wet_series(const WetStudy& study, const WetGroup& group) {
    return curve_groups(group.members, study.model, study.calibration, along_inverse_normal_stress,
                        {Apart::bead_volume, Apart::file});
}

/// Draws the model curves of one liquid content, several where the predictions differ between
/// masses of beads or files. A curve that does not represent the predictions of its readings is
/// left out.
void draw_model(Panel& panel, const WetStudy& study, const WetGroup& group, std::size_t o) {
    for (const CurveGroup& series : wet_series(study, group)) {
        if (!series.curve) continue;
        Curve look = model_line(label_of(kind_of(group) + "model", group.liquid_content),
                                study.look(group.liquid_content));
        look.in_key = false;
        if (!series.name.empty()) look.label += ", " + series.name;
        model_of(study, series).draw_in(panel, o, look, look.label);
    }
}

/// Draws the readings, and the predictions of those that no curve of the model represents.
void draw_points(Panel& panel, const WetStudy& study, const WetGroup& group, std::size_t o) {
    const Calibration& c = study.calibration;
    const SeriesLook look = study.look(group.liquid_content);
    Curve measured =
        measured_points(label_of(kind_of(group) + "measured", group.liquid_content), look);
    Curve predicted =
        model_points(label_of(kind_of(group) + study.at_readings(), group.liquid_content), look);
    measured.in_key = predicted.in_key = false;
    const std::vector<CurveGroup> all = wet_series(study, group);
    predicted.drawn = !std::ranges::all_of(all, &CurveGroup::curve);
    for (const std::size_t k : group.members) {
        const Condition& condition = c.readings[k].condition;
        const double x = study.inverse_pressure(condition);
        add_point(measured, x, shown(c.readings[k]), o);
        add_point(predicted, x,
                  shown(c.prediction, static_cast<Eigen::Index>(k), condition.normal_stress), o);
    }
    panel.curves.push_back(predicted);
    panel.curves.push_back(measured);
}

bool has_style(const Panel& panel, Curve::Style style) {
    return std::ranges::any_of(
        panel.curves, [&](const Curve& curve) { return curve.style == style && !curve.x.empty(); });
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
    Curve simulated = model_points(study.at_readings() + ", dry", dry_look),
          measured = measured_points("measured, dry", dry_look);
    simulated.in_key = measured.in_key = false;
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
    // Where the curves of the model begin at this point, it would only hide the measured one.
    simulated.drawn = !mean_suffices(dry, c) || !has_style(panel, Curve::Style::line);
    panel.curves.push_back(simulated);
    panel.curves.push_back(measured);
}

/// Draws the cohesion lines through the readings. Those through the model would lie on its curves,
/// and only the CSV file has them; the figure of the reduced cohesion compares both.
void draw_lines(Panel& panel, const WetStudy& study, double end) {
    for (const CohesionLine& line : study.lines) {
        const bool measured = line.source == "measured";
        const std::string source = measured ? line.source : study.model_word();
        Curve curve{.label = label_of("cohesion line, " + source, line.liquid_content),
                    .style = Curve::Style::dotted_line,
                    .colour = study.look(line.liquid_content).colour,
                    .weight = 0.8,
                    .drawn = measured,
                    .in_key = false};
        curve.x = {0, end};
        curve.y = {line.stress_ratio_intercept.value, stress_ratio(line, 1 / end)};
        panel.curves.push_back(curve);
    }
}

/// Adds the key: the look of each liquid content, then of each kind of data.
void explain(Panel& panel, const WetStudy& study, bool with_dry) {
    using Style = Curve::Style;
    const bool lines = has_style(panel, Style::line), fitted = has_style(panel, Style::dotted_line),
               predicted = std::ranges::any_of(panel.curves, [](const Curve&curve) {
                   return curve.drawn && curve.symbol.filling == Filling::hollow &&
                          !curve.x.empty();
               });
    std::vector<std::string> names;
    for (const double content : study.contents())
        names.push_back(content_text(content));
    std::ranges::move(series_entries(names), std::back_inserter(panel.curves));
    if (with_dry) panel.curves.push_back(measured_points("dry", dry_look));
    const std::size_t others = with_dry + lines + predicted + fitted + 1;
    constexpr std::size_t most_entries = 8;
    const bool together = predicted && names.size() + others > most_entries;
    panel.curves.push_back(
        kind_entry(together ? fmt::format("{} (hollow: {})", measured_text, study.at_readings())
                            : measured_text,
                   Style::points));
    if (lines)
        panel.curves.push_back(
            kind_entry(study.model_word() + ", ± 1 standard error", Style::line));
    if (predicted && !together)
        panel.curves.push_back(kind_entry(study.at_readings(), Style::points, Filling::hollow));
    if (fitted) panel.curves.push_back(kind_entry(measured_line_text(study), Style::dotted_line));
    panel.key = true;
}

/// Panel of the stress ratio (o = 0) or the solid fraction (o = 1) against 1/P*.
Panel pressure_panel(const WetStudy& study, std::size_t o) {
    Panel panel{.x_label = fmt::format("inverse reduced pressure 1/P*, {}", force_text(study)),
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
    // A symbol at 0 keeps clear of the numbers beside the axis.
    if (with_dry) panel.x_range->first = -0.03 * end;
    for (const WetGroup& group : study.groups) {
        draw_points(panel, study, group, o);
    }
    explain(panel, study, with_dry);
    return panel;
}

Figure stress_ratio_figure(const WetStudy& study) {
    Panel panel = pressure_panel(study, 0);
    if (1 / study.limit < panel.x_range->second) {
        panel.references.push_back({.label = "",  // the entry of the cohesion lines states it
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

/// Draws the reduced cohesion of each cohesion line.
void draw_cohesions(Panel& panel, const WetStudy& study) {
    Curve measured = measured_points(measured_line_text(study) + ", ± 1 standard error",
                                     {.colour = measured_colour}),
          model = model_points("cohesion line through the " +
                                   (study.simulated() ? std::string("simulations") : "model"),
                               {.colour = model_colour, .shape = Shape::square});
    for (const CohesionLine& line : study.lines) {
        Curve& curve = line.source == "measured" ? measured : model;
        curve.x.push_back(line.liquid_content);
        curve.y.push_back(line.reduced_cohesion.value);
        curve.y_error.push_back(line.reduced_cohesion.standard_error);
    }
    for (Curve* const curve : {&measured, &model})
        if (!curve->x.empty()) panel.curves.push_back(*curve);
}

Figure cohesion_figure(const WetStudy& study, const std::vector<StructuralCohesion>& structural) {
    Panel panel{.x_label = liquid_content_label,
                .y_label = "reduced cohesion c*, " + force_text(study),
                .log_x = true,
                .key = true};
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
    draw_cohesions(panel, study);
    for (const Curve* const curve : {&rumpf, &generalised})
        if (!curve->x.empty()) panel.curves.push_back(*curve);
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
