#pragma once

#include <optional>
#include <string>
#include <vector>

#include "calib/model/model.h"
#include "calib/model/predictor.h"
#include "data/reading.h"
#include "data/study/study.h"

namespace pendular {

/// Column that may have been read in a wrong unit, with the factor that removes the misfit.
struct UnitMistake {
    std::string column;  ///< "angular velocity"
    std::string files;   ///< "of all recordings", "of wet_1.csv" or "of the files dry_*.csv"
    double factor = 1;   ///< factor by which the column's numbers must be multiplied [1]
    std::string unit;    ///< meaning of the factor: "numbers in rpm were read as rad/s"
    double chi2_before = 0,
           chi2_after = 0;  ///< chi2 of all readings, with the model's errors as a floor
    int dof = 0;

    /// Sentence for the user.
    std::string sentence() const;
};

/// Looks for one column whose numbers multiplied by a factor of 10^n, 2 pi, 60, 57.3 or 9.81, or a
/// combination that units have, take at least 70 % off chi2 and leave a fit that holds: for
/// readings that no friction explains. Tried are the column of all recordings, of the files of one
/// entry of the study, and of one file. The friction is fitted anew for each factor, other
/// parameters stay. Of factors that mend alike, one that two units have between them comes before a
/// power of ten. None where chi2 is no larger than it should be.
/// @param parameters fitted ones, friction first
std::optional<UnitMistake> find_unit_mistake(const Predictor& model,
                                             const std::vector<Reading>& readings,
                                             const Study& study, const Eigen::VectorXd& parameters);

}  // namespace pendular
