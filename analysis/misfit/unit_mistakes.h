#pragma once

#include <optional>
#include <string>
#include <vector>

#include "calib/model/model.h"
#include "calib/model/predictor.h"
#include "data/reading.h"
#include "data/study/study.h"

namespace pendular {

/// Column of recordings that was probably read in a wrong unit, with the factor that corrects the
/// numbers of the column.
struct UnitMistake {
    std::string column;  ///< name of the column, such as "angular velocity"
    /// Phrase that names the files in which the column was read in a wrong unit: "of all
    /// recordings", "of wet_1.csv" or "of the files dry_*.csv".
    std::string files;
    /// Factor [1] by which the numbers of the column must be multiplied to remove the misfit of the
    /// model.
    double factor = 1;
    /// Meaning of the factor, such as "numbers in rpm were read as rad/s".
    std::string unit;
    /// chi2 of all readings [1] before (`chi2_before`) and after (`chi2_after`) the numbers of the
    /// column are multiplied by `factor`. The friction coefficient is fitted anew each time. The
    /// model is assumed to have errors of 0.5 % of the shear stress and 0.1 % of the solid
    /// fraction.
    double chi2_before = 0, chi2_after = 0;
    int dof = 0;  ///< degrees of freedom of `chi2_before` and of `chi2_after`

    /// Returns a sentence for the user that names the column to check, the factor and the reduction
    /// of chi2.
    std::string sentence() const;
};

/// Finds a column of the recordings, such as the torque, that was probably read in a wrong unit.
/// Multiplying the numbers of the column by one factor must reduce chi2 by at least 70 %, to at
/// most 3.5 per degree of freedom. The result is empty if no factor reduces chi2 that much, or if
/// chi2 without a factor is below 2 per degree of freedom.
///
/// The factors are powers of ten and ratios of two named units, such as 60 or 9.81. Each factor is
/// tried on the column in all files, in the files that one entry [[recording]] or [[readings]] of
/// study.toml names, and in each single file. The friction coefficient is fitted again each time.
/// Among factors that reduce chi2 about equally, a ratio of two named units has precedence.
/// @param parameters values of the model's fitted parameters; the first is the friction coefficient
std::optional<UnitMistake> find_unit_mistake(const Predictor& model,
                                             const std::vector<Reading>& readings,
                                             const Study& study, const Eigen::VectorXd& parameters);

}  // namespace pendular
