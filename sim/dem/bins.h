#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "sim/dem/cell.h"
#include "sim/dem/grains.h"

namespace pendular::dem {

/// Grains sorted into bins that are sheared with the lattice, each wider than a range in every
/// direction.
class Bins {
  public:
    Bins(const Grains& grains, const Cell& cell, double range);

    /// Whether every direction has at least three bins; with fewer, a neighbour bin would be
    /// searched twice.
    bool enough() const;

    /// Bin of a grain inside the cell. A grain that rounding puts outside is counted in the last
    /// bin before that face, not in the bin on the opposite side.
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

/// The grains' numbers in rows along the flow, one diameter wide, row by row and plane by plane.
/// The neighbours of successive grains then lie in a few places that advance through memory side by
/// side, which is what a processor fetches ahead by itself: samples larger than its cache run a
/// third faster than along a Morton curve.
std::vector<std::int32_t> order_in_rows(const Grains& grains, const Cell& cell);

}  // namespace pendular::dem
