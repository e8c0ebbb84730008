#pragma once

#include <cstddef>
#include <vector>

#include "sim/dem/pair_list.h"

namespace pendular::dem {

/// Flow of liquid between the bridges of a sample, through the films on the grains. The volume V_k
/// of a bridge k between grains i and j relaxes towards the mean volumes m_i and m_j of the bridges
/// on its two grains:
///     dV_k/d(strain) = rate [(m_i + m_j)/2 - V_k]
/// The sum of the volumes of all bridges stays constant, except for rounding. The order of bridges
/// by volume may change.
class LiquidExchange {
  public:
    /// Lets liquid flow during one time step.
    /// @param pairs neighbour lists; the volumes of their bridges change
    /// @param volume index, among the values of the contact history, of the volume of a bridge
    ///         divided by the mean volume V0 of newly formed bridges, with any sign
    /// @param grains number of grains
    /// @param strain rate [1 per unit of shear strain] times the shear strain of the step [1]
    void flow(PairList& pairs, std::size_t volume, std::size_t grains, double strain);

  private:
    /// For each grain: sum of the volumes of its bridges divided by V0 (mean volume of newly formed
    /// bridges), and number of its bridges.
    std::vector<double> volumes_, counts_;
};

}  // namespace pendular::dem
