#pragma once

#include <cstddef>
#include <vector>

#include "sim/dem/pair_list.h"

namespace pendular::dem {

/// Flow of liquid between the bridges of a sample, through the films on the grains. Each bridge k
/// between grains i and j relaxes towards the mean volumes m_i and m_j of the bridges on its
/// grains,
///     dV_k/d(strain) = rate [(m_i + m_j)/2 - V_k],
/// which keeps the volume of all bridges together (but for rounding) and the order of no two
/// bridges.
class LiquidExchange {
  public:
    /// Lets liquid flow during one time step.
    /// @param pairs neighbour lists; the volumes of their bridges change
    /// @param volume index of the value of the contact history that is the volume of a bridge over
    ///        the mean volume V0 of a bridge as it forms, with any sign
    /// @param grains number of grains
    /// @param strain rate [1 per unit of shear strain] times the shear strain of the step [1]
    void flow(PairList& pairs, std::size_t volume, std::size_t grains, double strain);

  private:
    /// For each grain: sum of the volumes of its bridges over V0, and their number.
    std::vector<double> volumes_, counts_;
};

}  // namespace pendular::dem
