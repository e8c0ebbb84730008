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

/// Coordinate that a field depends on; `coordinates` has their names, units and meanings.
enum class Coordinate { height, angle, relative_force, gap };

/// Quantity that a run measures as a function of one coordinate; `fields` has their names, units
/// and meanings.
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
    std::string_view name;     ///< JSON and CSV header
    std::string_view unit;     ///< "1": dimensionless
    std::string_view meaning;  ///< one line
    std::string_view table;    ///< name of the CSV file that its fields share
};
constexpr std::array coordinates = std::to_array<CoordinateAbout>(
    {{"height", "1", "place across the velocity gradient over the sample's height", "profiles"},
     {"angle", "degree",
      "angle of a pair's normal in the plane of flow and gradient, from the flow towards the "
      "gradient",
      "orientations"},
     {"relative_force", "1", "elastic normal force of a contact over the mean of all contacts",
      "contact_forces"},
     {"gap", "1", "gap of a bridge without contact over the bead diameter", "gaps"}});

struct FieldAbout {
    std::string_view name;  ///< JSON key and CSV header
    Coordinate coordinate;
    std::string_view unit;     ///< "1": dimensionless
    std::string_view meaning;  ///< one line, with what it is divided by
    bool needs_bridges = false;
};
constexpr std::array fields = std::to_array<FieldAbout>(
    {{"velocity", Coordinate::height, "1", "velocity along the flow over shear rate times height"},
     {"solid_fraction", Coordinate::height, "1",
      "volume of the beads' slices within the bin over the bin's"},
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
/// Whether a field is a profile across the gradient; the others are distributions over pairs.
constexpr bool is_profile(Field which) {
    return about(which).coordinate == Coordinate::height;
}

/// Equal bins from zero on.
struct Bins1d {
    std::size_t count = 0;
    double end = 1;

    double width() const { return end / static_cast<double>(count); }
    double middle(std::size_t bin) const { return (static_cast<double>(bin) + 0.5) * width(); }
    /// Bin of a value; `count` beyond the last.
    std::size_t of(double value) const {
        const double bin = value < 0 ? 0 : value / width();
        return bin < static_cast<double>(count) ? static_cast<std::size_t>(bin) : count;
    }
};

/// Bins of a coordinate in a sample of so many grains: one per grain diameter across the gradient,
/// of 5 degrees over half a turn, of a fifth of the mean force up to 8 times it, 30 up to the
/// rupture distance [the coordinate's unit].
Bins1d bins_of(Coordinate coordinate, int grains, double rupture_distance);

/// One field of a run: a time average with standard error in the middle of each bin. A mean over
/// nothing is not a number.
struct BinnedMeans {
    std::vector<double> at;  ///< in the coordinate's unit
    std::vector<Mean> means;
};

/// Sums from which a field is made: its value in a bin is sum over weight.
struct BinnedSums {
    std::vector<double> sum, weight;

    explicit BinnedSums(std::size_t bins = 0) : sum(bins), weight(bins) {}
    template <typename Archive>
    void serialize(Archive& archive) {
        archive(sum, weight);
    }
};
using FieldSums = std::array<BinnedSums, field_count>;

/// Velocities across the gradient, summed over several instants.
class MotionProfile {
  public:
    explicit MotionProfile(std::size_t bins = 0) : bins_(bins) {}

    /// Adds the velocities of one state relative to the imposed flow.
    void add(const Grains& grains, double height);
    /// Localization [1]: 0 uniform shear, 1 an infinitely thin band.
    ///     Delta = 12/(H^3 rate^2) int [v1 - rate x2]^2 dx2
    /// Source: Badetti et al. (2018), eq:defdelta.
    double localization(double height, double shear_rate) const;
    /// Mean velocity in each bin, over shear rate times height [1].
    BinnedSums velocity(double height, double shear_rate) const;
    /// Variance of the velocities in each bin, over (diameter times shear rate)^2 [1].
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

/// Adds the solid fraction across the gradient of one state: each sphere is cut at the bins' faces.
void add_solid_fraction(const Grains& grains, const Cell& cell, BinnedSums& sums);

/// Adds the distributions over the contacts and the bridges without contact of one state.
void add_distributions(const Grains& grains, const Cell& cell, const Pairs& near,
                       const Pairs& distant, const Material& material, const BridgeLaw& bridges,
                       FieldSums& sums);

}  // namespace pendular::dem
