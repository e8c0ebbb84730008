#pragma once

#include <filesystem>

#include "data/reading.h"
#include "data/study/study.h"

namespace pendular {

/// Reads ready-made points: a table with normal_stress; shear_stress (its magnitude) or
/// stress_ratio; solid_fraction; shear_rate or inertial_number, 0 being the quasi-static limit;
/// liquid_content, unless the study's entry gives it; optionally height, bead_volume, time and
/// `NAME_sd`, the standard deviations. What write_readings writes can be read.
///
/// A bead volume that no column gives is that of the study's entry, else of its cell; a height that
/// no column gives follows from it and the solid fraction where the study has a cell.
///
/// Values become shear stress and solid fraction with their covariance. A deviation of the normal
/// stress adds to that of a shear stress through the slope shear stress/normal stress; a stress
/// ratio hardly depends on it, so there it is left out.
/// A variance without deviation is left at zero for pool_replicates to fill.
/// @throws InputError at file:line:column for a malformed table, a value that cannot be, and a
///         column whose name is nearly a known one
Measurements read_points(const std::filesystem::path& path, const Source& source,
                         const Study& study);

}  // namespace pendular
