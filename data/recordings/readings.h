#pragma once

#include <filesystem>

#include "data/reading.h"
#include "data/study/study.h"

namespace pendular {

/// Reads a table of readings in the format of `write_readings`, and returns them in the order of
/// the rows. Columns of the table:
/// - Required: normal_stress, shear_stress (magnitude) or stress_ratio, solid_fraction or
///   bulk_density, and shear_rate or inertial_number (0: quasi-static limit).
/// - Required in a study with a liquid, unless `source` gives it: liquid_content.
/// - Optional, among others: height, time, and the errors (`Columns::standard_error`). Without one,
///   the variance of a value is 0 until `pool_replicates` estimates or assumes it.
/// - Optional: filling, with shear_stress_of_filling and solid_fraction_of_filling, the parts of
/// the
///   standard errors that the readings of a filling share (`Reading::shared`).
/// - Optional: bead_volume, otherwise from `source` or else from the table [cell].
///
/// If the table lacks heights and the study has a cell, they follow from the volume of grains and
/// the solid fraction. The error of the shear stress includes that of the normal stress.
/// @throws InputError at file:line:column for a malformed table, a missing column, an invalid
///         value, an unknown column whose name resembles a known name, and a liquid content that
///         both the table and `source` give
Measurements read_points(const std::filesystem::path& path, const Source& source,
                         const Study& study);

}  // namespace pendular
