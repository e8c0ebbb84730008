#include "reports/wet_figures.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "calib/structural_cohesion.h"
#include "calib/wet_groups.h"
#include "reports/shown.h"
#include "reports/symbol_code.h"

namespace pendular {
namespace {

const std::string inverse_pressure_label = "inverse reduced pressure 1/P* = F_0/(a^2σ_{22})";
const std::string liquid_content_label = "liquid content Φ_L/Φ_S";
const std::string kind_colour = "#606060";  ///< of looks that the key explains for all contents

/// What all wet figures are made from.
struct WetStudy {
    const FlowModel& model;
    const Calibration& calibration;
    std::vector<WetGroup> groups;     ///< those of the lowest inertial number
    std::vector<CohesionLine> lines;  ///< likewise
    double limit;                     ///< P* from which on they are fitted

    double friction() const { return calibration.fit.parameters(0); }
    double inertial_number() const { return groups.front().inertial_number; }
    double inverse_pressure(const Condition& condition) const {
        return 1 /
               reduced_pressure(condition.normal_stress, calibration.grains, *calibration.liquid);
    }
    double normal_stress(double inverse_pressure) const {
        return 1 /
               (inverse_pressure * reduced_pressure(1, calibration.grains, *calibration.liquid));
    }
    double largest_inverse_pressure(const WetGroup& group) const {
        double largest = 0;
        for (const std::size_t k : group.members) {
            largest = std::max(largest, inverse_pressure(calibration.readings[k].condition));
        }
        return largest;
    }
};

/// Those of a list whose inertial number is the lowest of all, within the width of a group.
template <class Grouped>
std::vector<Grouped> slowest(const std::vector<Grouped>& all, double least) {
    std::vector<Grouped> result;
    std::ranges::copy_if(all, std::back_inserter(result), [&](const Grouped& one) {
        return agree(one.inertial_number, least, inertial_number_tolerance);
    });
    return result;
}

WetStudy wet_study(const FlowModel& model, const Calibration& c, const CohesionOptions& cohesion) {
    const auto groups = wet_groups(c.readings);
    const double least = std::ranges::min(groups, {}, &WetGroup::inertial_number).inertial_number;
    return {.model = model,
            .calibration = c,
            .groups = slowest(groups, least),
            .lines = slowest(c.cohesion_lines, least),
            .limit = cohesion.lowest_reduced_pressure};
}

std::string content_text(double liquid_content) {
    return fmt::format("Φ_L/Φ_S = {:.3g}", liquid_content);
}

std::string title(const std::string& what, const WetStudy& study) {
    return fmt::format("{}, {}, friction μ = {:.3f}", what, inertial_text(study.inertial_number()),
                       study.friction());
}

std::string measured_line_text(const WetStudy& study) {
    return fmt::format("measured, line for P* ≥ {:.2g}", study.limit);
}

std::string colour_of(double liquid_content) {
    return std::string(code_of(liquid_content).colour);
}

/// An empty set of points of one liquid content.
Curve points_of(const std::string& kind, double liquid_content, const Symbol& symbol) {
    return {.label = fmt::format("{}, {}", kind, content_text(liquid_content)),
            .colour = colour_of(liquid_content),
            .symbol = symbol,
            .in_key = false};
}

void add_point(Curve& curve, double x, const Shown& shown, std::size_t o) {
    curve.x.push_back(x);
    curve.y.push_back(shown.value[o]);
    curve.y_error.push_back(shown.error[o]);
}

/// What the model says of a place in a prediction.
Shown shown(const Prediction& predicted, Eigen::Index place, double normal_stress) {
    const auto error = [&](Eigen::Index k) { return std::sqrt(predicted.covariance(k, k)); };
    return {{predicted.value(2 * place) / normal_stress, predicted.value(2 * place + 1)},
            {error(2 * place) / normal_stress, error(2 * place + 1)}};
}

/// The model from nearly dry to the strongest cohesion that was measured.
void draw_model(Panel& panel, const WetStudy& study, const WetGroup& group, std::size_t o) {
    constexpr int steps = 60;
    const double end = study.largest_inverse_pressure(group);
    std::vector<Condition> conditions;
    Curve line = points_of("model", group.liquid_content, {});
    for (int k = 1; k <= steps; ++k) {
        line.x.push_back(end * k / steps);
        conditions.push_back({.normal_stress = study.normal_stress(line.x.back()),
                              .inertial_number = group.inertial_number,
                              .liquid_content = group.liquid_content});
    }
    const Prediction predicted = predict_unseen(study.model, study.calibration, conditions);
    Curve band = line;
    for (std::size_t k = 0; k < conditions.size(); ++k) {
        const Shown one =
            shown(predicted, static_cast<Eigen::Index>(k), conditions[k].normal_stress);
        line.y.push_back(one.value[o]);
        band.y_error.push_back(one.error[o]);
    }
    line.style = Curve::Style::line;
    band.style = Curve::Style::band;
    band.y = line.y;
    panel.curves.push_back(band);
    panel.curves.push_back(line);
}

void draw_points(Panel& panel, const WetStudy& study, const WetGroup& group, std::size_t o) {
    const Calibration& c = study.calibration;
    Curve simulated = points_of("simulated", group.liquid_content,
                                simulated_symbol(study.friction(), group.liquid_content));
    Curve measured = points_of("measured", group.liquid_content, measured_symbol);
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

/// Dry readings of the same inertial number and the model of them, where 1/P* = 0.
void draw_dry(Panel& panel, const WetStudy& study, std::size_t o) {
    std::vector<Reading> dry;
    std::ranges::copy_if(
        study.calibration.readings, std::back_inserter(dry), [&](const Reading& r) {
            return r.condition.dry() && agree(r.condition.inertial_number, study.inertial_number(),
                                              inertial_number_tolerance);
        });
    if (dry.empty()) {
        return;
    }
    const Condition& condition = dry.front().condition;
    const Prediction predicted =
        study.model.predict_conditions(study.calibration.fit.parameters, {condition});
    Curve simulated{.label = "simulated, dry",
                    .colour = colour_of(0),
                    .symbol = simulated_symbol(study.friction(), 0),
                    .in_key = false};
    Curve measured = simulated;
    measured.label = "measured, dry";
    measured.symbol = measured_symbol;
    add_point(simulated, 0, shown(predicted, 0, condition.normal_stress), o);
    add_point(measured, 0, mean_of(dry), o);
    panel.curves.push_back(measured);
    panel.curves.push_back(simulated);
}

void draw_lines(Panel& panel, const std::vector<CohesionLine>& lines, double end) {
    for (const CohesionLine& line : lines) {
        Curve curve = points_of("cohesion line, " + line.source, line.liquid_content, {});
        curve.style =
            line.source == "measured" ? Curve::Style::dotted_line : Curve::Style::dashed_line;
        curve.x = {0, end};
        curve.y = {line.stress_ratio_intercept.value, stress_ratio(line, 1 / end)};
        panel.curves.push_back(curve);
    }
}

/// What a look means for all liquid contents, in the key alone.
Curve kind(const std::string& label, Curve::Style style, const Symbol& symbol = {}) {
    return {.label = label, .style = style, .colour = kind_colour, .symbol = symbol};
}

/// The key: the code of each content, then what the kinds of data look like.
void explain(Panel& panel, const WetStudy& study, bool with_dry, bool with_lines) {
    using Style = Curve::Style;
    const auto code = [&](double content, const std::string& label) {
        Curve curve = points_of("", content, simulated_symbol(study.friction(), content));
        curve.label = label;
        curve.in_key = true;
        panel.curves.push_back(curve);
    };
    for (const WetGroup& group : study.groups) {
        code(group.liquid_content, content_text(group.liquid_content));
    }
    if (with_dry) {
        code(0, "dry");
    }
    panel.curves.push_back(kind("measured", Style::points, measured_symbol));
    panel.curves.push_back(
        kind("simulated", Style::points, {shape_of(study.friction()), Filling::hollow}));
    panel.curves.push_back(kind("model", Style::line));
    panel.curves.push_back(kind("± 1 standard error", Style::band));
    if (with_lines) {
        panel.curves.push_back(kind(measured_line_text(study), Style::dotted_line));
        panel.curves.push_back(kind("simulated, likewise", Style::dashed_line));
    }
    panel.key = Key::outside;
}

/// Stress ratio (o = 0) or solid fraction (o = 1) against 1/P*.
Panel pressure_panel(const WetStudy& study, std::size_t o) {
    Panel panel{.x_label = inverse_pressure_label,
                .y_label = o == 0 ? stress_ratio_label : solid_fraction_label};
    double end = 0;
    for (const WetGroup& group : study.groups) {
        end = std::max(end, 1.06 * study.largest_inverse_pressure(group));
        draw_model(panel, study, group, o);
    }
    panel.x_range = {0, end};
    if (o == 0) {
        draw_lines(panel, study.lines, end);
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
            .title = title("Strength of wet beads", study),
            .panels = {panel}};
}

Figure solid_fraction_figure(const WetStudy& study) {
    return {.name = "solid_fraction_wet",
            .title = title("Solid fraction of wet beads", study),
            .panels = {pressure_panel(study, 1)}};
}

/// Cohesions of lines, each point in the look of its content.
void draw_cohesions(Panel& panel, const WetStudy& study) {
    for (const CohesionLine& line : study.lines) {
        const double content = line.liquid_content;
        Curve curve =
            points_of(line.source, content,
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
                .y_label = "reduced cohesion c* = a^2c/F_0",
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
    panel.curves.push_back(kind("simulated, likewise", Curve::Style::points,
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
    const WetStudy study = wet_study(model.model(), calibration, cohesion);
    std::vector<Figure> figures{stress_ratio_figure(study), solid_fraction_figure(study)};
    const auto structural = slowest(structural_cohesions(model.simulation(), calibration, cohesion),
                                    study.inertial_number());
    if (!study.lines.empty() || !structural.empty()) {
        figures.push_back(cohesion_figure(study, structural));
    }
    return figures;
}

}  // namespace pendular
