#pragma once

#include <optional>
#include <string>
#include <vector>

#include "calib/model/model.h"
#include "calib/model/predictor.h"
#include "data/reading.h"
#include "data/study/study.h"

namespace pendular {

/// Column of recordings that was probably read in a wrong unit.
struct UnitMistake {
    std::string column;   ///< name of the column, such as "angular velocity"
    std::string files;    ///< "of all recordings", "of wet_1.csv" or "of the files dry_*.csv"
    double factor = 1;    ///< the column must be multiplied by it [1]
    std::string unit;     ///< such as "numbers in rpm were read as rad/s"
    bool prefix = false;  ///< whether the units differ by their prefix alone
    /// chi2 of all readings [1] as read and after the multiplication, with the friction coefficient
    /// fitted each time. The model is given errors of 0.5 % of the shear stress and 0.1 % of the
    /// solid fraction.
    double chi2_before = 0, chi2_after = 0;
    int dof = 0;

    /// Returns a sentence for the user with the column to check, the factor and the reduction of
    /// chi2.
    std::string sentence() const;
};

/// Finds a column of the recordings that was probably read in a wrong unit: multiplying it by one
/// factor reduces chi2 by at least 70 %, to at most 3.5 per degree of freedom. Empty if no factor
/// does, or if chi2 as read is below 2 per degree of freedom.
///
/// Only columns are tried from which the readings came: no angular velocity is doubted where a
/// table states inertial numbers. The factors are powers of ten and those of units that are mixed
/// up (`unit_mix_ups`). Each is tried on the column in all files, in the files of one entry
/// [[recording]] or [[readings]] of study.toml, and in each file, with the friction coefficient
/// fitted again. Among factors that reduce chi2 about equally, a mix-up of two named units has
/// precedence.
/// @param parameters fitted values; the first is the friction coefficient
std::optional<UnitMistake> find_unit_mistake(const Predictor& model,
                                             const std::vector<Reading>& readings,
                                             const Study& study, const Eigen::VectorXd& parameters);

}  // namespace pendular
