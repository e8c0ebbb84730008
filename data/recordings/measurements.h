#pragma once

#include <filesystem>
#include <optional>

#include "data/reading.h"
#include "data/study/study.h"

namespace pendular {

/// Reads all files of a study and returns the readings in the order of the entries of study.toml.
/// Physically impossible readings are doubted and, unless the study keeps implausible readings,
/// excluded.
/// @throws InputError at file:line:column if a file cannot be read, is malformed or has invalid
///         values
Measurements read_measurements(const Study& study);

/// Removes the readings of a recording that its faults spoil, and returns a remark on each: all of
/// a recording with a wrong or constant column, otherwise those of which more than 1 in 100 rows
/// contradict each other or are saturated, since the mean over the other rows may be biased.
/// @param faults decided remarks on the recording
std::vector<Remark> set_spoilt_aside(std::vector<Reading>& readings,
                                     const std::vector<Remark>& faults, int averaged_rows);

/// Reads a table of readings in the format of `write_readings`, and returns them in the order of
/// the rows. Columns of the table:
/// - Required: normal_stress, shear_stress (magnitude) or stress_ratio, solid_fraction or
///   bulk_density, and shear_rate or inertial_number (0: quasi-static limit).
/// - Required in a study with a liquid, unless `source` gives it: liquid_content.
/// - Optional, among others: height, time, and the errors (`Columns::standard_error`). Without one,
///   the variance of a value is 0 until `pool_replicates` estimates or assumes it.
/// - Optional: filling, with shear_stress_of_filling and solid_fraction_of_filling, the parts of
///   the standard errors that the readings of a filling share (`Reading::shared`).
/// - Optional: bead_volume, otherwise from `source` or else from the table [cell].
///
/// If the table lacks heights and the study has a cell, they follow from the volume of grains and
/// the solid fraction. The error of the shear stress includes that of the normal stress.
/// @throws InputError at file:line:column for a malformed table, a missing column, an invalid
///         value, an unknown column whose name resembles a known name, and a liquid content that
///         both the table and `source` give
Measurements read_points(const std::filesystem::path& path, const Source& source,
                         const Study& study);

/// Estimates the scatter between replicates and adds it to the covariance of each reading. Also
/// sets `Reading::replicates` and `Reading::shared`, and adds doubts and notes. A two-way analysis
/// of variance separates the error of each step from that of the filling, which all steps of a file
/// share:
///     value = mean at the condition (1 + filling + step),   sd(step) ~ (normal stress)^-exponent
/// A variance with nu degrees of freedom is multiplied by (t/2)^2, t: Student's quantile for nu at
/// the probability of two standard deviations, so that two standard errors cover 95 %.
///
/// Other errors:
/// - Files or conditions that differ too much from their replicates get an error as large as their
///   distance (`set_far_replicates_apart`).
/// - Errors that the user states with all readings of a cluster of files (columns of errors) are
///   taken as known, unless the replicates scatter significantly more. A note says where replicates
///   scatter significantly more or less.
/// - Where the error of a value is neither estimated nor stated, it is 2 % of the value
///   (`Reading::error_assumed`), whatever the digits of the value.
/// - The rounding of a value is added where it exceeds the stated error (`add_rounding`).
/// @param stated scatter that the user states in place of the estimate
void pool_replicates(Measurements& measurements,
                     const std::optional<StatedScatter>& stated = std::nullopt);

/// Writes readings to a CSV file in SI units, in the format that an entry [[readings]] of
/// study.toml reads. Each row also has the source file (relative to the folder of the CSV file),
/// line, step, duration and number of replicates. The standard errors include the scatter between
/// replicates, which reading the file does not add again. Where steps of a filling share a part of
/// their errors, three more columns have the number of the filling and these parts.
/// @throws as `write_whole`
void write_readings(const std::filesystem::path& path, const Measurements& measurements);

/// Writes `Measurements::excluded` to a CSV file, with one line per range of rows: source file,
/// first line, last line and reason.
/// @throws as `write_whole`
void write_excluded(const std::filesystem::path& path, const Measurements& measurements);

}  // namespace pendular
