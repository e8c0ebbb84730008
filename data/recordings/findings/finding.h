#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

namespace pendular {

/// Fault that the rows of recordings show, such as a wobble of the lid. The result of a test for
/// such a fault has this type too, whether significant or not.
struct RecordingFinding {
    /// Kind of fault that the rows of recordings can show.
    enum class Kind {
        saturation,  ///< torque or force is limited by the largest value that the instrument gives
        level_change,      ///< from one recording on, repeated conditions give other values
        wobble,            ///< a column varies periodically with the rotation angle of the lid
        stick_slip,        ///< the torque rises slowly and drops suddenly, again and again
        drift,             ///< a column changes in one direction through the steps of a study
        unfinished_run_in  ///< a column still approaches its level at the end of a step
    };
    Kind kind = Kind::wobble;
    std::string quantity = {};  ///< column by name: "torque", "normal_force" or "height"
    /// Paths of the files with the fault, in the order of measurement. After a level change, these
    /// are all files from the change on.
    std::vector<std::string> files = {};
    int step = 0;           ///< number of the step in its file, from 1; 0: several steps or files
    std::size_t count = 1;  ///< number of steps that the finding is based on
    /// Size of the fault in the SI unit of the column. Saturation: largest value; wobble:
    /// amplitude; stick-slip: median drop; drift: change over a whole step; level change: change of
    /// the column; run-in: distance from the level at the end of the step.
    double size = 0;
    double size_error = 0;  ///< standard error of `size`, in its unit; 0: not estimated
    /// Size of the fault over the mean of the column [1]. Saturation: share of the rows at the
    /// largest value.
    double relative = 0;
    double relative_error = 0;  ///< standard error of `relative` [1]; 0: not estimated
    /// Wobble: period as a number of turns of the lid; stick-slip: period [s]; 0: none.
    double period = 0;
    /// p value [1]: probability that a faultless instrument causes as clear a finding by chance in
    /// one step (level change and drift: in one study).
    double p = 1;
    bool offset = false;  ///< level change: whether an offset fits better than a factor
    /// Whether import moved the affected readings to the excluded ones or corrected them.
    bool corrected = false;
};

/// Name of a kind of fault in JSON, such as "stick-slip".
std::string_view to_string(RecordingFinding::Kind kind);

/// Returns sentences for the user about findings, the most serious kinds first. Findings of one
/// kind, quantity and period are combined in a sentence with the number of steps and files, the
/// first position, the usual size with its unit and in per cent, and the smallest p value.
/// @param all true: one sentence for each finding instead
std::vector<std::string> sentences(const std::vector<RecordingFinding>& findings, bool all = false);

}  // namespace pendular
