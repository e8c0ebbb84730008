#pragma once

namespace pendular::dem {

/// Sizes of a pair of grains, over the mean diameter a and the mass of a grain of that diameter.
struct PairSizes {
    double contact_distance = 1;  ///< (d1 + d2)/2: distance of the centres at which they touch
    double diameter = 1;  ///< 2 d1 d2/(d1 + d2), which enters the laws of contact and bridge
    double mass = 1;      ///< 2 m1 m2/(m1 + m2), which enters the viscous force
    /// Distance from the second centre to the contact point, over half the distance of the centres.
    double second_arm = 1;

    /// Sizes of a pair from the diameters of its grains over a.
    [[gnu::always_inline]] static PairSizes of(double first, double second) {
        const double first_mass = first * first * first, second_mass = second * second * second;
        const double contact_distance = 0.5 * (first + second);
        return {contact_distance, 2 * first * second / (first + second),
                2 * first_mass * second_mass / (first_mass + second_mass),
                second / contact_distance};
    }
    /// Distance from the first centre to the contact point, over half the distance of the centres
    /// [1].
    double first_arm() const { return 2 - second_arm; }
};

}  // namespace pendular::dem
