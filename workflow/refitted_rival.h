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
    double chi2 = 0;  ///< chi2 [1] of all readings and direct measurements

    /// Returns Akaike's criterion [1]: chi2 + 2 (number of parameters).
    double akaike() const { return akaike_of(chi2, model.parameters.size()); }
    /// Returns Akaike's criterion [1] of a model with the given chi2 [1] and number of parameters.
    static double akaike_of(double chi2, Eigen::Index parameters) {
        return chi2 + 2 * static_cast<double>(parameters);
    }
};

/// Smallest difference of Akaike's criterion [1] to the best model at which the readings rule a
/// model out.
/// Source: Burnham and Anderson, Model Selection and Multimodel Inference (2002), section 2.6.
inline constexpr double little_support = 7;

/// Fits a rival model to the readings and direct measurements of a diagnosis. Parameters need not
/// be more accurate than a small share of their errors.
/// @param name name of the rival model
/// @param start starting values of the parameters; empty: Parameter::start
/// @throws std::domain_error if the readings are impossible with the model
RefittedRival refit_rival(const StudyDiagnosis& diagnosis, std::string name,
                          std::shared_ptr<const Predictor> predictor,
                          const std::optional<Eigen::VectorXd>& start = {});

}  // namespace pendular
