#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "data/reading.h"
#include "data/study/study.h"

namespace pendular {

/// Returns the readings of a study in the order of a calibration: dry readings, then wet readings,
/// each in the order of `Measurements::readings`.
std::vector<Reading> dry_first(const Measurements& measurements);

/// Largest number of readings that a fit treats one by one. The time of a fit grows with the cube
/// of the number: 200 readings take 0.5 s, 3000 would take minutes and 2 GB.
inline constexpr std::size_t most_fitted = 200;

/// Returns the readings that every fit and test of a study uses, dry readings first: the readings
/// of the study or, if there are more than `most_fitted`, means of readings at similar conditions
/// (`binned_readings`).
std::vector<Reading> readings_to_fit(const Measurements& measurements);

/// Returns a note for the user that `used` means take the place of `measured` readings; empty if
/// the readings themselves are used.
std::optional<std::string> note_on_means(std::size_t used, std::size_t measured);

std::size_t dry_count(const std::vector<Reading>& readings);

/// Returns the readings with indices `from` to `to` - 1.
std::vector<Reading> part(const std::vector<Reading>& readings, std::size_t from, std::size_t to);

/// Group of wet readings with about equal liquid contents and inertial numbers, either all of
/// steady shear or all points of failure (peaks of the shear stress).
struct WetGroup {
    std::vector<std::size_t> members;  ///< indices in the list of all readings
    double liquid_content = 0;         ///< [1], mean of the members
    double inertial_number = 0;        ///< [1], mean; 0 in the quasi-static limit
    bool at_failure = false;           ///< rather than in steady shear
};

/// Groups the wet readings by liquid content and inertial number. Each member agrees with the first
/// member of the group within 2 % in liquid content and within 20 % in inertial number.
/// Quasi-static readings (inertial number 0) and points of failure form separate groups. The groups
/// are sorted by liquid content, then by inertial number, then by steady shear before failure.
std::vector<WetGroup> wet_groups(const std::vector<Reading>& readings);

/// Whether two values differ by at most `tolerance` [1] times the larger of their magnitudes.
bool agree(double a, double b, double tolerance);

/// Largest relative difference of inertial numbers between first and other members of a `WetGroup`.
/// Chosen: wider than that of replicates, since the measured height and stress enter the number.
constexpr double inertial_number_tolerance = 0.2;

}  // namespace pendular
