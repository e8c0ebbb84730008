#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

namespace pendular {

/// Fault found in the rows of recordings, or the result of a test for one, significant or not.
struct RecordingFinding {
    /// Kinds of fault, the most serious first.
    enum class Kind {
        saturation,        ///< a column is limited by the largest value that the instrument gives
        level_change,      ///< from one recording on, readings at repeated conditions differ
        wobble,            ///< a column varies periodically with the rotation angle of the lid
        stick_slip,        ///< the torque rises slowly and drops suddenly, again and again
        drift,             ///< a column changes in one direction through the steps of a study
        unfinished_run_in  ///< a column still approaches its steady value as a step ends
    };
    Kind kind = Kind::wobble;
    std::string quantity = {};  ///< faulty column: "torque", "normal_force" or "height"
    /// Recordings with the fault in the order of measurement; for a level change, all from it on.
    std::vector<std::string> files = {};
    int step = 0;           ///< number in its file, from 1; 0: several steps or files
    std::size_t count = 1;  ///< number of steps or, for a level change, recordings compared
    /// Size of the fault, in the SI unit of the column:
    /// - saturation: largest value of the column
    /// - level change: change of the column, negative for a decrease
    /// - wobble: amplitude
    /// - stick-slip: median drop of the torque
    /// - drift: change over a whole step, negative for a decrease
    /// - unfinished run-in: distance from the steady value at the end of the step
    double size = 0;
    double size_error = 0;  ///< standard error of `size`; 0: not estimated
    /// `size` over the mean of the column [1]; for a saturation, share of saturated rows.
    double relative = 0;
    double relative_error = 0;  ///< standard error of `relative`; 0: not estimated
    double period = 0;          ///< of a wobble, in turns of the lid, or of stick-slip [s]
    /// Probability [1] of as clear a finding by chance in one step or, for level changes and
    /// drifts, in one study.
    double p = 1;
    bool offset = false;     ///< whether a level change is an offset rather than a factor
    bool corrected = false;  ///< whether the readings with the fault were excluded or corrected
};

/// Returns the name of a kind in JSON, such as "stick-slip".
std::string_view to_string(RecordingFinding::Kind kind);

/// Returns sentences for the user about findings, ordered by kind. One sentence combines all
/// findings that agree in kind, quantity and, for a wobble, period. It states where the fault was
/// found, its median size with the unit and in per cent, and the smallest p value or, for a
/// saturation, the share of saturated rows.
/// @param all each finding has a sentence of its own
std::vector<std::string> sentences(const std::vector<RecordingFinding>& findings, bool all = false);

}  // namespace pendular
