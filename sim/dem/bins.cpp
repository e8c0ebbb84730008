#include "sim/dem/bins.h"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace pendular::dem {
namespace {

constexpr double curve_bin = 2;

/// The low 21 bits of a number, two zeros after each.
std::uint64_t spread(std::uint64_t bits) {
    bits &= 0x1fffff;
    bits = (bits | bits << 32) & 0x1f00000000ffff;
    bits = (bits | bits << 16) & 0x1f0000ff0000ff;
    bits = (bits | bits << 8) & 0x100f00f00f00f00f;
    bits = (bits | bits << 4) & 0x10c30c30c30c30c3;
    return (bits | bits << 2) & 0x1249249249249249;
}

}  // namespace

Bins::Bins(const Beads& beads, const Cell& cell, double range) : cell_(cell) {
    // A bin is thinner than its edge along direction 1 by the cosine of the lattice's tilt.
    const double cosine = cell.height / std::hypot(cell.height, cell.offset);
    count_ = {static_cast<int>(cell.length * cosine / range), static_cast<int>(cell.height / range),
              static_cast<int>(cell.width / range)};
    if (enough()) {
        sort(beads);
    }
}

bool Bins::enough() const {
    return std::ranges::all_of(count_, [](int n) { return n >= 3; });
}

std::array<int, 3> Bins::bin_of(const Vector& position) const {
    const Vector at = cell_.fractions(position);
    std::array<int, 3> bin;
    for (std::size_t d = 0; d < 3; ++d) {
        bin[d] = std::clamp(static_cast<int>(std::floor(at[d] * count_[d])), 0, count_[d] - 1);
    }
    return bin;
}

void Bins::sort(const Beads& beads) {
    std::vector<std::uint32_t> bin(beads.size());
    begin_.assign(static_cast<std::size_t>(count_[0]) * count_[1] * count_[2] + 1, 0);
    for (std::size_t i = 0; i < beads.size(); ++i) {
        const auto b = bin_of(beads.position(i));
        bin[i] = static_cast<std::uint32_t>(index(b[0], b[1], b[2]));
        ++begin_[bin[i] + 1];
    }
    std::partial_sum(begin_.begin(), begin_.end(), begin_.begin());
    entries_.resize(beads.size());
    auto next = begin_;
    for (std::size_t i = 0; i < beads.size(); ++i) {
        entries_[next[bin[i]]++] = {beads.position(i), static_cast<std::int32_t>(i)};
    }
}

std::vector<std::int32_t> order_along_curve(const Beads& beads, const Cell& cell) {
    std::vector<std::uint64_t> place(beads.size());
    for (std::size_t i = 0; i < beads.size(); ++i) {
        const Vector r = cell.wrapped(beads.position(i));
        const auto bin = [&](double x) { return static_cast<std::uint64_t>(x / curve_bin); };
        place[i] = spread(bin(std::max(0.0, r[0] - r[1] / cell.height * cell.offset))) |
                   spread(bin(r[1])) << 1 | spread(bin(r[2])) << 2;
    }
    std::vector<std::int32_t> order(beads.size());
    std::iota(order.begin(), order.end(), 0);
    std::ranges::stable_sort(order, {}, [&](std::int32_t i) { return place[i]; });
    return order;
}

}  // namespace pendular::dem
