#include "calib/fit/sharpening_runs.h"

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>
#include <utility>

namespace pendular {
namespace {

/// Distinct flow states with the sums of the weights of the readings there.
class WeightedStates {
  public:
    void add(const FlowState& state, const Eigen::Vector2d& weight) {
        const auto same = std::ranges::find_if(
            states_, [&](const FlowState& other) { return near(state, other); });
        if (same == states_.end()) {
            states_.push_back(state);
            weights_.push_back(weight);
        } else {
            weights_[static_cast<std::size_t>(same - states_.begin())] += weight;
        }
    }
    const std::vector<FlowState>& states() const { return states_; }
    Eigen::VectorXd weights() const {
        Eigen::VectorXd all(2 * std::ssize(weights_));
        for (std::size_t k = 0; k < weights_.size(); ++k) {
            all.segment<2>(2 * static_cast<Eigen::Index>(k)) = weights_[k];
        }
        return all;
    }

  private:
    std::vector<FlowState> states_;
    std::vector<Eigen::Vector2d> weights_;
};

/// Inverse variances of the stress ratio and solid fraction of a reading [1].
Eigen::Vector2d weight_of(const Reading& reading) {
    const double stress = reading.condition.normal_stress;
    return {stress * stress / reading.covariance(0, 0), 1 / reading.covariance(1, 1)};
}

/// Fitted parameters of a model, and these parameters shifted either way by one standard error
/// along the direction in which they are known worst, in units of their standard errors, within
/// their bounds.
std::vector<Eigen::VectorXd> likely_parameters(const FittedModel& fitted) {
    const Eigen::VectorXd errors = fitted.fit.covariance.diagonal().cwiseSqrt();
    const ParameterBounds bounds = fitted.predictor->bounds();
    std::vector<Eigen::VectorXd> likely = {fitted.fit.parameters};
    if (!errors.allFinite() || (errors.array() <= 0).any()) {
        return likely;
    }
    const Eigen::VectorXd scale = errors.cwiseInverse();
    const Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> correlation(
        scale.asDiagonal() * fitted.fit.covariance * scale.asDiagonal());
    const Eigen::Index last = errors.size() - 1;  // eigenvalues increase
    const Eigen::VectorXd step = std::sqrt(correlation.eigenvalues()(last)) *
                                 correlation.eigenvectors().col(last).cwiseProduct(errors);
    for (const double way : {-1.0, 1.0}) {
        const Eigen::VectorXd moved = fitted.fit.parameters + way * step;
        likely.push_back(moved.cwiseMax(bounds.lower).cwiseMin(bounds.upper));
    }
    return likely;
}

}  // namespace

RunChoice sharpening_choice(const EmulatedSimulation& simulation,
                            const std::vector<FittedModel>& fitted,
                            const std::vector<Reading>& readings, double lowest_inertial_number) {
    WeightedStates targets, from;
    for (const FittedModel& each : fitted) {
        for (const Eigen::VectorXd& parameters : likely_parameters(each)) {
            const auto imposed = each.predictor->imposed(parameters, conditions_of(readings));
            for (std::size_t k = 0; k < readings.size(); ++k) {
                EffectiveCondition simulated = imposed[k];
                simulated.inertial_number =
                    std::max(simulated.inertial_number, lowest_inertial_number);
                FlowState state = simulation.flow_state_at(parameters(0), simulated);
                targets.add(state, weight_of(readings[k]));
                state.stiffness_number = 0;  // that of the training runs
                from.add(state, Eigen::Vector2d::Zero());
                state.effects.clear();
                from.add(state, Eigen::Vector2d::Zero());
            }
        }
    }
    return {.targets = targets.states(), .weights = targets.weights(), .from = from.states()};
}

}  // namespace pendular
