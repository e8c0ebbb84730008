#pragma once

#include <filesystem>

#include "data/reading.h"
#include "data/study/study.h"

namespace pendular {

/// Reads a table of readings in the format of `write_readings`, and returns the readings in the
/// order of the rows. Required columns are normal_stress, shear_stress (magnitude) or stress_ratio,
/// solid_fraction or bulk_density, and shear_rate or inertial_number (0: the quasi-static limit).
/// In a study with a liquid, the column liquid_content is required too, unless the entry of
/// study.toml gives the liquid content. Optional columns are, among others, height, bead_volume,
/// time and the standard deviations `NAME_sd`.
///
/// Without a column bead_volume, the volume of grains in the entry of study.toml is used or, if the
/// entry has none, the volume in the table [cell]. Without a column height, the height is computed
/// from the volume of grains and the solid fraction, if the study has a cell.
///
/// Each reading has a covariance matrix of its errors. The first row and column are those of the
/// shear stress [Pa], the second those of the solid fraction [1]. The standard deviation of a
/// normal stress, times shear stress/normal stress, is added in quadrature to the standard
/// deviation of the shear stress. The standard deviation of the normal stress is ignored if the
/// table gives stress ratios, which hardly depend on the normal stress. If the table gives no
/// standard deviation of a value, the variance of the value is 0 until `pool_replicates` estimates
/// the variance.
/// @param source entry of study.toml to which the table belongs
/// @throws InputError at file:line:column for a malformed table, a missing column, an invalid
///         value, an unknown column whose name resembles a known name, and a liquid content that
///         both the table and the entry of study.toml give
Measurements read_points(const std::filesystem::path& path, const Source& source,
                         const Study& study);

}  // namespace pendular
