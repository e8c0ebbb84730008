#pragma once

#include <cstddef>
#include <vector>

#include "sim/dem/pair_list.h"

namespace pendular::dem {

/// Flow of liquid between the bridges of a sample, through the liquid films on the grains. The
/// volume V_k of the bridge k between grains i and j changes with the shear strain:
///     dV_k/d(strain) = rate [(m_i + m_j)/2 - V_k]
/// m_i and m_j are the mean volumes of the bridges on grain i and on grain j, and rate is a
/// constant [1 per unit of shear strain]. The total volume stays constant, except for rounding.
class LiquidExchange {
  public:
    /// Changes the volumes of the bridges in the neighbour lists by the flow of one time step.
    /// @param volume index of the bridge volume in the contact history, whose sign is ignored
    /// @param grains number of grains
    /// @param strain rate of the exchange times the shear strain of the time step [1]
    void flow(PairList& pairs, std::size_t volume, std::size_t grains, double strain);

  private:
    /// For each grain, sum of the volumes of its bridges, over V0, and their number.
    std::vector<double> volumes_, counts_;
};

}  // namespace pendular::dem
