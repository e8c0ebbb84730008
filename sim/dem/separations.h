#pragma once

#include <cmath>
#include <cstddef>

#include "sim/dem/cell.h"
#include "sim/dem/grains.h"
#include "sim/dem/pair_contact.h"
#include "sim/dem/pair_list.h"

namespace pendular::dem {

/// Calls visit(k, r) for each pair k of a neighbour list, except placeholder pairs. r points from
/// the first centre to the periodic image of the second [grain diameters].
template <typename Visit>
void for_each_pair(const Grains& grains, const Cell& cell, const Pairs& pairs, const Visit& visit) {
    for (std::size_t k = 0; k < pairs.size(); ++k) {
        if (pairs.image[k] == image_code::nowhere) {
            continue;
        }
        const auto i = static_cast<std::size_t>(pairs.first[k]),
                   j = static_cast<std::size_t>(pairs.second[k]);
        visit(k, grains.position(j) - grains.position(i) +
                     image_code::image(pairs.image[k]).shift(cell));
    }
}

/// Returns the Hertz contact of pair number k from the overlap in the last time step, in reduced
/// units (grain diameter, grain mass and imposed normal stress are 1); zero without contact.
/// @param modulus `Material::modulus`
inline Hertz contact_of(const Grains& grains, const Pairs& pairs, std::size_t k, double modulus) {
    const PairSizes sizes = grains.sizes(static_cast<std::size_t>(pairs.first[k]),
                                         static_cast<std::size_t>(pairs.second[k]));
    return hertz_contact(pairs.root[k] * pairs.root[k], sizes, modulus);
}

/// Returns the gap between the surfaces of pair number k [grain diameters]; negative for an
/// overlap.
/// @param r vector from the first to the second centre [grain diameters]
inline double gap_of(const Grains& grains, const Pairs& pairs, std::size_t k, const Vector& r) {
    return std::sqrt(dot(r, r)) -
           grains.contact_distance(static_cast<std::size_t>(pairs.first[k]),
                                   static_cast<std::size_t>(pairs.second[k]));
}

}  // namespace pendular::dem
