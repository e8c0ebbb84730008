#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

namespace pendular {

/// Something that the rows of recordings show besides the steady means, such as a wobble of the
/// lid.
struct RecordingFinding {
    enum class Kind {
        saturation,        ///< a column stands at the largest value that the instrument gives
        level_change,      ///< from one recording on, repeated conditions give other values
        wobble,            ///< a column varies periodically with the rotation angle of the lid
        stick_slip,        ///< the torque rises slowly and drops suddenly, again and again
        drift,             ///< a column changes steadily after the transient of many steps
        unfinished_run_in  ///< a column still approaches its level at the end of a step
    };
    Kind kind = Kind::wobble;
    std::string quantity = {};  ///< column by name: "torque", "normal_force" or "height"
    /// Paths of the files concerned, in run order; a level change concerns all files from the first
    /// one here on.
    std::vector<std::string> files = {};
    int step = 0;           ///< number of the step in its file, from 1; 0: several steps or files
    std::size_t count = 1;  ///< number of steps that the finding is based on
    /// Size in the SI unit of the column: saturation: largest value; wobble: amplitude; stick-slip:
    /// usual drop; drift: change over the steady part; level change: change of the column; run-in:
    /// distance from the level at the end of the step.
    double size = 0;
    double size_error = 0;  ///< standard error of `size`, in its unit; 0: not estimated
    /// Size over the mean of the column [1]; saturation: share of the rows at the largest value.
    double relative = 0;
    double relative_error = 0;  ///< standard error of `relative` [1]; 0: not estimated
    /// Period of a wobble [turns of the lid] or of stick-slip [s]; 0: none.
    double period = 0;
    /// p value [1]: probability that chance alone gives as clear a finding in one step (level
    /// change, drift: in one study) of a faultless instrument.
    double p = 1;
    bool offset = false;  ///< level change: whether an offset describes it better than a factor
    /// Whether import set the readings concerned aside, or corrected them.
    bool corrected = false;
};

/// Name of a kind of finding for JSON, such as "stick-slip".
std::string_view to_string(RecordingFinding::Kind kind);

/// Sentences on findings, the most serious kinds first. Findings of the same kind, quantity and
/// period share a sentence, which names the number of steps and files, the first place, the usual
/// size with its unit and in per cent, and the smallest p value.
/// @param all whether each finding has a sentence of its own instead
std::vector<std::string> sentences(const std::vector<RecordingFinding>& findings, bool all = false);

}  // namespace pendular
