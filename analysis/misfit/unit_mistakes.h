#pragma once

#include <optional>
#include <string>
#include <vector>

#include "calib/model/model.h"
#include "calib/model/predictor.h"
#include "data/reading.h"
#include "data/study/study.h"

namespace pendular {

/// Column of recordings that was probably read in a wrong unit, with the factor on its numbers that
/// removes the misfit.
struct UnitMistake {
    std::string column;  ///< name of the column, such as "angular velocity"
    /// Phrase that names the files in which the column was read in a wrong unit: "of all
    /// recordings", "of wet_1.csv" or "of the files dry_*.csv".
    std::string files;
    /// Factor by which the numbers of the column must be multiplied to remove the misfit [1].
    double factor = 1;
    /// Meaning of the factor, such as "numbers in rpm were read as rad/s".
    std::string unit;
    /// chi2 of all readings [1], without the factor (`chi2_before`) and with the factor
    /// (`chi2_after`) on the column. The friction coefficient is fitted in both cases. The model is
    /// assumed to have errors of 0.5 % of the shear stress and 0.1 % of the solid fraction.
    double chi2_before = 0, chi2_after = 0;
    int dof = 0;  ///< degrees of freedom of `chi2_before` and of `chi2_after`

    /// Returns a sentence for the user that names the column to check, the factor and the reduction
    /// of chi2.
    std::string sentence() const;
};

/// Finds a column of the recordings that was probably read in a wrong unit. Multiplying the numbers
/// of the column by one factor must reduce chi2 by at least 70 %, to at most 3.5 per degree of
/// freedom. The result is empty if no factor reduces chi2 that much, or if chi2 without a factor is
/// below 2 per degree of freedom.
///
/// The factors are powers of ten and ratios of two named units, such as 60 or 9.81. Each factor is
/// tried on the column in all recordings, in the files that one entry of study.toml names, and in
/// each single file. The friction coefficient is fitted again each time. Among factors that reduce
/// chi2 about equally, a ratio of two named units has precedence.
/// @param parameters values of the model's fitted parameters; the first is the friction coefficient
std::optional<UnitMistake> find_unit_mistake(const Predictor& model,
                                             const std::vector<Reading>& readings,
                                             const Study& study, const Eigen::VectorXd& parameters);

}  // namespace pendular
