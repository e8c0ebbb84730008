#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "sim/dem/cell.h"
#include "sim/dem/grains.h"

namespace pendular::dem {

/// Division of a periodic cell into bins, with the grains in each, to search neighbours. The edges
/// of the bins are parallel to the lattice vectors of the cell. Each bin is at least `range` [grain
/// diameters] thick in every direction, so that two grains whose centres are closer than `range`
/// are in one bin or in adjacent bins.
class Bins {
  public:
    Bins(const Grains& grains, const Cell& cell, double range);

    /// Whether the cell has at least three bins along each lattice vector. With fewer bins, a
    /// search through the bins around a grain would visit one bin twice.
    bool enough() const;

    /// Returns the indices, along the three lattice vectors, of the bin that contains a position
    /// [grain diameters] inside the cell; the nearest bin if rounding put the position outside a
    /// face.
    std::array<int, 3> bin_of(const Vector& position) const;
    int count(int direction) const { return count_[direction]; }
    std::size_t index(int b1, int b2, int b3) const {
        return (static_cast<std::size_t>(b3) * count_[1] + b2) * count_[0] + b1;
    }

    struct Entry {
        Vector position;
        std::int32_t grain;
    };
    const Entry* begin(std::size_t bin) const { return entries_.data() + begin_[bin]; }
    const Entry* end(std::size_t bin) const { return entries_.data() + begin_[bin + 1]; }

  private:
    void sort(const Grains& grains);

    const Cell& cell_;
    std::array<int, 3> count_{};
    std::vector<std::size_t> begin_;
    std::vector<Entry> entries_;
};

/// Returns the indices of all grains, sorted into rows along the flow, one mean grain diameter wide
/// and high. Rows are ordered along the velocity gradient, and planes of rows along the vorticity.
/// If grains are numbered in this order, the loop over pairs reads memory nearly in sequence. In
/// contrast to a Morton curve, it can also be prefetched: rows, prefetching and moving grains while
/// they are in the cache (`Section`) together reduced the time of a step of 125,000 grains to 0.6
/// times.
std::vector<std::int32_t> order_in_rows(const Grains& grains, const Cell& cell);

}  // namespace pendular::dem
