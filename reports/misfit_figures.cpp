#include "reports/misfit_figures.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <functional>
#include <iterator>
#include <limits>
#include <set>
#include <string>

#include "analysis/misfit/checks.h"
#include "data/quantities/number.h"
#include "data/quantities/statistics.h"
#include "reports/figure.h"
#include "reports/figure_style.h"

namespace pendular {
namespace {

/// Expected quantile of the value of rank k (from 0) of n ordered normal values [1].
/// Source: Blom, Statistical Estimates and Transformed Beta-Variables (1958), with 3/8.
double expected_quantile(std::size_t k, std::size_t n) {
    return normal_quantile((static_cast<double>(k) + 0.625) / (static_cast<double>(n) + 0.25));
}

/// Decorrelated residuals of one observable, in standard errors [1], in rising order.
std::vector<double> residuals_of(const Comparison& comparison, Eigen::Index observable) {
    std::vector<double> residuals;
    for (const ReadingMisfit& misfit : comparison.readings) {
        residuals.push_back(
            std::copysign(std::sqrt(misfit.chi2(observable)), misfit.normalised(observable)));
    }
    std::ranges::sort(residuals);
    return residuals;
}

/// Band in which an ordered residual of a correct model lies with a probability of 95 %:
///     q +- 1.96 sqrt(P (1 - P)/n)/phi(q),  P: probability below the quantile q, phi: density.
/// Source: Chambers et al., Graphical Methods for Data Analysis (1983), section 6.7.
Curve expected_band(std::size_t n) {
    Curve band{
        .label = "normal errors, 95 %", .style = Curve::Style::band, .colour = explaining_colour};
    band.in_key = false;
    for (std::size_t k = 0; k < n; ++k) {
        const double q = expected_quantile(k, n), below = normal_below(q);
        band.x.push_back(q);
        band.y.push_back(q);
        band.y_error.push_back(1.96 * std::sqrt(below * (1 - below) / static_cast<double>(n)) /
                               normal_density(q));
    }
    return band;
}

Figure quantile_figure(const Comparison& comparison) {
    Figure figure{.name = "qq",
                  .title = "Residuals against the quantiles of a normal distribution",
                  .panels = {}};
    const std::size_t n = comparison.readings.size();
    if (n < 3) return figure;
    Panel panel{.x_label = "quantile of the normal distribution [standard errors]",
                .y_label = "ordered residual [standard errors]"};
    Curve line = expected_band(n);
    panel.curves.push_back(line);
    line.style = Curve::Style::line;
    line.y_error.clear();
    line.in_key = line.banded = true;
    line.in_table = false;
    panel.curves.push_back(line);
    for (const Eigen::Index observable : {0, 1}) {
        Curve points{.label = observable == 0 ? "shear stress" : "solid fraction",
                     .colour = observable == 0 ? model_colour : calibrated_colour,
                     .symbol = observable == 0 ? Symbol{} : Symbol{Shape::square, Filling::hollow}};
        points.y = residuals_of(comparison, observable);
        for (std::size_t k = 0; k < n; ++k) {
            points.x.push_back(expected_quantile(k, n));
        }
        panel.curves.push_back(points);
    }
    panel.key = true;
    figure.panels = {panel};
    return figure;
}

/// Row of the ledger: a part of the readings, its part of chi2 and its number of measured values.
struct LedgerRow {
    std::string name;
    double chi2 = 0;
    double values = 0;
};

/// Parts with the largest chi2 per measured value, at most `most`, the largest first.
std::vector<LedgerRow> largest(std::vector<LedgerRow> parts, std::size_t most) {
    std::ranges::stable_sort(parts, std::greater(),
                             [](const LedgerRow& part) { return part.chi2 / part.values; });
    parts.resize(std::min(parts.size(), most));
    return parts;
}

std::string name_of(const Condition& c) {
    return fmt::format("{} Pa, {}, {}", nominal_text(c.normal_stress),
                       inertial_text(c.inertial_number),
                       c.dry() ? "dry" : fmt::format("content {:.3g}", c.liquid_content));
}

/// Parts of chi2 from observables, from files and from conditions: three groups.
std::vector<std::vector<LedgerRow>> ledger_rows(const Comparison& comparison) {
    constexpr std::size_t most_files = 6, most_conditions = 10;
    const auto count = static_cast<double>(comparison.readings.size());
    std::vector<LedgerRow> files, conditions;
    for (const FileMisfit& file : comparison.by_file) {
        files.push_back({plain_text(std::filesystem::path(file.file).filename().string()),
                         file.chi2, 2.0 * static_cast<double>(file.readings)});
    }
    for (const ConditionMisfit& each : comparison.by_condition) {
        conditions.push_back(
            {name_of(each.condition), each.chi2, 2.0 * static_cast<double>(each.readings.size())});
    }
    std::vector<std::vector<LedgerRow>> groups = {
        {{"shear stress", comparison.by_observable[0], count},
         {"solid fraction", comparison.by_observable[1], count}}};
    if (files.size() > 1) groups.push_back(largest(files, most_files));
    if (conditions.size() > 1) groups.push_back(largest(conditions, most_conditions));
    return groups;
}

Figure ledger_figure(const Comparison& comparison) {
    Figure figure{.name = "chi2_ledger", .title = "", .panels = {}};
    if (comparison.readings.empty()) return figure;
    figure.title = fmt::format("Parts of χ^2 = {:.1f} of {} measured values", comparison.total.chi2,
                               2 * comparison.readings.size() + comparison.direct.size());
    Panel panel{.x_label = "χ^2 per measured value", .y_label = ""};
    Curve bars{.label = "part of the readings",
               .style = Curve::Style::bars_across,
               .colour = model_colour};
    const auto groups = ledger_rows(comparison);
    // Rows count upwards; an empty row divides the groups.
    for (auto group = groups.rbegin(); group != groups.rend(); ++group) {
        if (group != groups.rbegin()) panel.y_names.emplace_back();
        for (auto part = group->rbegin(); part != group->rend(); ++part) {
            panel.y_names.push_back(part->name);
            bars.x.push_back(part->chi2 / part->values);
            bars.y.push_back(static_cast<double>(panel.y_names.size()));
        }
    }
    const double greatest = std::ranges::max(bars.x);
    panel.curves = {bars};
    panel.references = {{"expected for a correct model", 1, 0, true, calibrated_colour}};
    panel.x_range = {0, 1.08 * std::max(1.5, greatest)};
    panel.key = true;
    figure.panels = {panel};
    return figure;
}

}  // namespace

std::vector<Figure> misfit_figures(const Comparison& comparison) {
    std::vector<Figure> figures = {quantile_figure(comparison), ledger_figure(comparison)};
    std::erase_if(figures, [](const Figure& figure) { return figure.panels.empty(); });
    return figures;
}

namespace {

constexpr const char* observable_texts[] = {"shear stress", "solid fraction"};

/// Axis for a covariate, a quantity that residuals may depend on.
struct Axis {
    std::string label;
    bool logarithmic = false;
    double factor = 1;  ///< factor from SI units to the unit of the axis
};

Axis axis_of(const Covariate& covariate) {
    if (covariate.name == "normal stress") {
        return {"normal stress σ_{22} [Pa]", true};
    }
    if (covariate.name == "inertial number") {
        return {"inertial number I", true};
    }
    if (covariate.name == "liquid content") {
        return {"liquid content Φ_L/Φ_S"};
    }
    if (covariate.name == "height") {
        return {"predicted height [mm]", false, 1e3};
    }
    if (covariate.name == "time") {
        constexpr double minute = 60, hour = 3600;
        const double longest = covariate.values.maxCoeff();
        return longest > 2 * hour     ? Axis{"time [h]", false, 1 / hour}
               : longest > 5 * minute ? Axis{"time [min]", false, 1 / minute}
                                      : Axis{"time [s]"};
    }
    return {plain_text(covariate.name)};
}

Panel residual_panel(const Comparison& comparison, const Covariate& covariate) {
    const Axis axis = axis_of(covariate);
    Panel panel{.x_label = axis.label,
                .y_label = "residual/standard error",
                .log_x = axis.logarithmic && covariate.values.minCoeff() > 0,
                .zero_line = true,
                .y_least = 2.5};
    for (std::size_t o = 0; o < 2; ++o) {
        Curve points{.label = observable_texts[o],
                     .colour = o == 0 ? model_colour : calibrated_colour,
                     .symbol = o == 0 ? Symbol{} : Symbol{Shape::square, Filling::hollow}};
        for (std::size_t k = 0; k < comparison.readings.size(); ++k) {
            points.x.push_back(axis.factor * covariate.values(static_cast<Eigen::Index>(2 * k)));
            points.y.push_back(comparison.readings[k].normalised(static_cast<Eigen::Index>(o)));
        }
        panel.curves.push_back(points);
    }
    return panel;
}

Figure residuals_along(const Comparison& comparison) {
    std::vector<Reading> readings;
    Eigen::VectorXd predicted(2 * std::ssize(comparison.readings));
    for (const ReadingMisfit& misfit : comparison.readings) {
        predicted.segment<2>(2 * std::ssize(readings)) = misfit.predicted;
        readings.push_back(misfit.reading);
    }
    Figure figure{.name = "residuals",
                  .title = fmt::format("Residuals, measured minus predicted: χ^2 = {:.1f} for {} "
                                       "degrees of freedom",
                                       comparison.total.chi2, comparison.total.dof),
                  .panels = {}};
    for (const Covariate& covariate : covariates_of(readings, predicted)) {
        figure.panels.push_back(residual_panel(comparison, covariate));
    }
    if (!figure.panels.empty()) {
        figure.panels.front().key = true;
        figure.columns = std::min<std::size_t>(3, figure.panels.size());
    }
    return figure;
}

/// Symbol for residuals of a range of magnitudes in a map; its area grows with the residual.
struct Look {
    double from, to;  ///< range of |residual| in standard errors [1]
    double area;      ///< factor on the usual area of symbols [1]
};
constexpr Look looks[] = {{0, 1, 0.35}, {1, 2, 1}, {2, 3, 1.9}, {3, INFINITY, 3.2}};

std::string text_of(const Look& look, bool above) {
    const std::string size = std::isfinite(look.to)
                                 ? fmt::format("{:g} to {:g}", look.from, look.to)
                                 : fmt::format("more than {:g}", look.from);
    return fmt::format("{} by {}", above ? "above" : "below", size);
}

/// Whether a condition's mean residual of an observable has this sign and size.
bool has_look(const ConditionMisfit& group, std::size_t observable, const Look& look, bool above) {
    const double off = group.normalised(static_cast<Eigen::Index>(observable));
    return (off > 0) == above && std::abs(off) >= look.from && std::abs(off) < look.to;
}

double least_inertial_number(const Comparison& comparison) {
    double least = INFINITY;
    for (const ConditionMisfit& group : comparison.by_condition)
        least = std::min(least, group.condition.inertial_number);
    return least;
}

/// Panel of the mean residuals of an observable at a liquid content, over normal stress and
/// inertial number. `key`: whether the panel has the key that explains the symbols of all panels.
Panel map_panel(const Comparison& comparison, double liquid_content, std::size_t observable,
                bool key) {
    const std::string liquid =
        liquid_content == 0 ? "dry" : fmt::format("Φ_L/Φ_S = {:.3g}", liquid_content);
    Panel panel{
        .x_label = fmt::format("σ_{{22}} [Pa], {}, {}", observable_texts[observable], liquid),
        .y_label = "inertial number I",
        .log_x = true};
    panel.log_y = least_inertial_number(comparison) > 0;
    panel.key = key;
    for (const bool above : {true, false}) {
        for (const Look& look : looks) {
            Curve points{.label = text_of(look, above),
                         .colour = above ? calibrated_colour : model_colour,
                         .symbol = {Shape::circle, above ? Filling::filled : Filling::hollow},
                         .area = look.area};
            points.in_key = false;
            for (const ConditionMisfit& group : comparison.by_condition) {
                const bool in_panel = group.condition.liquid_content == liquid_content;
                if (in_panel && has_look(group, observable, look, above)) {
                    points.x.push_back(group.condition.normal_stress);
                    points.y.push_back(group.condition.inertial_number);
                }
                points.in_key = points.in_key || has_look(group, 0, look, above) ||
                                has_look(group, 1, look, above);
            }
            panel.curves.push_back(points);
        }
    }
    return panel;
}

/// Sets one range of inertial numbers for all panels, in which those of one set point lie together.
void share_inertial_numbers(Figure& figure, double least, double most) {
    constexpr double margin = 1.5;
    for (Panel& panel : figure.panels)
        if (panel.log_y) panel.y_range = {{least / margin, most * margin}};
}

/// Without panels where all readings have one inertial number.
Figure residual_map(const Comparison& comparison) {
    std::set<double> contents, inertial_numbers;
    for (const ConditionMisfit& group : comparison.by_condition) {
        contents.insert(group.condition.liquid_content);
        inertial_numbers.insert(group.condition.inertial_number);
    }
    if (inertial_numbers.size() < 2) contents.clear();
    Figure figure{.name = "residual_map",
                  .title = "Measured means above and below the model, in standard errors",
                  .panels = {},
                  .columns = contents.size()};
    constexpr std::size_t most_columns = 3;  // so that numbers along the axes have room
    if (contents.size() > most_columns) figure.columns = 2;
    for (std::size_t k = 0; k < 2 * contents.size(); ++k) {
        // Observables below one another or, for many contents, side by side.
        const bool beside = contents.size() > most_columns;
        const std::size_t observable = beside ? k % 2 : k / contents.size();
        const double content = *std::next(
            contents.begin(), static_cast<std::ptrdiff_t>(beside ? k / 2 : k % contents.size()));
        figure.panels.push_back(map_panel(comparison, content, observable, figure.panels.empty()));
    }
    if (!inertial_numbers.empty())
        share_inertial_numbers(figure, *inertial_numbers.begin(), *inertial_numbers.rbegin());
    return figure;
}

}  // namespace

std::vector<Figure> residual_figures(const Comparison& comparison) {
    std::vector<Figure> figures = {residuals_along(comparison), residual_map(comparison)};
    std::erase_if(figures, [](const Figure& figure) { return figure.panels.empty(); });
    return figures;
}

namespace {

Figure parity_figure(const Comparison& comparison) {
    Figure figure{.name = "parity",
                  .title = "Predicted against measured values",
                  .panels = {},
                  .stacked = true};
    for (std::size_t o = 0; o < 2; ++o) {
        Panel panel{.x_label = o == 0 ? "measured shear stress |σ_{12}| [Pa]"
                                      : "measured solid fraction Φ_S",
                    .y_label = o == 0 ? "predicted shear stress |σ_{12}| [Pa]"
                                      : "predicted solid fraction Φ_S"};
        Curve points{.label = "reading, ± 1 standard error along both axes",
                     .colour = model_colour};
        for (const auto& misfit : comparison.readings) {
            const auto i = static_cast<Eigen::Index>(o);
            points.x.push_back(misfit.reading.value(i));
            points.y.push_back(misfit.predicted(i));
            points.x_error.push_back(std::sqrt(misfit.reading.covariance(i, i)));
            points.y_error.push_back(std::sqrt(misfit.predicted_covariance(i, i)));
        }
        panel.curves.push_back(points);
        panel.diagonal = panel.x_uncertain = true;
        panel.key = o == 0;
        figure.panels.push_back(panel);
    }
    return figure;
}

}  // namespace

std::vector<Figure> comparison_figures(const StudyModel& study_model,
                                       const Calibration& calibration,
                                       const Comparison& comparison) {
    std::vector<Figure> figures = dry_figures(study_model, calibration);
    std::ranges::move(wet_figures(study_model, calibration, calibration.cohesion),
                      std::back_inserter(figures));
    figures.push_back(parity_figure(comparison));
    std::ranges::move(residual_figures(comparison), std::back_inserter(figures));
    std::ranges::move(misfit_figures(comparison), std::back_inserter(figures));
    std::ranges::move(parameter_figures(study_model, calibration), std::back_inserter(figures));
    return figures;
}

void mark_as_rejected(std::vector<Figure>& figures) {
    for (Figure& figure : figures) {
        figure.title += " (fit in doubt)";
    }
}

}  // namespace pendular
