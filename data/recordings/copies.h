#pragma once

#include <optional>
#include <string>
#include <vector>

#include "data/reading.h"
#include "data/recordings/recording.h"
#include "data/study/study.h"

namespace pendular {

/// Rows of all recordings of a study so far, to detect copies, so that no measurement counts twice.
/// A run of at least `shortest_step` rows with five different torques is a copy if torque, normal
/// force and gap agree with earlier rows within half the resolution of the coarser column, and if
/// all times differ by one constant. Copies may be rounded, incomplete, or within one recording.
class KnownRows {
  public:
    /// Finds the rows of a recording that are copies, and keeps its rows for later recordings. A
    /// remark of kind `restated_copy` says that study.toml states different liquid contents or
    /// volumes of grains for copy and original.
    /// @param rows receives the marks of the copied rows
    std::vector<Remark> copies_in(const Recording& recording, const Source& source,
                                  std::vector<bool>& rows);

  private:
    /// Rows of a recording between two restarts of its time, in SI units, with what study.toml
    /// states. Whatever does not depend on the other stretch of a comparison is computed once.
    struct Stretch {
        std::string file;
        std::vector<int> line;
        std::vector<double> time, torque, normal_force, height;
        std::optional<double> liquid_content, bead_volume;
        struct Range {
            double least = 0, most = 0, resolution = 0;
        };
        Range of_torque = {}, of_force = {}, of_height = {};
        double spacing = 0;  ///< median time between rows with different times [s]
        std::vector<std::size_t> by_torque = {};  ///< rows in ascending order of torque
        std::vector<double> sorted_torque = {};   ///< torques of these rows, for fast searches

        std::size_t size() const { return time.size(); }
    };
    /// For each row of a later stretch, index of the earlier row of which it is a copy.
    using Matches = std::vector<std::optional<std::size_t>>;

    /// Largest difference, in their unit, of two columns of which one is a copy, perhaps rounded:
    /// half the coarser resolution; 1 % of the largest value if a column is constant.
    static double copy_tolerance(const Stretch::Range& a, const Stretch::Range& b);
    /// Whether the ranges of all columns overlap: a quick test before rows are compared.
    static bool may_repeat(const Stretch& later, const Stretch& earlier);
    static Stretch stretch(const Recording& recording, const Step& rows, const Source& source);
    static Matches repeated_rows(const Stretch& later, const Stretch& earlier);
    static Matches matches_at(const Stretch& later, const Stretch& earlier, double offset);
    static std::vector<double> likely_offsets(const Stretch& later, const Stretch& earlier);
    static std::vector<Step> runs_of(const Matches& matches, const Stretch& later);
    static void report(const Stretch& later, const Stretch& earlier, const Matches& matches,
                       const std::vector<Step>& runs, std::vector<Remark>& found);

    std::vector<Stretch> known_;
};

/// Finds readings that repeat an earlier one: a remark of kind `repeated_reading` for each, and one
/// of kind `copied_readings` for each pair of files. A repetition agrees in normal stress, inertial
/// number, liquid content, volume of grains (if both are known), measured values, time and
/// covariance. Readings of different files need not agree in time and covariance if shear stress
/// and solid fraction have more than six digits, more than tables written by hand have.
std::vector<Remark> repeated_readings(const std::vector<Reading>& readings);

/// Finds recordings that repeat an earlier one but for a little noise, and so are no replicates: a
/// remark of kind `repeated_reading` for each of their readings, and one of kind `copied_readings`
/// for each pair of files, whose `relative` is the scatter between the two [1].
///
/// Steps of two recordings that have one number and one condition are compared, stress ratio and
/// solid fraction each by itself: d is the difference of the logarithms. Two tests, each of which
/// suffices:
/// - d is far too small for the scatter of the rows within the recordings: every replicate has
///   their variances of the mean, v1 and v2, besides its errors of the step and of the filling:
///     sum d^2/(v1 + v2)     is at least a chi2 with one degree of freedom for each step.
/// - The scatter of d about its mean is far below that between the other files of the cluster (F
///   test).
///
/// Recordings with columns so coarse that their resolution limits the errors (`coarse_steps`) pass
/// the first test: they agree because they are rounded. Readings of tables are not compared:
/// whether their rows are of one filling is not known, and errors that a table states are tested by
/// `pool_replicates`.
/// @param before remarks on the recordings so far
std::vector<Remark> near_copies(const std::vector<Reading>& readings,
                                const std::vector<Remark>& before);

}  // namespace pendular
