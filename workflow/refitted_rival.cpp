#include "workflow/refitted_rival.h"

#include <utility>

#include "analysis/misfit/weighted_residuals.h"
#include "calib/fit/calibration.h"
#include "calib/fit/fit.h"

namespace pendular {

Rival refit_rival(const StudyDiagnosis& d, std::string name,
                  std::shared_ptr<const Predictor> predictor,
                  const std::optional<Eigen::VectorXd>& start) {
    // Rivals are ranked by differences of chi2 of several units (ranking.h): chi2 to a part in 1e8
    // is more than enough.
    constexpr FitEffort quick{
        .most_steps = 50, .tolerance = 1e-8, .settled = 1e-4, .elsewhere = false};
    const ModelOfReadings model(predictor, conditions_of(d.readings), d.models->direct());
    const Fit fitted = fit(model, d.evidence.measured, start ? *start : start_of(model), quick);
    return {std::move(name), std::move(predictor), fitted.parameters, fitted.covariance,
            WeightedResiduals(d.evidence.measured, fitted.prediction).chi2()};
}

}  // namespace pendular
