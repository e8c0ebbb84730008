#include "sim/dem/structure.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <complex>

namespace pendular::dem {
namespace {

/// Means of Y_6m over directions, m = 0..6; negative m follow by symmetry.
class BondOrder {
  public:
    void add(double nx, double ny, double nz) {
        const double z2 = nz * nz;
        // Associated Legendre functions of degree 6 over sin^m theta; q6() holds their norms.
        const std::array<double, 7> legendre = {((231 * z2 - 315) * z2 + 105) * z2 - 5,
                                                nz * ((33 * z2 - 30) * z2 + 5),
                                                (33 * z2 - 18) * z2 + 1,
                                                nz * (11 * z2 - 3),
                                                11 * z2 - 1,
                                                nz,
                                                1.0};
        std::complex<double> turn = 1;
        for (std::size_t m = 0; m < 7; ++m) {
            sums_[m] += legendre[m] * turn;
            turn *= std::complex<double>(nx, ny);
        }
        ++count_;
    }
    double q6() const {
        if (count_ == 0) {
            return 0;
        }
        // Squared norms of Y_6m in front of these polynomials, times pi.
        constexpr std::array<double, 7> squared = {13.0 / 1024,   273.0 / 512,  1365.0 / 4096,
                                                   1365.0 / 1024, 819.0 / 2048, 9009.0 / 1024,
                                                   3003.0 / 4096};
        double total = 0;
        for (std::size_t m = 0; m < 7; ++m) {
            total += (m == 0 ? 1 : 2) * squared[m] * std::norm(sums_[m] / count_);
        }
        return std::sqrt(4.0 / 13 * total);
    }

  private:
    std::array<std::complex<double>, 7> sums_{};
    double count_ = 0;
};

}  // namespace

Structure structure_of(const Beads& beads, const Cell& cell, const Pairs& pairs) {
    Structure structure;
    BondOrder order;
    double contacts = 0;
    for (std::size_t k = 0; k < pairs.size(); ++k) {
        if (pairs.root[k] <= 0) {
            continue;
        }
        const auto i = pairs.first[k], j = pairs.second[k];
        const Image n = image_code::image(pairs.image[k]);
        const double x = beads.x[j] - beads.x[i] + n.n1 * cell.length + n.n2 * cell.offset;
        const double y = beads.y[j] - beads.y[i] + n.n2 * cell.height;
        const double z = beads.z[j] - beads.z[i] + n.n3 * cell.width;
        const double distance = std::sqrt(x * x + y * y + z * z);
        contacts += 1;
        structure.fabric_12 += x * y / (distance * distance);
        structure.mean_overlap += pairs.root[k] * pairs.root[k];
        order.add(x / distance, y / distance, z / distance);
    }
    structure.contact_coordination = 2 * contacts / static_cast<double>(beads.size());
    if (contacts > 0) {
        structure.fabric_12 /= contacts;
        structure.mean_overlap /= contacts;
    }
    structure.bond_order = order.q6();
    return structure;
}

Structure& Structure::operator+=(const Structure& other) {
    contact_coordination += other.contact_coordination;
    fabric_12 += other.fabric_12;
    mean_overlap += other.mean_overlap;
    bond_order += other.bond_order;
    return *this;
}

Structure& Structure::operator/=(double count) {
    for (double* value : {&contact_coordination, &fabric_12, &mean_overlap, &bond_order}) {
        *value /= count;
    }
    return *this;
}

void VelocityProfile::add(const Beads& beads, double height) {
    if (velocity_.empty()) {
        velocity_.assign(static_cast<std::size_t>(std::lround(height)), 0.0);
        count_.assign(velocity_.size(), 0.0);
    }
    const auto bins = static_cast<double>(velocity_.size());
    for (std::size_t i = 0; i < beads.size(); ++i) {
        const double place = beads.y[i] / height;
        const auto bin = static_cast<std::size_t>((place - std::floor(place)) * bins);
        velocity_[std::min(bin, velocity_.size() - 1)] += beads.vx[i];
        count_[std::min(bin, velocity_.size() - 1)] += 1;
    }
}

double VelocityProfile::localization(double height, double shear_rate) const {
    const double across = height * shear_rate;
    double sum = 0;
    for (std::size_t bin = 0; bin < velocity_.size(); ++bin) {
        const double mean = count_[bin] > 0 ? velocity_[bin] / count_[bin] : 0.0;
        sum += mean * mean;
    }
    return velocity_.empty() ? 0
                             : 12 * sum / (static_cast<double>(velocity_.size()) * across * across);
}

}  // namespace pendular::dem
