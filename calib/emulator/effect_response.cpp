#include "calib/emulator/effect_response.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace pendular {
namespace {

/// Correlation length of the response in the scaled coordinates of `ResponsePlace` [1]. Chosen: the
/// coordinates are of the order of 1, so that the process bends about once within the runs, and the
/// plane carries what bends less. Few runs have an effect, too few to fit a length for each.
constexpr double length = 1.5;
/// Variances of plane and process that are tried, relative to the mean square of the observed
/// response [1]: from a part that is negligible to one ten times as large as what was observed.
constexpr double sizes[] = {1e-4, 1e-3, 1e-2, 0.03, 0.1, 0.3, 1, 3, 10};

BellSums::Place inverse_square_lengths() {
    BellSums::Place result;
    result.fill(1 / (length * length));
    return result;
}

BellSums::Place place_of_bells(const ResponsePlace& place) {
    BellSums::Place result;
    std::copy(place.begin(), place.end(), result.begin());
    return result;
}

}  // namespace

EffectResponse::EffectResponse(std::vector<ResponsePlace> places, Eigen::VectorXd amplitudes,
                               const Eigen::VectorXd& changes, const Eigen::MatrixXd& covariance)
    : places_(std::move(places)),
      amplitudes_(std::move(amplitudes)),
      bells_(BellSums::most_coordinates, inverse_square_lengths()) {
    // Not 0 where an effect changes nothing, so that the prior variances stay positive.
    const double seen = std::max(1e-12, changes.squaredNorm() / amplitudes_.squaredNorm());
    double best = -std::numeric_limits<double>::infinity();
    double best_plane = seen, best_curved = seen;
    for (const double plane : sizes) {
        for (const double curved : sizes) {
            plane_ = plane * seen, curved_ = curved * seen;
            const Eigen::LLT<Eigen::MatrixXd> factor(
                kernels(places_, amplitudes_, places_, amplitudes_) + covariance);
            if (factor.info() != Eigen::Success) {
                continue;
            }
            const double likelihood =
                -0.5 * changes.dot(factor.solve(changes)) -
                Eigen::MatrixXd(factor.matrixL()).diagonal().array().log().sum();
            if (likelihood > best) {
                best = likelihood, best_plane = plane_, best_curved = curved_;
            }
        }
    }
    plane_ = best_plane, curved_ = best_curved;
    factor_.compute(kernels(places_, amplitudes_, places_, amplitudes_) + covariance);
    const Eigen::VectorXd weights = amplitudes_.cwiseProduct(factor_.solve(changes));
    for (std::size_t k = 0; k < places_.size(); ++k) {
        const double weight = weights(static_cast<Eigen::Index>(k));
        plane_constant_ += weight;
        plane_slopes_ += weight * places_[k];
        bells_.add(place_of_bells(places_[k]), weight);
    }
}

double EffectResponse::kernel(const ResponsePlace& a, const ResponsePlace& b) const {
    return plane_ * (1 + a.dot(b)) +
           curved_ * std::exp(-0.5 * (a - b).squaredNorm() / (length * length));
}

Eigen::MatrixXd EffectResponse::kernels(const std::vector<ResponsePlace>& a,
                                        const Eigen::VectorXd& of_a,
                                        const std::vector<ResponsePlace>& b,
                                        const Eigen::VectorXd& of_b) const {
    Eigen::MatrixXd result(of_a.size(), of_b.size());
    for (Eigen::Index i = 0; i < of_a.size(); ++i) {
        for (Eigen::Index j = 0; j < of_b.size(); ++j) {
            result(i, j) = of_a(i) * of_b(j) *
                           kernel(a[static_cast<std::size_t>(i)], b[static_cast<std::size_t>(j)]);
        }
    }
    return result;
}

Eigen::VectorXd EffectResponse::mean(const std::vector<ResponsePlace>& at,
                                     const Eigen::VectorXd& b) const {
    Eigen::VectorXd result(b.size());
    for (Eigen::Index k = 0; k < b.size(); ++k) {
        const ResponsePlace& place = at[static_cast<std::size_t>(k)];
        result(k) = b(k) * (plane_ * (plane_constant_ + place.dot(plane_slopes_)) +
                            curved_ * bells_.at(place_of_bells(place))[0]);
    }
    return result;
}

Eigen::MatrixXd EffectResponse::weights(const std::vector<ResponsePlace>& at,
                                        const Eigen::VectorXd& b) const {
    return factor_.solve(kernels(places_, amplitudes_, at, b)).transpose();
}

Eigen::MatrixXd EffectResponse::covariance(const std::vector<ResponsePlace>& at,
                                           const Eigen::VectorXd& b) const {
    const Eigen::MatrixXd with_known = kernels(places_, amplitudes_, at, b);
    const Eigen::MatrixXd solved = factor_.matrixL().solve(with_known);
    return kernels(at, b, at, b) - solved.transpose() * solved;
}

}  // namespace pendular
