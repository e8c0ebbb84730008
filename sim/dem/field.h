#pragma once

#include <array>
#include <cstddef>
#include <string_view>
#include <vector>

#include "data/recordings/time_series.h"

namespace pendular::dem {

/// Coordinate on which a field depends.
enum class Coordinate { height, angle, relative_force, gap };

/// Quantity that a run averages as a function of one coordinate, such as a velocity profile.
enum class Field {
    velocity,
    solid_fraction,
    granular_temperature,
    contact_orientation,
    contact_force_by_orientation,
    contact_force,
    distant_orientation,
    distant_gap,
};

struct CoordinateAbout {
    std::string_view name;  ///< in JSON and in headers of CSV files
    std::string_view unit;  ///< "1" if dimensionless
    std::string_view meaning;
    std::string_view table;  ///< CSV file of all its fields, without extension
};
constexpr std::array coordinates = std::to_array<CoordinateAbout>(
    {{"height", "1", "position along the velocity gradient over the sample's height", "profiles"},
     {"angle", "degree",
      "angle of a pair's normal in the plane of flow and gradient, from the flow towards the "
      "gradient",
      "orientations"},
     {"relative_force", "1", "elastic normal force of a contact over the mean of all contacts",
      "contact_forces"},
     {"gap", "1", "gap of a bridge without contact over the grain diameter", "gaps"}});

struct FieldAbout {
    std::string_view name;  ///< in JSON and in headers of CSV files
    Coordinate coordinate;
    std::string_view unit;     ///< "1" if dimensionless
    std::string_view meaning;  ///< with its normalisation
    bool needs_bridges = false;
};
constexpr std::array fields = std::to_array<FieldAbout>(
    {{"velocity", Coordinate::height, "1", "velocity along the flow over shear rate times height"},
     {"solid_fraction", Coordinate::height, "1",
      "volume of the grains inside the bin over the volume of the bin"},
     {"granular_temperature", Coordinate::height, "1",
      "mean square of one component of velocity about the bin's mean over (diameter times shear "
      "rate)^2"},
     {"contact_orientation", Coordinate::angle, "1/rad",
      "probability density of the contacts' angle; 1/pi where isotropic"},
     {"contact_force_by_orientation", Coordinate::angle, "1",
      "mean elastic normal force of the contacts at that angle over a^2 s22"},
     {"contact_force", Coordinate::relative_force, "1",
      "probability density of a contact's elastic normal force over the mean"},
     {"distant_orientation", Coordinate::angle, "1/rad",
      "probability density of the angle of bridges without contact; 1/pi where isotropic", true},
     {"distant_gap", Coordinate::gap, "1",
      "probability density of the gap, over the diameter, of bridges without contact", true}});
constexpr std::size_t field_count = fields.size();
static_assert(static_cast<std::size_t>(Field::distant_gap) + 1 == field_count);
static_assert(static_cast<std::size_t>(Coordinate::gap) + 1 == coordinates.size());

constexpr const FieldAbout& about(Field which) {
    return fields[static_cast<std::size_t>(which)];
}
constexpr const CoordinateAbout& about(Coordinate which) {
    return coordinates[static_cast<std::size_t>(which)];
}
/// Whether a field is a profile along the height rather than a distribution over pairs of grains.
constexpr bool is_profile(Field which) {
    return about(which).coordinate == Coordinate::height;
}

/// Time averages of a field over a run, one for each bin; NaN for a bin without data.
struct BinnedMeans {
    std::vector<double> at;  ///< middle of each bin, in the coordinate's unit
    std::vector<Mean> means;
};

}  // namespace pendular::dem
