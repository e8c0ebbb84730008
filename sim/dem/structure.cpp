#include "sim/dem/structure.h"

#include <Eigen/Dense>
#include <algorithm>
#include <array>
#include <cmath>
#include <complex>

#include "sim/dem/separations.h"

namespace pendular::dem {
namespace {

/// Means of the spherical harmonics Y_6m over directions, m = 0..6, for the bond order Q6; negative
/// m follow by symmetry.
class BondOrder {
  public:
    void add(double nx, double ny, double nz) {
        const double z2 = nz * nz;
        // Associated Legendre functions of degree 6 over sin^m theta, without their norms (see q6).
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
        // Squared norms of Y_6m for the polynomials of `add`, times pi.
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

/// Directions of the pairs of one network, with force and length as functions of direction.
class Network {
  public:
    /// Adds a pair along the unit vector n with its force and the distance of its centres.
    void add(const Eigen::Vector3d& n, double force, double length) {
        // Spherical harmonics of order 0 and 2, up to factors.
        Eigen::Matrix<double, 6, 1> y;
        y << 1, n[0] * n[1], n[0] * n[2], n[1] * n[2], n[0] * n[0] - n[1] * n[1],
            n[2] * n[2] - 1.0 / 3;
        normal_ += y * y.transpose();
        force_ += y * force;
        length_ += y * length;
        ++count_;
    }
    double count() const { return count_; }
    double mean(double sum) const { return count_ > 0 ? sum / count_ : 0; }
    double fabric_12() const { return mean(normal_(0, 1)); }
    double force() const { return mean(force_(0)); }
    double length() const { return mean(length_(0)); }
    double force_anisotropy_12() const { return anisotropy(force_); }
    double length_anisotropy_12() const { return anisotropy(length_); }

  private:
    /// Anisotropy of a quantity q(n) in n1 n2, from its sums with the spherical harmonics. With
    /// q(n) = b0 + b1 n1 n2 + ..., (1/4 pi) times the integral of q n1 n2 over the sphere is b1/15.
    double anisotropy(const Eigen::Matrix<double, 6, 1>& sums) const {
        if (count_ < fewest_pairs || !(sums(0) > 0)) {
            return 0;
        }
        return normal_.ldlt().solve(sums)(1) / 15 / mean(sums(0));
    }
    static constexpr double fewest_pairs = 12;  // twice the number of harmonics fitted

    Eigen::Matrix<double, 6, 6> normal_ = Eigen::Matrix<double, 6, 6>::Zero();
    Eigen::Matrix<double, 6, 1> force_ = Eigen::Matrix<double, 6, 1>::Zero(), length_ = force_;
    double count_ = 0;
};

}  // namespace

Structure structure_of(const Grains& grains, const Cell& cell, const Pairs& near,
                       const Pairs& distant_pairs, const Material& material,
                       const BridgeLaw& bridges, const GrainEffects& effects) {
    Structure s;
    BondOrder order;
    Network contacts, distant;
    const double capillary_unit = bridges.pull_off_force / cell.volume();
    const auto note_capillary = [&](const Eigen::Vector3d& n, double moment, double& shear) {
        s.capillary_stress_22 -= moment * n[1] * n[1];
        s.capillary_pressure -= moment / 3;
        shear -= moment * n[0] * n[1];
    };
    // Attraction of a pair over F0; `gap` below 0: overlap.
    const auto attraction = [&](const Pairs& pairs, std::size_t k, double gap) {
        if (!effects.changes_pairs()) {
            return bridges.relative_force(std::max(0.0, gap));
        }
        const PairSizes sizes = grains.sizes(static_cast<std::size_t>(pairs.first[k]),
                                             static_cast<std::size_t>(pairs.second[k]));
        return effects.attraction(gap, sizes.diameter, material, bridges, pairs.history_of(k)) /
               bridges.pull_off_force;
    };
    const auto note_distant = [&](const Pairs& pairs, std::size_t k, const Vector& separation) {
        const Eigen::Vector3d r(separation[0], separation[1], separation[2]);
        const double length = r.norm(), gap = std::max(0.0, gap_of(grains, pairs, k, separation));
        const double force = attraction(pairs, k, gap);
        distant.add(r / length, force, length);
        s.distant_force_gap += force * gap;
        note_capillary(r / length, capillary_unit * force * length,
                       s.capillary_shear_stress_distant);
    };
    for_each_pair(grains, cell, near, [&](std::size_t k, const Vector& separation) {
        if (near.root[k] > 0) {
            const Eigen::Vector3d r(separation[0], separation[1], separation[2]);
            const double length = r.norm(), overlap = near.root[k] * near.root[k];
            const Eigen::Vector3d n = r / length;
            contacts.add(n, contact_of(grains, near, k, material.modulus).elastic, length);
            s.overlap += overlap;
            order.add(n[0], n[1], n[2]);
            const double force = bridges.wet() ? attraction(near, k, -overlap) : 0;
            note_capillary(n, capillary_unit * force * length, s.capillary_shear_stress_contact);
        } else if (near.bridge[k] > 0) {
            note_distant(near, k, separation);
        }
    });
    for_each_pair(grains, cell, distant_pairs, [&](std::size_t k, const Vector& r) {
        if (distant_pairs.bridge[k] > 0) {
            note_distant(distant_pairs, k, r);
        }
    });
    const auto per_bead = 2 / static_cast<double>(grains.size());
    s.contact_coordination = per_bead * contacts.count();  // each contact counts for both grains
    s.fabric_12_contact = contacts.fabric_12();            // Eq. (27)
    s.overlap = contacts.mean(s.overlap);
    s.bond_order = order.q6();
    s.contact_force = contacts.force();
    s.force_anisotropy_12_contact = contacts.force_anisotropy_12();
    s.distant_coordination = per_bead * distant.count();
    s.distant_force = distant.force();                        // Eq. (11)
    s.distant_force_gap = distant.mean(s.distant_force_gap);  // third term of Eq. (10)
    s.distant_length = distant.length();
    s.fabric_12_distant = distant.fabric_12();
    s.force_anisotropy_12_distant = distant.force_anisotropy_12();
    s.length_anisotropy_12_distant = distant.length_anisotropy_12();
    return s;
}

double mean_bridge_volume(const PairList& pairs, const GrainEffects& effects) {
    if (!effects.volume_in_history()) return 1;
    double count = 0, volume = 0;
    for (const Pairs* list : {&pairs.narrow(), &pairs.distant()}) {
        const std::vector<double>& volumes = list->contact_history[*effects.volume_in_history()];
        for (std::size_t k = 0; k < list->size(); ++k) {
            count += list->bridge[k];
            volume += list->bridge[k] * std::abs(volumes[k]);
        }
    }
    return count > 0 ? volume / count : 1;
}

std::span<double Structure::*const> Structure::members() {
    static constexpr double Structure::*all[] = {
#define STRUCTURE_OBSERVABLE(name, ...) &Structure::name,
#include "data/quantities/observables.def"
    };
    return all;
}

Structure& Structure::operator+=(const Structure& other) {
    for (const auto member : members()) {
        this->*member += other.*member;
    }
    return *this;
}

Structure& Structure::operator/=(double count) {
    for (const auto member : members()) {
        this->*member /= count;
    }
    return *this;
}

}  // namespace pendular::dem
