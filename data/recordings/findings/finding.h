#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

namespace pendular {

/// Fault found in the rows of recordings, such as a wobble of the lid. The result of a test for a
/// fault, whether significant or not, also has the type RecordingFinding.
struct RecordingFinding {
    /// Kind of fault that can be found in the rows of recordings.
    enum class Kind {
        saturation,  ///< torque or force is limited by the largest value that the instrument gives
        /// From one recording on, readings at repeated conditions differ from earlier readings.
        level_change,
        wobble,            ///< a column varies periodically with the rotation angle of the lid
        stick_slip,        ///< the torque rises slowly and drops suddenly, again and again
        drift,             ///< a column changes in one direction through the steps of a study
        unfinished_run_in  ///< a column still approaches its steady value as a step ends
    };
    Kind kind = Kind::wobble;
    std::string quantity = {};  ///< name of the faulty column: "torque", "normal_force" or "height"
    /// Paths of the recordings with the fault, in the order of measurement. For a level change,
    /// `files` lists all recordings from the change on.
    std::vector<std::string> files = {};
    /// Number of the faulty step in its file, from 1; 0: the fault concerns several steps or files.
    int step = 0;
    /// Number of steps from which the fault was found. For a level change, `count` is the number of
    /// recordings that were compared.
    std::size_t count = 1;
    /// Size of the fault, in the SI unit of the faulty column:
    /// - saturation: largest value of the column
    /// - level change: change of the column, negative for a decrease
    /// - wobble: amplitude
    /// - stick-slip: median drop of the torque
    /// - drift: change over a whole step, negative for a decrease
    /// - unfinished run-in: distance from the steady value at the end of the step
    double size = 0;
    /// Standard error of the size of the fault, in the SI unit of the faulty column; 0: not
    /// estimated.
    double size_error = 0;
    /// Size of the fault (`size`) divided by the mean of the faulty column [1]. For a saturation,
    /// `relative` is the share of the step's rows that are at the largest value.
    double relative = 0;
    /// Standard error of the size of the fault divided by the mean of the faulty column [1]; 0: not
    /// estimated.
    double relative_error = 0;
    /// Period of the fault. The period of a wobble is a number of turns of the lid. The period of a
    /// stick-slip is the time [s] from one drop of the torque to the next drop. All other faults
    /// have the period 0.
    double period = 0;
    /// p value [1]: probability that a faultless instrument causes as clear a finding by chance in
    /// one step. For level changes and drifts, the probability is that of a finding in one study.
    double p = 1;
    /// Whether the fault is a level change of the column that a common offset describes better than
    /// a common factor.
    bool offset = false;
    /// Whether the readings with the fault were excluded or corrected when the recording was read.
    bool corrected = false;
};

/// Returns the name of a kind of fault in JSON, such as "stick-slip".
std::string_view to_string(RecordingFinding::Kind kind);

/// Returns sentences for the user about findings, the most serious kinds first. One sentence
/// combines all findings that agree in kind, quantity and, for a wobble, period. A sentence states
/// where the fault was found, its median size with the unit and in per cent, and the smallest p
/// value. A sentence on a saturation states the share of saturated rows instead of a p value.
/// @param all true: each finding has a sentence of its own
std::vector<std::string> sentences(const std::vector<RecordingFinding>& findings, bool all = false);

}  // namespace pendular
