#include "sim/dem/pair_laws.h"

#include <algorithm>

namespace pendular::dem {

PairEnergy& PairEnergy::operator+=(const PairEnergy& other) {
    elastic += other.elastic, capillary += other.capillary, friction += other.friction;
    viscosity += other.viscosity, bridges += other.bridges, unloading += other.unloading;
    return *this;
}

PairSums& PairSums::operator+=(const PairSums& other) {
    virial_11 += other.virial_11, virial_22 += other.virial_22;
    virial_33 += other.virial_33, virial_12 += other.virial_12;
    largest_overlap = std::max(largest_overlap, other.largest_overlap);
    energy += other.energy;
    return *this;
}

}  // namespace pendular::dem
