#pragma once

#include <filesystem>

#include "data/reading.h"
#include "data/study/study.h"

namespace pendular {

/// Reads a table of readings, such as `write_readings` writes. Required columns are normal_stress;
/// shear_stress (magnitude) or stress_ratio; solid_fraction; shear_rate or inertial_number (0: the
/// quasi-static limit); and, in a study with a liquid, liquid_content, unless the entry of
/// study.toml gives it. Optional columns are height, bead_volume, time and the standard deviations
/// `NAME_sd`.
///
/// Without a column bead_volume, the volume of the entry in study.toml is used, else that of the
/// cell. Without a column height, the height is computed from this volume and the solid fraction,
/// if the study has a cell.
///
/// The covariance is that of shear stress and solid fraction. The standard deviation of a normal
/// stress, times shear stress/normal stress, is added in quadrature to that of the shear stress; it
/// is ignored for a stress ratio, which hardly depends on the normal stress. Variances without a
/// standard deviation are 0, for `pool_replicates` to fill in.
/// @throws InputError at file:line:column for a malformed table, a missing column, an invalid
///         value, and an unknown column whose name resembles a known name
Measurements read_points(const std::filesystem::path& path, const Source& source,
                         const Study& study);

}  // namespace pendular
