#include "sim/dem/pair_list.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>

namespace pendular::dem {
namespace {

struct Separation {
    double x, y, z;
    double squared() const { return x * x + y * y + z * z; }
};

Separation separation(const Beads& beads, const Cell& cell, std::size_t i, std::size_t j,
                      Image image) {
    return {beads.x[j] - beads.x[i] + image.n1 * cell.length + image.n2 * cell.offset,
            beads.y[j] - beads.y[i] + image.n2 * cell.height,
            beads.z[j] - beads.z[i] + image.n3 * cell.width};
}

/// Image of j nearest to i in a sheared cell whose offset is reduced.
Image nearest_image(const Beads& beads, const Cell& cell, std::size_t i, std::size_t j) {
    const int n2 = -static_cast<int>(std::lround((beads.y[j] - beads.y[i]) / cell.height));
    const double x = beads.x[j] - beads.x[i] + n2 * cell.offset;
    return {-static_cast<int>(std::lround(x / cell.length)), n2,
            -static_cast<int>(std::lround((beads.z[j] - beads.z[i]) / cell.width))};
}

/// Bins sheared with the lattice, each wider than the range in every direction.
class Bins {
  public:
    Bins(const Beads& beads, const Cell& cell, double range) : cell_(cell) {
        // A bin is thinner than its edge along direction 1 by the cosine of the lattice's tilt.
        const double cosine = cell.height / std::hypot(cell.height, cell.offset);
        count_ = {static_cast<int>(cell.length * cosine / range),
                  static_cast<int>(cell.height / range), static_cast<int>(cell.width / range)};
        if (enough()) {
            sort(beads);
        }
    }
    /// With fewer than three bins in a direction a neighbour bin would be searched twice.
    bool enough() const {
        return std::ranges::all_of(count_, [](int n) { return n >= 3; });
    }

    std::array<int, 3> bin_of(double x, double y, double z) const {
        const double upward = y / cell_.height;
        return {place((x - upward * cell_.offset) / cell_.length, count_[0]),
                place(upward, count_[1]), place(z / cell_.width, count_[2])};
    }
    int count(int direction) const { return count_[direction]; }
    std::size_t index(int b1, int b2, int b3) const {
        return (static_cast<std::size_t>(b3) * count_[1] + b2) * count_[0] + b1;
    }
    const std::int32_t* begin(std::size_t bin) const { return beads_.data() + begin_[bin]; }
    const std::int32_t* end(std::size_t bin) const { return beads_.data() + begin_[bin + 1]; }

  private:
    /// Bin of a fractional coordinate; rounding may put it a whole turn outside.
    static int place(double fraction, int bins) {
        const int bin = static_cast<int>(std::floor((fraction - std::floor(fraction)) * bins));
        return std::clamp(bin, 0, bins - 1);
    }
    void sort(const Beads& beads) {
        std::vector<std::size_t> bin(beads.size());
        begin_.assign(static_cast<std::size_t>(count_[0]) * count_[1] * count_[2] + 1, 0);
        for (std::size_t i = 0; i < beads.size(); ++i) {
            const auto b = bin_of(beads.x[i], beads.y[i], beads.z[i]);
            bin[i] = index(b[0], b[1], b[2]);
            ++begin_[bin[i] + 1];
        }
        std::partial_sum(begin_.begin(), begin_.end(), begin_.begin());
        beads_.resize(beads.size());
        auto next = begin_;
        for (std::size_t i = 0; i < beads.size(); ++i) {
            beads_[next[bin[i]]++] = static_cast<std::int32_t>(i);
        }
    }

