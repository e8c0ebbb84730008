#pragma once

#include <cstddef>
#include <set>
#include <string>
#include <string_view>
#include <vector>

#include "data/input_error.h"

namespace pendular {

/// Range of lines of a file, both counted from 1.
struct Lines {
    int first = 0, last = 0;
    std::size_t file = 0;  ///< index in `Remark::files`

    bool operator==(const Lines&) const = default;
};

/// Something that a check noticed in the data of a study: a value. A check returns what it notices,
/// `decide` says what follows from it, and only `data/remarks/wording.h` has words for it. Whoever
/// adds a check adds a function that returns remarks, a kind, in the group that decides what
/// follows unless `remark.cpp` has a row for it, and its words.
struct Remark {
    enum class Kind {
        // Faults inside recordings, the most serious first.
        saturation,         ///< a column is limited by the largest value that the instrument gives
        level_change,       ///< from one recording on, readings at repeated conditions differ
        wobble,             ///< a column varies periodically with the rotation angle of the lid
        stick_slip,         ///< the torque rises slowly and drops suddenly, again and again
        drift,              ///< a column changes in one direction through the steps of a study
        unfinished_run_in,  ///< a column still approaches its steady value as a step ends
        // Faults of a file.
        ratio_of_columns,  ///< stress over torque or force is not constant
        swapped_columns,
        declared_rows,
        time_goes_back,
        no_compression,
        repeated_rows,
        several_tests,
        header_constant,  ///< the header contradicts the columns
        header_cell,      ///< the header contradicts study.toml
        missed_set_point,
        missing_values,
        hidden_rows,             ///< a workbook hides rows, which are read
        filled_down,             ///< empty cells have the value of their group
        far_values,              ///< single values far above all others, as -999
        impossible_points,       ///< points whose numbers stand for no value, not used
        returning_load,          ///< points at a load that returns may be preshears
        falling_line,            ///< the line through points of failure falls
        cycles_in_one_interval,  ///< preshear and failure are not numbered as intervals
        // Values that are probably wrong.
        repaired_torques,
        restated_copy,  ///< study.toml states other contents for a copy than for the original
        wrong_factor,   ///< columns that measure the same, as torque and stress, differ by a factor
        contradicting_rows,
        constant_torque,
        constant_gap,
        impossible_filling,  ///< solid fraction of a recording that gave no reading
        impossible_value,
        saturated_column,
        other_speed_unit,
        far_files,
        far_condition,
        creeping_gap,  ///< the gap changes while the torque is steady
        uneven_shear,  ///< side walls and weight gather the shear under the lid
        // Rows that are not averaged.
        after_interval,
        without_point_number,
        cut_short,
        without_segment,
        marked_invalid,
        without_values,
        no_value,
        stated_role,
        other_test,  ///< the columns show another kind of test than shear at constant speed
        lacks_column,
        copied_rows,
        contradicting_row,
        saturated_row,
        spike,
        // Steps or parts of steps that are not averaged.
        few_rows,
        speed_ramp,
        back_and_forth,
        at_rest,
        short_strain,
        never_steady,
        few_steady_rows,
        short_steady_strain,
        tension,
        no_torque,
        transient,
        part_of_turn,
        // Readings that are set aside.
        repeated_reading,
        reading_of_wrong_column,
        contradicted_reading,
        saturated_reading,
        impossible_reading,
        // How the files were read.
        averaged_rows,
        rate_at_other_radius,
        copied_file,
        steps_with_spikes,
        flipped_torques,
        interpolated_steps,
        coarse_steps,
        unused_columns,
        sd_read_as_standard_error,  ///< columns NAME_sd without the number of values, NAME_n
        quasi_static_table,         ///< all inertial numbers are 0 or far below those of any lid
        copied_readings,
        pattern_without_file,
        unread_sheets,  ///< sheets of a workbook that no entry of study.toml names
        recordings_without_reading,
        ends_early,
        lacks_step,
        unlike_files,
        errors_below_rounding,
        errors_below_scatter,  ///< stated errors are too small for the scatter of replicates
        errors_above_scatter,  ///< stated errors are too large for the scatter of replicates
        few_replicates,
        assumed_errors,
        merging_bridges,
        few_beads,
        points_of_failure,
        outside_files,
        grain_weight,
        // Likely causes of a short strain.
        unloading,
        loading,
        consolidation,
        shear_to_failure,
        stopped_shear,
        preshear,
    };
    /// Consequence of a remark.
    enum class Outcome {
        undecided,
        found,      ///< told; nothing else follows
        kept,       ///< the user is warned; the readings stay
        set_aside,  ///< the user is warned; the readings are not used
        left_out,   ///< these rows or readings are not used
        note        ///< how the data were treated
    };
    Kind kind = Kind::wobble;
    Outcome outcome = Outcome::undecided;
    std::string quantity = {};  ///< `Quantity::name` of the column
    /// Files concerned, in the order of measurement; for a level change, all from it on.
    std::vector<std::string> files = {};
    std::vector<Lines> lines = {};
    int step = 0;           ///< number in its file, from 1; 0: several steps or files
    std::size_t count = 1;  ///< number of steps, rows, files or readings concerned
    std::size_t of = 0;     ///< number of them that were examined
    /// Size of the fault, in the SI unit of the column: largest value of a saturated column, change
    /// of a level, amplitude of a wobble, median drop of stick-slip, change over a whole step of a
    /// drift, distance from the steady value of an unfinished run-in, the doubtful value or factor
    /// of any other.
    double size = 0;
    double size_error = 0;  ///< standard error of `size`; 0: not estimated
    double size_to = 0;     ///< upper end of a range of sizes
    double limit = 0;       ///< value that `size` exceeds, misses or should have
    /// `size` over the mean of the column [1]; for a saturation, share of saturated rows.
    double relative = 0;
    double relative_error = 0;  ///< standard error of `relative`; 0: not estimated
    double period = 0;          ///< of a wobble, in turns of the lid, or of stick-slip [s]
    /// Probability [1] of as clear a finding by chance in one step or, for level changes and
    /// drifts, in one study.
    double p = 1;
    /// Degrees of freedom [1] of the scatter to which stated errors are compared.
    double freedom = 0;
    bool of_weight = false;  ///< whether uneven shear is due to the weight of the beads alone
    bool offset = false;     ///< whether a level change is an offset rather than a factor
    bool corrected = false;  ///< whether the readings with the fault were excluded or corrected
    std::vector<std::string> names = {};  ///< names from the file, such as those of its columns
    std::vector<Remark> because = {};     ///< what this remark sums up

