#pragma once

#include <array>
#include <cstddef>
#include <vector>

namespace pendular {

/// Fast sums of weighted Gaussian functions (bells) in up to five coordinates. Predictions of a
/// Gaussian process contain such sums. Bell i has the centre z_i and the weight w_i. All bells have
/// equal widths, with the standard deviation 1/sqrt(c_k) along coordinate k. With the distances
/// d_ik = z_ik - a_k of the centres from a place a, the sums at the place a are
///     S = sum_i w_i exp(-sum_k c_k d_ik^2/2)  and  S_k = sum_i w_i d_ik exp(-sum_k c_k d_ik^2/2).
/// The sums are identical to the last bit on all processors, whatever their vector instructions.
class BellSums {
  public:
    static constexpr std::size_t most_coordinates = 5;
    using Place = std::array<double, most_coordinates>;

    /// @param coordinates number of coordinates of a place: 2, 4 or 5; further entries of a `Place`
    ///        are ignored
    /// @param inverse_squares inverse squares c_k of the widths (standard deviations) of the bells,
    ///        one for each coordinate
    BellSums(std::size_t coordinates, const Place& inverse_squares)
        : coordinates_(coordinates), inverse_squares_(inverse_squares) {}

    /// Adds a bell with the centre `place` and the weight `weight`. A bell of weight 0 changes no
    /// sum and is not stored.
    void add(const Place& place, double weight);

    /// Returns the sums over all bells at the place `at`: first S = sum_i w_i E_i, then S_k = sum_i
    /// w_i d_ik E_i for each coordinate k. Here w_i is the weight of bell i, d_ik is the distance
    /// of the centre of the bell from the place along coordinate k, and E_i is the value of the
    /// bell at the place, which is 1 at the centre. S_k is 0 for coordinates that are not used.
    std::array<double, 1 + most_coordinates> at(const Place& at) const;

  private:
    std::size_t coordinates_;
    Place inverse_squares_;
    std::size_t count_ = 0;
    /// Centres and weights of the bells, in blocks of eight bells, one bell for each lane of a
    /// vector register. A block contains the first coordinates of its eight bells, then the second
    /// coordinates, and so on, then the weights. Unused lanes of the last block have the weight 0.
    std::vector<double> blocks_;
};

}  // namespace pendular
