#pragma once

#include <optional>
#include <string>
#include <vector>

#include "data/reading.h"
#include "data/recordings/recording.h"
#include "data/study/study.h"

namespace pendular {

/// The rows of the recordings read so far, so that a copy of them does not count as another
/// measurement.
///
/// A row is a copy where torque, normal force and gap agree with a row of an earlier recording, or
/// of an earlier stretch of time of its own, within half the resolution of the coarser column and
/// the times differ by one constant. Copies come in runs of at least `shortest_step` rows with
/// five values of torque or more: single rows of replicates agree by chance. So renamed, linked,
/// reformatted, rounded, thinned out, cut and shifted copies are found, and replicates are not,
/// whose times may be the same.
class KnownRows {
  public:
    /// Takes the copies out of a recording and lists them in `result` with what they repeat. Raises
    /// a doubt where the study states another liquid content or bead volume for the copy than for
    /// the original.
    void take_out_copies(Recording& recording, const Source& source, Measurements& result);

  private:
    /// Rows between restarts of time.
    struct Stretch {
        std::string file;
        std::vector<int> line;
        std::vector<double> time, torque, normal_force, height;
        std::optional<double> liquid_content, bead_volume;

        std::size_t size() const { return time.size(); }
    };
    /// For each row of the later stretch, the row of the earlier one that it repeats, if any.
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

/// Moves readings to `excluded` that repeat an earlier one: all values and errors equal, or, from
/// two files, all values equal to more digits than chance allows.
void count_readings_once(Measurements& measurements);

}  // namespace pendular
