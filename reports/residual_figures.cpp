#include "reports/residual_figures.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <set>
#include <string>

#include "analysis/diagnosis/study_evidence.h"
#include "reports/figure_style.h"
#include "reports/figure_text.h"

namespace pendular {
namespace {

constexpr const char* observables[] = {"shear stress", "solid fraction"};

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
                .y_label = "(measured − predicted)/standard error",
                .log_x = axis.logarithmic && covariate.values.minCoeff() > 0,
                .zero_line = true,
                .headroom = 0.2,
                .y_least = 2.5};
    for (std::size_t o = 0; o < 2; ++o) {
        Curve points{.label = observables[o],
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
                  .title = fmt::format("Residuals: χ^2 = {:.2f}, degrees of freedom: {}",
                                       comparison.total.chi2, comparison.total.dof),
                  .panels = {},
                  .columns = 3};
    for (const Covariate& covariate : covariates_of(readings, predicted)) {
        figure.panels.push_back(residual_panel(comparison, covariate));
    }
    if (!figure.panels.empty()) {
        figure.panels.front().key = Key::top_left;
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

/// Panel of the mean residuals of an observable at a liquid content, over normal stress and
/// inertial number. `key`: whether the panel has the key that explains all symbols.
Panel map_panel(const Comparison& comparison, double liquid_content, std::size_t observable,
                bool key) {
    const std::string liquid =
        liquid_content == 0 ? "dry" : fmt::format("content {:.3g}", liquid_content);
    Panel panel{.x_label = fmt::format("σ_{{22}} [Pa] ({}, {})", observables[observable], liquid),
                .y_label = "inertial number I",
                .log_x = true};
    panel.key = key ? Key::outside : Key::none;
    for (const bool above : {true, false}) {
        for (const Look& look : looks) {
            Curve points{.label = text_of(look, above),
                         .colour = above ? calibrated_colour : model_colour,
                         .symbol = {Shape::circle, above ? Filling::filled : Filling::hollow},
                         .area = look.area};
            for (const ConditionMisfit& group : comparison.by_condition) {
                const double off = group.normalised(static_cast<Eigen::Index>(observable));
                if (group.condition.liquid_content == liquid_content && (off > 0) == above &&
                    std::abs(off) >= look.from && std::abs(off) < look.to) {
                    points.x.push_back(group.condition.normal_stress);
                    points.y.push_back(group.condition.inertial_number);
                }
            }
            panel.curves.push_back(points);
        }
    }
    return panel;
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
                  .title = "Where measured means lie above or below the model, in standard errors",
                  .panels = {},
                  .columns = contents.size(),
                  .small = true};
    for (const std::size_t observable : {0u, 1u}) {
        for (const double content : contents) {
            const bool last = observable == 0 && content == *contents.rbegin();
            figure.panels.push_back(map_panel(comparison, content, observable, last));
        }
    }
    return figure;
}

}  // namespace

std::vector<Figure> residual_figures(const Comparison& comparison) {
    std::vector<Figure> figures = {residuals_along(comparison), residual_map(comparison)};
    std::erase_if(figures, [](const Figure& figure) { return figure.panels.empty(); });
    return figures;
}

}  // namespace pendular
