#include "reports/comparison_figures.h"

#include <algorithm>
#include <cmath>
#include <iterator>

#include "reports/dry_figures.h"
#include "reports/figure_style.h"
#include "reports/misfit_figures.h"
#include "reports/parameter_figures.h"
#include "reports/residual_figures.h"
#include "reports/wet_figures.h"

namespace pendular {
namespace {

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
    std::vector<Figure> figures = dry_figures(study_model, calibration);
    std::ranges::move(wet_figures(study_model, calibration, calibration.cohesion),
                      std::back_inserter(figures));
    figures.push_back(parity_figure(comparison));
    std::ranges::move(residual_figures(comparison), std::back_inserter(figures));
    std::ranges::move(misfit_figures(comparison), std::back_inserter(figures));
    std::ranges::move(parameter_figures(study_model, calibration), std::back_inserter(figures));
    return figures;
}

}  // namespace pendular
