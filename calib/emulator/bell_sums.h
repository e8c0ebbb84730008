#pragma once

#include <array>
#include <cstddef>
#include <vector>

namespace pendular {

/// Fast sums of weighted Gaussian functions (bells) in up to five coordinates, as in predictions of
/// a Gaussian process. Bell i has the centre z_i and the weight w_i. All bells have the standard
/// deviation 1/sqrt(c_k) along coordinate k. The sums at a point with the coordinates a_k are
///     S = sum_i w_i E_i  and  S_k = sum_i w_i d_ik E_i,
///     E_i = exp(-sum_k c_k d_ik^2/2),  d_ik = z_ik - a_k.
/// The sums are identical to the last bit on all processors.
class BellSums {
  public:
    static constexpr std::size_t most_coordinates = 5;  ///< those of `ResponsePlace`, the most
    using Place = std::array<double, most_coordinates>;

    /// @param coordinates number of coordinates of a point: 2, 4 or 5; further entries of a `Place`
    ///        are ignored
    /// @param inverse_squares c_k
    BellSums(std::size_t coordinates, const Place& inverse_squares)
        : coordinates_(coordinates), inverse_squares_(inverse_squares) {}

    /// Adds a bell. A bell of weight 0 changes no sum and is not stored.
    void add(const Place& place, double weight);

    /// Returns S, then S_k for each coordinate k (0 for unused ones), at the point `at`.
    std::array<double, 1 + most_coordinates> at(const Place& at) const;

  private:
    std::size_t coordinates_;
    Place inverse_squares_;
    std::size_t count_ = 0;
    /// Bells in blocks of eight, one bell for each lane of a vector register. A block contains the
    /// first coordinates of its eight bells, then the second coordinates, and so on, then the
    /// weights. Unused lanes of the last block have the weight 0.
    std::vector<double> blocks_;
};

}  // namespace pendular
