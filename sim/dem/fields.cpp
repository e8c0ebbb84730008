#include "sim/dem/fields.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "sim/dem/separations.h"
#include "sim/dem/shear_cell.h"

namespace pendular::dem {
namespace {

/// Chosen: bins of 5 degrees, and of a fifth of the mean force up to eight times the mean force. A
/// run of the usual length fills them with many pairs each.
constexpr std::size_t angle_bins = 36, force_bins = 40, gap_bins = 30;
constexpr double largest_relative_force = 8;
constexpr double degrees_per_radian = 180 / std::numbers::pi;

BinnedSums& of(FieldSums& sums, Field which) {
    return sums[static_cast<std::size_t>(which)];
}

/// Adds the values of a quantity in one state to its probability density. `width` is the width of a
/// bin in the unit of the density.
void add_density(const std::vector<double>& values, const Bins1d& bins, double width,
                 BinnedSums& sums) {
    for (const double value : values) {
        const std::size_t bin = bins.of(value);
        if (bin < bins.count) {
            sums.sum[bin] += 1;
        }
    }
    for (double& weight : sums.weight) {
        weight += static_cast<double>(values.size()) * width;
    }
}

/// Angle of a pair's direction in the plane of flow and gradient, in [0, 180) degrees, as opposite
/// directions are equivalent.
double angle_of(const Vector& r) {
    const double angle = std::atan2(r[1], r[0]) * degrees_per_radian;
    const double half_turn = angle < 0 ? angle + 180 : angle;
    return half_turn < 180 ? half_turn : 0;
}

/// Volume of the part of a sphere below a horizontal plane, `plane` above its centre [a^3].
double volume_below(double plane, double diameter) {
    const double depth = std::clamp(plane / diameter + 0.5, 0.0, 1.0);
    return diameter * diameter * diameter * std::numbers::pi * depth * depth * (0.5 - depth / 3);
}

}  // namespace

Bins1d bins_of(Coordinate coordinate, int grains, double rupture_distance) {
    switch (coordinate) {
        case Coordinate::height:
            return {static_cast<std::size_t>(std::lround(ShearCell::edge(grains))), 1};
        case Coordinate::angle:
            return {angle_bins, 180};
        case Coordinate::relative_force:
            return {force_bins, largest_relative_force};
        case Coordinate::gap:
            break;
    }
    return {gap_bins, rupture_distance > 0 ? rupture_distance : 1};
}

void MotionProfile::add(const Grains& grains, double height) {
    const Bins1d bins{bins_.size(), 1};
    for (std::size_t i = 0; i < grains.size(); ++i) {
        const double place = grains.position(i)[1] / height;
        Bin& bin = bins_[std::min(bins.of(place - std::floor(place)), bins_.size() - 1)];
        const Vector& v = grains.velocity(i);
        bin.count += 1;
        bin.squares += dot(v, v);
        for (std::size_t d = 0; d < 3; ++d) {
            bin.velocity[d] += v[d];
        }
    }
}

double MotionProfile::localization(double height, double shear_rate) const {
    const double across = height * shear_rate;
    double sum = 0;
    for (const Bin& bin : bins_) {
        const double mean = bin.count > 0 ? bin.velocity[0] / bin.count : 0.0;
        sum += mean * mean;
    }
    return bins_.empty() ? 0 : 12 * sum / (static_cast<double>(bins_.size()) * across * across);
}

BinnedSums MotionProfile::velocity(double height, double shear_rate) const {
    const Bins1d bins{bins_.size(), 1};
    BinnedSums sums(bins.count);
    for (std::size_t k = 0; k < bins.count; ++k) {
        sums.weight[k] = bins_[k].count;
        sums.sum[k] =
            bins_[k].count * bins.middle(k) + bins_[k].velocity[0] / (shear_rate * height);
    }
    return sums;
}

BinnedSums MotionProfile::temperature(double shear_rate) const {
    BinnedSums sums(bins_.size());
    for (std::size_t k = 0; k < bins_.size(); ++k) {
        const Bin& bin = bins_[k];
        double of_mean = 0;
        for (const double sum : bin.velocity) {
            of_mean += bin.count > 0 ? sum * sum / bin.count : 0.0;
        }
        sums.weight[k] = bin.count;
        sums.sum[k] = (bin.squares - of_mean) / (3 * shear_rate * shear_rate);
    }
    return sums;
}

void add_solid_fraction(const Grains& grains, const Cell& cell, BinnedSums& sums) {
    const auto count = static_cast<long>(sums.sum.size());
    const double thickness = cell.height / static_cast<double>(count);
    for (std::size_t i = 0; i < grains.size(); ++i) {
        const double centre = grains.position(i)[1], diameter = grains.diameter(i);
        const auto first = static_cast<long>(std::floor((centre - 0.5 * diameter) / thickness));
        double below = 0;
        for (long slice = first; below < volume_below(0.5 * diameter, diameter); ++slice) {
            const double up_to =
                volume_below(static_cast<double>(slice + 1) * thickness - centre, diameter);
            const long bin = (slice % count + count) % count;  // periodic continuation
            sums.sum[static_cast<std::size_t>(bin)] += up_to - below;
            below = up_to;
        }
    }
    for (double& weight : sums.weight) {
        weight += cell.volume() / static_cast<double>(count);
    }
}

void add_distributions(const Grains& grains, const Cell& cell, const Pairs& near,
                       const Pairs& distant, const Material& material, const BridgeLaw& bridges,
                       FieldSums& sums) {
    std::vector<double> forces, angles, distant_angles, gaps;
    const auto note_distant = [&](const Pairs& pairs, std::size_t k, const Vector& r) {
        distant_angles.push_back(angle_of(r));
        // One step after the force was computed, a gap may slightly exceed the rupture distance.
        gaps.push_back(
            std::clamp(gap_of(grains, pairs, k, r), 0.0, bridges.rupture_distance * (1 - 1e-12)));
    };
    for_each_pair(grains, cell, near, [&](std::size_t k, const Vector& r) {
        if (near.root[k] > 0) {
            angles.push_back(angle_of(r));
            forces.push_back(contact_of(grains, near, k, material.modulus).elastic);
        } else if (near.bridge[k] > 0) {
            note_distant(near, k, r);
        }
    });
    for_each_pair(grains, cell, distant, [&](std::size_t k, const Vector& r) {
        if (distant.bridge[k] > 0) {
            note_distant(distant, k, r);
        }
    });

    const Bins1d by_angle{angle_bins, 180}, by_force{force_bins, largest_relative_force};
    const double radians = by_angle.width() / degrees_per_radian;
    double total = 0;
    BinnedSums& by_orientation = of(sums, Field::contact_force_by_orientation);
    for (std::size_t k = 0; k < forces.size(); ++k) {
        by_orientation.sum[by_angle.of(angles[k])] += forces[k];
        by_orientation.weight[by_angle.of(angles[k])] += 1;
        total += forces[k];
    }
    for (double& force : forces) {
        force *= static_cast<double>(forces.size()) / total;
    }
    add_density(angles, by_angle, radians, of(sums, Field::contact_orientation));
    add_density(forces, by_force, by_force.width(), of(sums, Field::contact_force));
    if (bridges.wet()) {
        const Bins1d by_gap{gap_bins, bridges.rupture_distance};
        add_density(distant_angles, by_angle, radians, of(sums, Field::distant_orientation));
        add_density(gaps, by_gap, by_gap.width(), of(sums, Field::distant_gap));
    }
}

}  // namespace pendular::dem
