#pragma once

#include <optional>
#include <string>
#include <vector>

#include "data/reading.h"
#include "data/recordings/recording.h"
#include "data/study/study.h"

namespace pendular {

/// Detects rows of a study's recordings that were copied from an earlier row, so that no
/// measurement counts twice. A KnownRows object keeps the rows of all recordings examined so far.
///
/// A row is a copy if torque, normal force and gap agree with an earlier row within half the
/// resolution of the coarser column. The times of all copied rows must differ from the earlier
/// times by one constant. Copies must form runs of at least `shortest_step` rows with at least five
/// different torques, since single rows of replicates (repeated measurements) agree by chance.
/// Copies are found even if the file was renamed, linked, reformatted, rounded, thinned out, cut or
/// shifted in time. Copies are also found within one recording whose time restarts.
class KnownRows {
  public:
    /// Removes copied rows from a recording. Lists the copied rows with the original rows in
    /// `result.excluded`, and names the files in `result.notes`. If study.toml states different
    /// liquid contents or volumes of grains for the copy and the original, adds a message to
    /// `result.doubts`.
    /// @param source entry of study.toml to which the recording belongs
    void take_out_copies(Recording& recording, const Source& source, Measurements& result);

  private:
    /// Rows of a recording between two restarts of its time column, in SI units, with the liquid
    /// content [1] and the volume of grains [m^3] that study.toml states.
    struct Stretch {
        std::string file;
        std::vector<int> line;
        std::vector<double> time, torque, normal_force, height;
        std::optional<double> liquid_content, bead_volume;

        std::size_t size() const { return time.size(); }
    };
    /// For each row of a later stretch (rows between two restarts of the time column), index of the
    /// row of an earlier stretch from which the row was copied; empty if the row is not a copy.
    using Matches = std::vector<std::optional<std::size_t>>;

    static Stretch stretch(const Recording& recording, const Step& rows, const Source& source);
    static Matches repeated_rows(const Stretch& later, const Stretch& earlier);
    static Matches matches_at(const Stretch& later, const Stretch& earlier, double offset);
    static std::vector<double> likely_offsets(const Stretch& later, const Stretch& earlier);
    static std::vector<Step> runs_of(const Matches& matches, const Stretch& later);
    static void report(const Stretch& later, const Stretch& earlier, const Matches& matches,
                       const std::vector<Step>& runs, Measurements& result);

    std::vector<Stretch> known_;
};

/// Moves readings that repeat an earlier reading from `measurements.readings` to
/// `measurements.excluded`. A reading is a repetition if normal stress, inertial number, liquid
/// content, volume of grains (if both are known), measured values, time and covariance equal those
/// of an earlier reading. For two readings from different files, time and covariance need not be
/// equal if shear stress and solid fraction have more than six digits, since values with so many
/// digits are hardly equal by chance. Notes on the repetitions are added to `measurements.notes`.
void count_readings_once(Measurements& measurements);

}  // namespace pendular
