#pragma once

#include <filesystem>

#include "data/reading.h"
#include "data/study/study.h"

namespace pendular {

/// Reads a table of readings (measured shear stress and solid fraction, with the condition) in the
/// format of `write_readings`, and returns the readings in the order of the rows. Columns of the
/// table:
/// - Required: normal_stress, shear_stress (magnitude) or stress_ratio, solid_fraction or
///   bulk_density, and shear_rate or inertial_number (0: quasi-static limit).
/// - Required in a study with a liquid: liquid_content, unless the entry of study.toml gives the
///   liquid content.
/// - Optional, among others: height, time, and the standard deviations `NAME_sd`. Without a
///   standard deviation, the variance of a value is 0 until `pool_replicates` estimates the
///   variance.
/// - Optional: bead_volume. Without this column, the volume of grains comes from the entry of
///   study.toml or, if the entry has none, from the table [cell].
///
/// If the table lacks heights and the study has a cell, the heights follow from the volume of
/// grains and the solid fraction. The error of the shear stress includes the stated error of the
/// normal stress.
/// @param source entry of study.toml to which the table belongs
/// @throws InputError at file:line:column for a malformed table, a missing column, an invalid
///         value, an unknown column whose name resembles a known name, and a liquid content that
///         both the table and the entry of study.toml give
Measurements read_points(const std::filesystem::path& path, const Source& source,
                         const Study& study);

}  // namespace pendular
