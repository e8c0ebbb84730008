#pragma once

#include <array>
#include <cstddef>
#include <string_view>
#include <vector>

#include "data/recordings/time_series.h"
#include "sim/dem/bridge_law.h"
#include "sim/dem/cell.h"
#include "sim/dem/contact_law.h"
#include "sim/dem/grains.h"
#include "sim/dem/pair_list.h"

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

/// Bins of equal width from 0 to `end`, in the unit of the coordinate.
struct Bins1d {
    std::size_t count = 0;
    double end = 1;

    double width() const { return end / static_cast<double>(count); }
    double middle(std::size_t bin) const { return (static_cast<double>(bin) + 0.5) * width(); }
    /// Returns the index of the bin that contains a value: 0 for negative values and `count` for
    /// values beyond the last bin.
    std::size_t of(double value) const {
        const double bin = value < 0 ? 0 : value / width();
        return bin < static_cast<double>(count) ? static_cast<std::size_t>(bin) : count;
    }
};

/// Returns the bins for a coordinate of a field, in the unit of the coordinate:
///     height          0 to 1, about one bin per grain diameter
///     angle           0 to 180 degrees, 36 bins
///     relative force  0 to 8, 40 bins
///     gap             0 to `rupture_distance`, or 0 to 1 if `rupture_distance` is 0, 30 bins
/// @param grains number of grains in the sample
/// @param rupture_distance gap at which bridges break [grain diameters]
Bins1d bins_of(Coordinate coordinate, int grains, double rupture_distance);

/// Time averages of a field over a run, one for each bin; NaN for a bin without data.
struct BinnedMeans {
    std::vector<double> at;  ///< middle of each bin, in the coordinate's unit
    std::vector<Mean> means;
};

/// Sums over several states of a sample, one element per bin. The value of the field in bin k is
/// sum[k]/weight[k].
struct BinnedSums {
    std::vector<double> sum, weight;

    explicit BinnedSums(std::size_t bins = 0) : sum(bins), weight(bins) {}
    template <typename Archive>
    void serialize(Archive& archive) {
        archive(sum, weight);
    }
};
using FieldSums = std::array<BinnedSums, field_count>;

/// Velocities of the grains as a function of the height in the sample, summed over several states.
/// Reduced units: grain diameter, grain mass and imposed normal stress are 1, so that the shear
/// rate equals the inertial number. `height` is that of the cell.
class MotionProfile {
  public:
    explicit MotionProfile(std::size_t bins = 0) : bins_(bins) {}

    /// Adds the velocities of all grains, without the imposed flow.
    void add(const Grains& grains, double height);
    /// Returns the localization of the shear [1], which is 0 for uniform shear and 1 for an
    /// infinitely thin shear band.
    ///     Delta = 12/(H^3 rate^2) int [v1 - rate x2]^2 dx2
    /// H is the height of the cell, rate the shear rate, and v1 the mean velocity along the flow at
    /// the height x2.
    /// Source: Badetti et al. (2018), Eq. (17).
    double localization(double height, double shear_rate) const;
    /// Returns the profile of the mean velocity along the flow, with the imposed flow, over (shear
    /// rate times height) [1].
    BinnedSums velocity(double height, double shear_rate) const;
    /// Returns the profile of the granular temperature [1]: variance of one velocity component
    /// about the mean in the bin, averaged over the three components, over (grain diameter times
    /// shear rate)^2.
    BinnedSums temperature(double shear_rate) const;

    template <typename Archive>
    void serialize(Archive& archive) {
        archive(bins_);
    }

  private:
    struct Bin {
        double count = 0, squares = 0;
        std::array<double, 3> velocity{};

        template <typename Archive>
        void serialize(Archive& archive) {
            archive(count, squares, velocity);
        }
    };
    std::vector<Bin> bins_;
};

/// Adds the profile of the solid fraction to `sums`. A grain that extends over several bins adds to
/// each the part of its volume that is inside the bin.
void add_solid_fraction(const Grains& grains, const Cell& cell, BinnedSums& sums);

/// Adds the distributions over pairs to `sums`: directions and forces of contacts, and directions
/// and gaps of bridges between grains that do not touch. Profiles are not changed.
/// @param near pairs of the narrow neighbour list, which contains all contacts
/// @param distant pairs outside of `near` that a bridge may join
void add_distributions(const Grains& grains, const Cell& cell, const Pairs& near,
                       const Pairs& distant, const Material& material, const BridgeLaw& bridges,
                       FieldSums& sums);

}  // namespace pendular::dem
