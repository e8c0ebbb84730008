#pragma once

namespace pendular::dem {

/// Lengths and masses of a pair of grains on which contact forces and bridge forces depend [1].
/// Diameters are divided by the mean grain diameter, masses by the mass of a grain of mean
/// diameter.
struct PairSizes {
    /// Distance between the centres at which the two grains touch [1]: (d1 + d2)/2, with the grain
    /// diameters d1 and d2 divided by the mean diameter of all grains.
    double contact_distance = 1;
    /// Harmonic mean 2 d1 d2/(d1 + d2) of the two grain diameters [1], for the laws of contact and
    /// bridge. The grain diameters d1 and d2 are divided by the mean diameter of all grains.
    double diameter = 1;
    /// Harmonic mean 2 m1 m2/(m1 + m2) of the two grain masses [1], for the viscous force. The
    /// grain masses m1 and m2 are divided by the mass of a grain of mean diameter.
    double mass = 1;
    /// Distance from the centre of the second grain to the contact point, divided by half the
    /// distance between the centres [1].
    double second_arm = 1;

    /// Returns contact distance, mean diameter, mean mass and lever arm of a pair of grains.
    /// @param first diameter of the first grain divided by the mean grain diameter [1]
    /// @param second diameter of the second grain divided by the mean grain diameter [1]
    [[gnu::always_inline]] static PairSizes of(double first, double second) {
        const double first_mass = first * first * first, second_mass = second * second * second;
        const double contact_distance = 0.5 * (first + second);
        return {contact_distance, 2 * first * second / (first + second),
                2 * first_mass * second_mass / (first_mass + second_mass),
                second / contact_distance};
    }
    /// Returns the distance from the centre of the first grain to the contact point, divided by
    /// half the distance between the centres [1].
    double first_arm() const { return 2 - second_arm; }
};

}  // namespace pendular::dem
