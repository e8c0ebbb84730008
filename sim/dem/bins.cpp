#include "sim/dem/bins.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <tuple>

namespace pendular::dem {
namespace {

/// Width and height of the rows in which grains are numbered [diameters].
constexpr double row_width = 1;

}  // namespace

Bins::Bins(const Grains& grains, const Cell& cell, double range) : cell_(cell) {
    // Along direction 1 a bin is thinner than its edge, by the cosine of the lattice's tilt.
    const double cosine = cell.height / std::hypot(cell.height, cell.offset);
    count_ = {static_cast<int>(cell.length * cosine / range), static_cast<int>(cell.height / range),
              static_cast<int>(cell.width / range)};
    if (enough()) {
        sort(grains);
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

void Bins::sort(const Grains& grains) {
    std::vector<std::uint32_t> bin(grains.size());
    begin_.assign(static_cast<std::size_t>(count_[0]) * count_[1] * count_[2] + 1, 0);
    for (std::size_t i = 0; i < grains.size(); ++i) {
        const auto b = bin_of(grains.position(i));
        bin[i] = static_cast<std::uint32_t>(index(b[0], b[1], b[2]));
        ++begin_[bin[i] + 1];
    }
    std::partial_sum(begin_.begin(), begin_.end(), begin_.begin());
    entries_.resize(grains.size());
    auto next = begin_;
    for (std::size_t i = 0; i < grains.size(); ++i) {
        entries_[next[bin[i]]++] = {grains.position(i), static_cast<std::int32_t>(i)};
    }
}

std::vector<std::int32_t> order_in_rows(const Grains& grains, const Cell& cell) {
    std::vector<std::tuple<int, int, double>> place(grains.size());
    for (std::size_t i = 0; i < grains.size(); ++i) {
        const Vector r = cell.wrapped(grains.position(i));
        place[i] = {static_cast<int>(r[2] / row_width), static_cast<int>(r[1] / row_width),
                    r[0] - r[1] / cell.height * cell.offset};
    }
    std::vector<std::int32_t> order(grains.size());
    std::iota(order.begin(), order.end(), 0);
    std::ranges::stable_sort(order, {}, [&](std::int32_t i) { return place[i]; });
    return order;
}

}  // namespace pendular::dem
