#pragma once

#include <Eigen/Core>
#include <memory>
#include <vector>

#include "calib/model/emulated_simulation.h"

namespace pendular {

/// Fast predictions of an `EmulatedSimulation` near given conditions, from which derivatives are
/// computed as difference quotients over short steps. About each condition, the predictions without
/// effects on grains, such as rolling resistance, are expanded to first order in the friction
/// coefficient, ln I, 1/P* and ln V0, with the inertial number I, the reduced pressure P* and the
/// bridge volume V0. Changes by effects on grains and by the stiffness number are expanded only in
/// ln V0. The difference quotients are as exact as difference quotients of the full predictions.
class EmulatedNeighbourhood : public FlowNeighbourhood {
  public:
    /// @param simulation emulated simulation, which must outlive the object
    /// @param friction friction coefficient about which the predictions are expanded [1]
    /// @param conditions conditions about which the predictions are expanded
    EmulatedNeighbourhood(const EmulatedSimulation& simulation, double friction,
                          const std::vector<EffectiveCondition>& conditions);

    Eigen::VectorXd values(const Eigen::VectorXd& parameters,
                           const std::vector<EffectiveCondition>& conditions,
                           const std::vector<std::size_t>& places) const override;

  private:
    /// Number of emulated quantities: stress ratio, solid fraction, overlap and, for wet grains,
    /// the number of contacts per grain and the number of bridges without contact per grain.
    static constexpr Eigen::Index quantities = 5;
    using Quantities = Eigen::Vector<double, quantities>;
    /// First-order expansion of the emulated quantities (stress ratio, solid fraction, overlap, and
    /// numbers of contacts and bridges per grain) about one condition.
    struct Place {
        FlowState state;
        /// Liquid content [1] at the condition: volume of liquid divided by volume of grains.
        double liquid_content = 0;
        Quantities value = Quantities::Zero();
        /// Contribution of effects on grains and of the grains' stiffness number to the emulated
        /// quantities `value`.
        Quantities by_effects = Quantities::Zero();
        /// Derivatives of the emulated quantities `value` with respect to the friction coefficient,
        /// ln I, 1/P* and ln V0, in this order, with the inertial number I, the reduced pressure P*
        /// and the bridge volume V0. The first three derivatives omit the contribution
        /// `by_effects`.
        Eigen::Matrix<double, quantities, 4> slopes = Eigen::Matrix<double, quantities, 4>::Zero();

        double coordination() const { return value(3) + value(4); }
    };

    void expand();
    /// Sets, for each condition about which predictions are expanded, the contribution `by_effects`
    /// of effects on grains and of the stiffness number to the emulated quantities (`quantities`).
    /// Adds the derivative of the contribution with respect to ln V0, with the bridge volume V0, to
    /// `slopes`.
    void expand_effects();
    /// Returns the contributions of effects on grains and of the stiffness number to the five
    /// emulated quantities (`quantities`) at each state, in the order of `states`.
    std::vector<Quantities> effects_at(const std::vector<FlowState>& states) const;
    /// Whether the expansion about the condition of `place` can predict the state `state`. The
    /// condition and the state must both be wet or both be dry. Their inertial numbers must either
    /// both be positive or be equal. If `place` is wet, its coordination number must be above 1.
    static bool reaches(const Place& place, const FlowState& state);
    /// Returns the stress ratio [1], the solid fraction [1] and the overlap divided by the grain
    /// diameter [1] at the state `state`, from the expansion about the nearby condition of `place`.
    /// @param liquid_content liquid content of the state [1]
    /// @param by_effects contribution of effects on grains and of the stiffness number to the
    ///        emulated quantities (`quantities`) at the state
    static Eigen::Vector3d flow_at(const Place& place, const FlowState& state,
                                   double liquid_content, const Quantities& by_effects);

    const EmulatedSimulation& simulation_;
    std::vector<Place> places_;
};

}  // namespace pendular
