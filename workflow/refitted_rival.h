#pragma once

#include <Eigen/Core>
#include <memory>
#include <optional>
#include <string>

#include "workflow/study_diagnosis.h"

namespace pendular {

/// Fits a rival model to the readings and direct measurements of a diagnosis. The fit ends as soon
/// as the parameters are accurate to a small fraction of their standard errors.
/// @param start starting values of the parameters; empty: Parameter::start
/// @throws std::domain_error if the readings are impossible with the model
Rival refit_rival(const StudyDiagnosis& diagnosis, std::string name,
                  std::shared_ptr<const Predictor> predictor,
                  const std::optional<Eigen::VectorXd>& start = {});

}  // namespace pendular
