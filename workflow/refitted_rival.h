#pragma once

#include <Eigen/Core>
#include <memory>
#include <optional>
#include <string>

#include "workflow/study_diagnosis.h"

namespace pendular {

/// Rival model (one of several models to be told apart) that was fitted to the readings of a
/// diagnosis.
struct RefittedRival {
    Rival model;
    /// chi2 [1] of the rival model, for all readings and all direct measurements of effects'
    /// parameters.
    double chi2 = 0;

    /// Returns Akaike's criterion [1]: chi2 + 2 (number of parameters).
    double akaike() const { return akaike_of(chi2, model.parameters.size()); }
    /// Returns Akaike's criterion [1] of a model with the given chi2 [1] and number of parameters.
    static double akaike_of(double chi2, Eigen::Index parameters) {
        return chi2 + 2 * static_cast<double>(parameters);
    }
};

/// Excess of Akaike's criterion [1] at which the readings rule a model out: the criterion of the
/// model exceeds the criterion of the best model by this value or more.
/// Source: Burnham and Anderson, Model Selection and Multimodel Inference (2002), section 2.6.
inline constexpr double akaike_limit = 7;

/// Fits a rival model to the readings and direct measurements of a diagnosis. The fit ends as soon
/// as the parameters are accurate to a small fraction of their standard errors.
/// @param name name of the rival model
/// @param predictor rival model as a predictor of readings
/// @param start starting values of the parameters; empty: Parameter::start
/// @throws std::domain_error if the readings are impossible with the model
RefittedRival refit_rival(const StudyDiagnosis& diagnosis, std::string name,
                          std::shared_ptr<const Predictor> predictor,
                          const std::optional<Eigen::VectorXd>& start = {});

}  // namespace pendular
