#include "calib/bridge_network.h"

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>

namespace pendular {
namespace {

/// Z, Z* and a^2 s12cap/F0 in the middle of the pendular range, used before there are runs.
const Eigen::RowVector3d typical(dem::typical_coordination, 6.7, 0.06);
/// How the network depends on the inertial number is weak; any smooth coordinate serves.
constexpr double exponent = 0.75;

FlowState state_of(const dem::RunParameters& p) {
    return {p.friction, p.inertial_number, 1 / p.wetting->reduced_pressure,
            p.wetting->bridge_volume};
}

}  // namespace

BridgeNetwork::BridgeNetwork(const std::vector<dem::RunResult>& runs, double centre)
    : centre_(centre) {
    std::vector<dem::RunResult> wet;
    std::ranges::copy_if(runs, std::back_inserter(wet), [](const dem::RunResult& run) {
        return run.parameters.wetting && !run.crystallised;
    });
    // The strongest dependences first, as many as the runs can carry.
    constexpr Basis::Powers by_weight[] = {{},       {.v = 1}, {.u = 1}, {.x = 1},
                                           {.v = 2}, {.q = 1}, {.u = 2}};
    const std::size_t most = std::max<std::size_t>(1, wet.size() / 2);
    for (const auto& term : by_weight) {
        if (static_cast<std::size_t>(basis_.size()) < most) {
            basis_.add(term);
        }
    }
    if (wet.empty()) {
        coefficients_ = typical;
        return;
    }
    const auto rows = static_cast<Eigen::Index>(wet.size());
    Eigen::MatrixXd design(rows, basis_.size()), target(rows, 3);
    for (Eigen::Index k = 0; k < rows; ++k) {
        const auto& run = wet[static_cast<std::size_t>(k)];
        design.row(k) = basis_.values(coordinates(state_of(run.parameters), centre, exponent));
        target.row(k) << run[dem::Observable::contact_coordination].value +
                             run[dem::Observable::distant_coordination].value,
            run[dem::Observable::effective_coordination].value,
            run[dem::Observable::capillary_shear_stress].value *
                run.parameters.wetting->reduced_pressure;
    }
    coefficients_ = design.completeOrthogonalDecomposition().solve(target);
}

BridgeNetwork::Response BridgeNetwork::respond(Eigen::Index which, const FlowState& state) const {
    const Coordinates at = coordinates(state, centre_, exponent);
    const auto c = coefficients_.col(which);
    return {basis_.values(at).dot(c),
            basis_.slopes_in_x(at).dot(c) * friction_slope(state.friction),
            basis_.slopes_in_v(at).dot(c)};
}

double BridgeNetwork::volume_of(double liquid_content, const FlowState& state) const {
    // Z grows slowly with ln V0, so that V0 <- pi Phi_L/(3 Z Phi_S) converges.
    FlowState at = state;
    at.bridge_volume = dem::bridge_volume(liquid_content, typical(0));
    for (int k = 0; k < 50; ++k) {
        const double z = std::max(1.0, coordination(at).value);
        const double next = dem::bridge_volume(liquid_content, z);
        const bool settled = std::abs(next / at.bridge_volume - 1) < 1e-13;
        at.bridge_volume = next;
        if (settled) {
            break;
        }
    }
    return at.bridge_volume;
}

double BridgeNetwork::log_volume_slope(const FlowState& state) const {
    // ln V0 + ln Z(V0, mu) stays constant.
    const Response z = coordination(state);
    return -z.by_friction / (z.value + z.by_log_volume);
}

BridgeNetwork::Response BridgeNetwork::at_constant_content(const Response& response,
                                                           const FlowState& state) const {
    return {response.value, response.by_friction + response.by_log_volume * log_volume_slope(state),
            response.by_log_volume};
}

}  // namespace pendular
