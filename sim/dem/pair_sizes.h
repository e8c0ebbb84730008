#pragma once

namespace pendular::dem {

/// Lengths and masses of a pair of grains on which contact forces and bridge forces depend:
/// diameters d1, d2 over the mean grain diameter, masses m1, m2 over the mass of a grain of mean
/// diameter [1].
struct PairSizes {
    double contact_distance = 1;  ///< (d1 + d2)/2
    double diameter = 1;          ///< harmonic mean 2 d1 d2/(d1 + d2), for contact and bridge
    double mass = 1;              ///< harmonic mean 2 m1 m2/(m1 + m2), for the viscous force
    /// Distance from the second centre to the contact point, over half the distance of the centres.
    double second_arm = 1;

    /// Returns the sizes of a pair of grains of the diameters `first` and `second`.
    [[gnu::always_inline]] static PairSizes of(double first, double second) {
        const double first_mass = first * first * first, second_mass = second * second * second;
        const double contact_distance = 0.5 * (first + second);
        return {contact_distance, 2 * first * second / (first + second),
                2 * first_mass * second_mass / (first_mass + second_mass),
                second / contact_distance};
    }
    /// Returns the distance from the first centre, in the same unit as `second_arm`.
    double first_arm() const { return 2 - second_arm; }
};

}  // namespace pendular::dem
