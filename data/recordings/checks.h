#pragma once

#include <vector>

#include "data/annular_cell.h"
#include "data/files/formats/block_file.h"
#include "data/reading.h"
#include "data/recordings/recording.h"
#include "data/study/study.h"

namespace pendular {

/// Checks of recordings, of their files and of whole studies: pure functions, each in a source file
/// of its own, that return what they notice. `read_measurements` lists them.

/// Finds torques that lost their decimal or thousands mark: those that are, within 5 %, a power of
/// ten other than 1 times the torque of the row's shear stress. Empty if the recording has no shear
/// stresses, or if no torque agrees with its shear stress.
/// @param rows receives the marks of the rows with these torques
std::vector<Remark> torques_without_mark(const Recording& recording, const AnnularCell& cell,
                                         std::vector<bool>& rows);

/// Replaces the torques of the marked rows by those of their shear stresses.
void repair_torques(Recording& recording, const AnnularCell& cell, const std::vector<bool>& rows);

/// Finds rows of a recording in which two columns that measure one quantity contradict each other.
/// The pairs are shear stress and torque, normal stress and normal force, and shear rate and
/// angular velocity. Values of a pair, converted with the radii of the cell, may differ by the sum
/// of 5 % and the resolution of both columns. If their median ratio differs from 1 by more than
/// 2 %, one remark is on the whole column (`wrong_factor`), and no row is found for this pair; a
/// median ratio of shear rates between 0.5 and 2 is no doubt, since instruments may state the rate
/// at another radius than the mean, such as the rim.
/// @param rows receives the marks of the rows in which columns contradict each other
std::vector<Remark> contradictions(const Recording& recording, const AnnularCell& cell,
                                   std::vector<bool>& rows);

/// Returns a fault for each quantity whose measured column, such as "Normal Force", does not follow
/// its column of set points, such as "Normal Force set". Over the second half of each stretch of at
/// least 20 rows with a constant set point other than 0, the median of the measured values must
/// agree with it within 2 % or two steps of the resolution.
std::vector<Remark> missed_set_points(const BlockFile& file);

/// Returns a fault if the workbook of a file hides rows that are read.
std::vector<Remark> hidden_rows(const BlockFile& file);

/// Finds recordings whose angular velocities differ from those of most others by the factor between
/// two units. It must hold within 0.2 % at all steps, at least two, that two recordings took at
/// equal normal stress and liquid content. Returns one remark for each factor; none for more than
/// 500 recordings, since the time grows with the square of their number.
std::vector<Remark> other_speed_units(const std::vector<Reading>& readings);

/// Finds recordings that probably lost their last rows, and recordings of which no step gave a
/// reading. A recording counts as cut off if a longer file of the same entry of study.toml begins
/// with steps at the conditions of all its steps, and if it either ends there or goes on with a
/// step that gives no reading.
std::vector<Remark> incomplete_files(const Study& study, const Measurements& measurements);

/// Checks of a study and its readings, on which readings a model may hold. Each returns at most one
/// remark unless stated otherwise.

/// Finds patterns of study.toml that match no file: one remark for each.
std::vector<Remark> patterns_without_file(const Study& study);

/// Finds workbooks with sheets that no entry of study.toml reads: one remark for each.
std::vector<Remark> unread_sheets(const Study& study);

/// Finds readings whose liquid content is beyond separate bridges, with the saturation of their
/// pores.
std::vector<Remark> merging_bridges(const std::vector<Reading>& readings);

/// Finds a cell in which few beads fit side by side, or on one another.
std::vector<Remark> few_beads(const Study& study, const std::vector<Reading>& readings);

/// Finds readings whose gap crept while the torque was steady (`Condition::gap_creep`).
std::vector<Remark> creeping_gaps(const std::vector<Reading>& readings);

/// Finds readings at which side walls of the friction that the study states, and the weight of the
/// grains, gather the shear under the lid (`sheared_layer`). None in a study that states no
/// wall_friction in [cell], and if the model has the effect shear-localisation.
std::vector<Remark> uneven_shear(const Study& study, const std::vector<Reading>& readings);

/// Finds readings that are points of failure.
std::vector<Remark> points_of_failure(const std::vector<Reading>& readings);

/// Finds readings whose step is known and in which the weight of the grains over the area of the
/// cell, which raises the normal stress at the base of the sample, exceeds 10 % of the normal
/// stress. None without a cell, and if the model has the effect grain-weight.
std::vector<Remark> grain_weight(const Study& study, const std::vector<Reading>& readings);

}  // namespace pendular
