#pragma once

#include <Eigen/Core>
#include <memory>
#include <vector>

#include "calib/model/emulated_simulation.h"

namespace pendular {

/// Fast predictions of an `EmulatedSimulation` near given conditions, for difference quotients over
/// short steps. Predictions without effects on grains are expanded to first order in friction, ln
/// I, 1/P* and ln V0 about each condition (I: inertial number, P*: reduced pressure, V0: bridge
/// volume). Changes by effects on grains and by stiffness are cheap and computed again for each
/// prediction. The bridge volume follows from the liquid content and the expanded coordination
/// number. The difference quotients are as exact as those of the full predictions.
class EmulatedNeighbourhood : public FlowNeighbourhood {
  public:
    /// @param simulation emulated simulation, which must outlive this object
    /// @param friction friction coefficient about which the predictions are expanded [1]
    /// @param conditions conditions about which the predictions are expanded
    EmulatedNeighbourhood(const EmulatedSimulation& simulation, double friction,
                          const std::vector<EffectiveCondition>& conditions);

    Eigen::VectorXd values(const Eigen::VectorXd& parameters,
                           const std::vector<EffectiveCondition>& conditions,
                           const std::vector<std::size_t>& places) const override;

  private:
    /// Number of the emulated quantities: stress ratio, solid fraction, overlap and, for wet
    /// grains, the coordination numbers of contacts and of bridges without contact.
    static constexpr Eigen::Index quantities = 5;
    using Quantities = Eigen::Vector<double, quantities>;
    /// Expansion of the emulated quantities about one condition.
    struct Place {
        FlowState state;
        /// Liquid content of the condition: volume of liquid divided by volume of grains [1].
        double liquid_content = 0;
        Quantities value = Quantities::Zero();
        /// Part of the emulated quantities `value` that comes from effects on grains and from
        /// stiffness.
        Quantities by_effects = Quantities::Zero();
        /// Derivatives of `value` with respect to friction, ln I, 1/P* and ln V0 (I: inertial
        /// number, P*: reduced pressure, V0: bridge volume). The first three omit the part
        /// `by_effects`.
        Eigen::Matrix<double, quantities, 4> slopes = Eigen::Matrix<double, quantities, 4>::Zero();

        double coordination() const { return value(3) + value(4); }
    };

    void expand();
    /// Sets, for each condition about which predictions are expanded, the part `by_effects` of the
    /// quantities that comes from effects on grains and from stiffness. Adds the derivative of this
    /// part with respect to ln V0 (V0: bridge volume) to `slopes`.
    void expand_effects();
    /// Returns the parts of the five emulated quantities that come from effects on grains and
    /// stiffness, for each state.
    std::vector<Quantities> effects_at(const std::vector<FlowState>& states) const;
    /// Whether the expansion about the condition of `place` can predict the state `state`. Both
    /// must be wet or both dry, and either both inertial numbers are positive or they are equal. A
    /// wet `place` needs a coordination number above 1.
    static bool reaches(const Place& place, const FlowState& state);
    /// Returns stress ratio [1], solid fraction [1] and overlap divided by grain diameter [1] at
    /// the state `state`, from the expansion about the nearby condition of `place`.
    /// @param liquid_content liquid content of the state [1]
    /// @param by_effects part of the quantities from effects on grains and stiffness at the state
    static Eigen::Vector3d flow_at(const Place& place, const FlowState& state,
                                   double liquid_content, const Quantities& by_effects);

    const EmulatedSimulation& simulation_;
    std::vector<Place> places_;
};

}  // namespace pendular