    const std::string& file() const { return files.front(); }
    int first_line() const { return lines.front().first; }
    int last_line() const { return lines.front().last; }
    /// Adds a line of a file.
    void add(const Position& at);
};

/// Returns the name of a fault in JSON, such as "stick-slip" or "torque-shear_stress".
std::string to_string(const Remark& remark);

/// Whether a remark is on rows inside a recording, which need not be a fault of the file.
constexpr bool inside_recording(Remark::Kind kind) {
    return kind <= Remark::Kind::unfinished_run_in;
}
/// Whether a remark is on a step, or a part of one, that is not averaged.
constexpr bool on_step(Remark::Kind kind) {
    return kind >= Remark::Kind::few_rows && kind <= Remark::Kind::part_of_turn;
}
/// Whether a remark is on a whole reading that is not used, or on a step that would have been one.
constexpr bool on_reading(Remark::Kind kind) {
    using enum Remark::Kind;
    return kind == tension || kind == no_torque ||
           (kind >= repeated_reading && kind <= impossible_reading);
}
/// Whether a remark is on a step whose steady part is missing or too short.
constexpr bool without_plateau(Remark::Kind kind) {
    using enum Remark::Kind;
    return kind >= never_steady && kind <= short_steady_strain;
}
/// Whether a remark is on rows of a step outside of its steady part.
constexpr bool beside_plateau(Remark::Kind kind) {
    return kind == Remark::Kind::transient || kind == Remark::Kind::part_of_turn;
}

/// Decides what follows from each remark on which that is undecided: the one place where it is. In
/// a study that keeps implausible readings, remarks without consequence are removed.
std::vector<Remark> decide(std::vector<Remark> remarks, bool keep_implausible);

void append(std::vector<Remark>& to, std::vector<Remark> more);

/// Adds a line to the last range if it follows directly, and otherwise as a new one. Lines must be
/// added in ascending order.
void add_line(std::vector<Lines>& lines, int line);

std::set<int> all_lines(const std::vector<Lines>& ranges);

/// Returns the number of lines of a set from `first` to `last`.
std::size_t lines_within(const std::set<int>& lines, int first, int last);

}  // namespace pendular
