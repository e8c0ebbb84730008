#pragma once

#include <cstddef>

#include "sim/dem/beads.h"
#include "sim/dem/cell.h"
#include "sim/dem/pair_list.h"

namespace pendular::dem {

/// Calls visit(pair, r) for each pair of a list that is real, r leading from the centre of its
/// first bead to the image of its second [diameters].
template <typename Visit>
void for_each_pair(const Beads& beads, const Cell& cell, const Pairs& pairs, const Visit& visit) {
    for (std::size_t k = 0; k < pairs.size(); ++k) {
        if (pairs.image[k] == image_code::nowhere) {
            continue;
        }
        const auto i = static_cast<std::size_t>(pairs.first[k]),
                   j = static_cast<std::size_t>(pairs.second[k]);
        visit(k, beads.position(j) - beads.position(i) +
                     image_code::image(pairs.image[k]).shift(cell));
    }
}

}  // namespace pendular::dem
