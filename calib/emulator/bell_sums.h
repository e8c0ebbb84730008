#pragma once

#include <array>
#include <cstddef>
#include <vector>

namespace pendular {

/// Weighted places z_i, for fast sums of Gaussian bells about them. With the differences
/// d_i = z_i - a to a place a and inverse squares of lengths c_k, the sums are
///     S = sum_i w_i exp(-sum_k c_k d_ik^2/2)  and  S_k = sum_i w_i d_ik exp(-sum_k c_k d_ik^2/2).
/// All instruction sets give the same bits.
class BellSums {
  public:
    static constexpr std::size_t most_coordinates = 5;
    using Place = std::array<double, most_coordinates>;

    /// @param coordinates number of coordinates that count, 2, 4 or 5; further entries of places
    ///        are ignored
    /// @param inverse_squares inverse squares c_k of the lengths
    BellSums(std::size_t coordinates, const Place& inverse_squares)
        : coordinates_(coordinates), inverse_squares_(inverse_squares) {}

    /// Adds a place with its weight; a place of weight 0 changes no sum and is not stored.
    void add(const Place& place, double weight);

    /// Returns S, then S_k of each coordinate (0 where the coordinate is ignored), at the place
    /// `at`.
    std::array<double, 1 + most_coordinates> at(const Place& at) const;

  private:
    std::size_t coordinates_;
    Place inverse_squares_;
    std::size_t count_ = 0;
    /// Blocks of places, as many as a vector register has lanes: for each block the first
    /// coordinate of all its places, ..., the last, then the weights (0 beyond the last place).
    std::vector<double> blocks_;
};

}  // namespace pendular
