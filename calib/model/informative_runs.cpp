#include "calib/model/informative_runs.h"

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>
#include <utility>

#include "calib/emulator/emulated_observables.h"

namespace pendular {
namespace {

using emulated::pairs_at;

/// Expected noise of a future run: covariance of its stress ratio and solid fraction [1], scaled
/// from the mean noise of the earlier runs by the number of grains and the strain.
Eigen::Matrix2d expected_noise(const Emulator& emulator, const Fidelity& fidelity) {
    Eigen::Matrix2d sum = Eigen::Matrix2d::Zero();
    for (const auto& run : emulator.runs()) {
        sum += emulator.noise(run) * run.parameters.grains * run.strain_averaged;
    }
    return sum / (static_cast<double>(emulator.runs().size()) * fidelity.grains * fidelity.strain);
}

bool similar(double x, double y) {
    constexpr double same = 0.05;  // chosen: above the 2 % by which set points of replicates differ
    return std::abs(x - y) <= same * std::max(std::abs(x), std::abs(y));
}

}  // namespace

bool near(const FlowState& a, const FlowState& b) {
    return similar(a.friction, b.friction) && similar(a.inertial_number, b.inertial_number) &&
           similar(a.inverse_pressure, b.inverse_pressure) &&
           similar(a.bridge_volume, b.bridge_volume) &&
           std::ranges::equal(a.effects, b.effects,
                              [](const EffectValues& one, const EffectValues& other) {
                                  return one.effect == other.effect &&
                                         std::ranges::equal(one.values, other.values, similar);
                              });
}

std::vector<FlowState> most_informative(const Emulator& emulator, const Fidelity& fidelity,
                                        const RunChoice& choice) {
    std::vector<FlowState> all = choice.targets;
    all.insert(all.end(), choice.from.begin(), choice.from.end());
    Eigen::MatrixXd covariance = emulator.covariance(pairs_at(all));
    const Eigen::Matrix2d noise = expected_noise(emulator, fidelity);
    const auto wanted = 2 * static_cast<Eigen::Index>(choice.targets.size());
    const auto variances = [&] {
        return Eigen::VectorXd(choice.weights.cwiseProduct(covariance.diagonal().head(wanted)));
    };
    const double enough = variances().norm() / std::max(1.0, choice.factor);
    std::vector<FlowState> chosen;
    while (chosen.size() < choice.most &&
           (chosen.size() < choice.fewest || variances().norm() > enough)) {
        const auto fall = [&](Eigen::Index c) {
            const auto columns = covariance.middleCols<2>(c);
            const Eigen::Matrix2d inverse = (covariance.block<2, 2>(c, c) + noise).inverse();
            return std::pair(columns, inverse);
        };
        const Eigen::VectorXd before = variances();
        Eigen::Index best = wanted;
        double most = -1;
        for (Eigen::Index c = wanted; c < covariance.rows(); c += 2) {
            const auto [columns, inverse] = fall(c);
            const Eigen::VectorXd falls = choice.weights.cwiseProduct(
                (columns * inverse).cwiseProduct(columns).rowwise().sum().head(wanted));
            const double gain = all[static_cast<std::size_t>(c / 2)].inertial_number *
                                falls.dot(2 * before - falls);
            if (gain > most) {
                most = gain, best = c;
            }
        }
        const auto [columns, inverse] = fall(best);
        covariance -= Eigen::MatrixXd(columns * inverse * columns.transpose());
        chosen.push_back(all[static_cast<std::size_t>(best / 2)]);
    }
    return chosen;
}

}  // namespace pendular