    const Cell& cell_;
    std::array<int, 3> count_{};
    std::vector<std::size_t> begin_;
    std::vector<std::int32_t> beads_;
};

struct Neighbour {
    std::int32_t bead;
    std::uint8_t image;
};

/// Beads with a higher number than i within the range, from the 27 bins around it.
void neighbours_of(std::size_t i, const Beads& beads, const Cell& cell, const Bins& bins,
                   double range_squared, std::vector<Neighbour>& found) {
    const auto home = bins.bin_of(beads.x[i], beads.y[i], beads.z[i]);
    for (int step = 0; step < 27; ++step) {
        const std::array<int, 3> to = {home[0] + step % 3 - 1, home[1] + step / 3 % 3 - 1,
                                       home[2] + step / 9 - 1};
        const auto turn = [&](int d) { return to[d] < 0 ? -1 : to[d] >= bins.count(d) ? 1 : 0; };
        const auto in = [&](int d) { return to[d] - turn(d) * bins.count(d); };
        const std::size_t bin = bins.index(in(0), in(1), in(2));
        for (const auto* j = bins.begin(bin); j != bins.end(bin); ++j) {
            if (static_cast<std::size_t>(*j) <= i) {
                continue;
            }
            // A bead within rounding of a face may be binned a turn away from its position, so the
            // image comes from the positions.
            const Image image = nearest_image(beads, cell, i, *j);
            if (separation(beads, cell, i, *j, image).squared() < range_squared) {
                found.push_back({*j, static_cast<std::uint8_t>(image_code::of(image))});
            }
        }
    }
}

}  // namespace

void Pairs::clear() {
    first.clear(), second.clear(), image.clear();
    sx.clear(), sy.clear(), sz.clear(), root.clear(), bridge.clear();
}

void Pairs::add(std::int32_t i, std::int32_t j, std::uint8_t code) {
    first.push_back(i), second.push_back(j), image.push_back(code);
    sx.push_back(0), sy.push_back(0), sz.push_back(0), root.push_back(0), bridge.push_back(0);
}

void Pairs::remember(std::size_t to, const Pairs& other, std::size_t from) {
    sx[to] = other.sx[from], sy[to] = other.sy[from], sz[to] = other.sz[from];
    root[to] = other.root[from], bridge[to] = other.bridge[from];
}

Pairs find_pairs_by_brute_force(const Beads& beads, const Cell& cell, double range) {
    Pairs pairs;
    for (std::size_t i = 0; i < beads.size(); ++i) {
        for (std::size_t j = i + 1; j < beads.size(); ++j) {
            const Image image = nearest_image(beads, cell, i, j);
            if (separation(beads, cell, i, j, image).squared() < range * range) {
                pairs.add(static_cast<std::int32_t>(i), static_cast<std::int32_t>(j),
                          static_cast<std::uint8_t>(image_code::of(image)));
            }
        }
    }
    return pairs;
}

Pairs find_pairs(const Beads& beads, const Cell& cell, double range) {
    const Bins bins(beads, cell, range);
    if (!bins.enough()) {
        return find_pairs_by_brute_force(beads, cell, range);
    }
    Pairs pairs;
    std::vector<Neighbour> found;
    for (std::size_t i = 0; i < beads.size(); ++i) {
        found.clear();
        neighbours_of(i, beads, cell, bins, range * range, found);
        std::ranges::sort(found, {}, &Neighbour::bead);
        for (const auto& neighbour : found) {
            pairs.add(static_cast<std::int32_t>(i), neighbour.bead, neighbour.image);
        }
    }
    return pairs;
}

namespace {

/// Largest squared displacement.
double largest_squared(const std::vector<double>& x, const std::vector<double>& y,
                       const std::vector<double>& z) {
    double largest = 0;
    for (std::size_t i = 0; i < x.size(); ++i) {
        largest = std::max(largest, x[i] * x[i] + y[i] * y[i] + z[i] * z[i]);
    }
    return largest;
}

/// Whether a pair that was left out of a list, being further apart than 1 + skin, may by now be
/// closer than `within`.
bool outdated(double displacement, double strain, double skin, double within) {
    const double g = strain + strain * strain;
    return (1 + skin - 2 * displacement * (1 + g)) * (1 - g) <= within;
}

}  // namespace

void PairList::update(Beads& beads, Cell& cell, double affine_strain) {
    narrow_strain_ += affine_strain;
    const double displacement = std::sqrt(largest_squared(beads.ux, beads.uy, beads.uz));
    if (!outdated(displacement, narrow_strain_, narrow_skin, 1)) {
        return;
    }
    wide_strain_ += narrow_strain_;
    for (std::size_t i = 0; i < beads.size(); ++i) {
        moved_x_[i] += beads.ux[i];
        moved_y_[i] += beads.uy[i];
        moved_z_[i] += beads.uz[i];
    }
    const double moved = std::sqrt(largest_squared(moved_x_, moved_y_, moved_z_));
    // The wide list need only hold whatever the narrow list is to be chosen from.
    if (outdated(moved, wide_strain_, wide_skin_, 1 + narrow_skin)) {
        rebuild(beads, cell);
    } else {
        write_back();
        select(beads, cell);
    }
}

void PairList::rebuild(Beads& beads, Cell& cell) {
    write_back();
    cell.reduce_offset();
    for (std::size_t i = 0; i < beads.size(); ++i) {
        cell.wrap(beads.x[i], beads.y[i], beads.z[i]);
    }
    Pairs fresh = find_pairs(beads, cell, 1 + wide_skin_);
    // Both lists are ordered by first and second bead: one pass carries the memory over.
    std::size_t old = 0;
    for (std::size_t k = 0; k < fresh.size() && old < wide_.size(); ++k) {
        const auto key = [](const Pairs& p, std::size_t n) {
            return std::pair(p.first[n], p.second[n]);
        };
        while (old < wide_.size() && key(wide_, old) < key(fresh, k)) {
            ++old;
        }
        if (old < wide_.size() && key(wide_, old) == key(fresh, k)) {
            fresh.remember(k, wide_, old);
        }
    }
    wide_ = std::move(fresh);
    for (auto* moved : {&moved_x_, &moved_y_, &moved_z_}) {
        moved->assign(beads.size(), 0.0);
    }
    wide_strain_ = 0;
    ++wide_rebuilds_;
    select(beads, cell);
}

void PairList::write_back() {
    for (std::size_t k = 0; k < narrow_index_.size(); ++k) {
        wide_.remember(narrow_index_[k], narrow_, k);
    }
    for (std::size_t k = 0; k < distant_index_.size(); ++k) {
        wide_.bridge[distant_index_[k]] = distant_.bridge[k];
    }
    narrow_index_.clear();
    distant_index_.clear();
}

void PairList::select(Beads& beads, const Cell& cell) {
    narrow_.clear();
    distant_.clear();
    const double range_squared = (1 + narrow_skin) * (1 + narrow_skin);
    for (std::size_t k = 0; k < wide_.size(); ++k) {
        const auto i = wide_.first[k], j = wide_.second[k];
        if (separation(beads, cell, i, j, image_code::image(wide_.image[k])).squared() <
            range_squared) {
            narrow_.add(i, j, wide_.image[k]);
            narrow_.remember(narrow_.size() - 1, wide_, k);
            narrow_index_.push_back(k);
        } else if (wide_.bridge[k] > 0) {
            distant_.add(i, j, wide_.image[k]);
            distant_.bridge.back() = 1;
            distant_index_.push_back(k);
        }
    }
    for (auto* list : {&narrow_, &distant_}) {
        while (list->size() % batch != 0) {
            list->add(0, 0, image_code::nowhere);
        }
    }
    for (auto* displacement : {&beads.ux, &beads.uy, &beads.uz}) {
        displacement->assign(beads.size(), 0.0);
    }
    narrow_strain_ = 0;
}

}  // namespace pendular::dem
