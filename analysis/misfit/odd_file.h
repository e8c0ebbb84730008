#pragma once

#include <Eigen/Core>
#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "data/reading.h"

namespace pendular {

/// Recording that deviates most from a model in another way than all others.
struct OddFile {
    std::string file;
    Eigen::Index observable = 0;  ///< shear stress (0) or solid fraction (1)
    double deviation = 0;         ///< mean of measured/predicted - 1 over the file's readings [1]
    double others = 0;            ///< mean of the same of all other files [1]
    std::size_t files = 0;        ///< number of files, with this one
    /// Probability [1] that some file deviates as far in some observable where none is odd and
    /// files scatter, since each filling of a cell differs.
    double p = 1;
    /// Probability [1] of such a file where files do not scatter, but only the readings in them.
    double p_by_readings = 1;
    /// Mean height of the sample at the file's readings [m]; empty: unknown.
    std::optional<double> height = {};
    /// Whether no other file has the liquid content of this one: what is wrong may then be the
    /// model at that content.
    bool alone = false;

    /// Whether chance does not explain the deviation, at 5 % significance.
    bool stands_out() const;
    /// Whether it is the first recording to look at: it stands out, or p < 0.25 and the scatter
    /// within the files does not explain the deviation, but too few files say how fillings differ.
    bool worth_a_look() const;
    /// Error of the gap that would deviate so [m], positive for one that is shown too large.
    std::optional<double> gap_error() const;
};

/// Returns the file that deviates most (smallest p) from a model in another way than all other
/// files. Files are compared by the means of measured/predicted - 1 over their readings. The test
/// is Student's t of the distance of a file from the mean of the others, whose scatter is taken to
/// be at least that which the scatter within files gives; n - 2 degrees of freedom for n files,
/// corrected for 2 n tests (Bonferroni). Empty for fewer than three files with two readings each.
/// @param predicted shear stress [Pa] and solid fraction [1] of each reading in turn; further
///        entries are ignored
std::optional<OddFile> odd_file(const std::vector<Reading>& readings,
                                const Eigen::VectorXd& predicted);

}  // namespace pendular
