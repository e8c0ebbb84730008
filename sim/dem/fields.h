#pragma once

#include <array>
#include <cstddef>
#include <vector>

#include "sim/dem/bridge_law.h"
#include "sim/dem/cell.h"
#include "sim/dem/contact_law.h"
#include "sim/dem/field.h"
#include "sim/dem/grains.h"
#include "sim/dem/pair_list.h"

namespace pendular::dem {

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
