#pragma once

#include <Eigen/Core>
#include <memory>
#include <vector>

#include "calib/model/emulated_simulation.h"

namespace pendular {

/// Fast predictions of an `EmulatedSimulation` near given conditions, for difference quotients over
/// short steps. About each condition, the predictions without effects on grains are expanded to
/// first order in the friction coefficient, ln I, 1/P* and ln V0. Changes by effects on grains and
/// by the stiffness number are expanded only in ln V0, and emulated anew at other friction, I and
/// P*. The difference quotients are as exact as those of the full predictions.
class EmulatedNeighbourhood : public FlowNeighbourhood {
  public:
    /// @param simulation must outlive the object
    /// @param friction friction coefficient about which the predictions are expanded [1]
    EmulatedNeighbourhood(const EmulatedSimulation& simulation, double friction,
                          const std::vector<EffectiveCondition>& conditions);

    Eigen::VectorXd values(const Eigen::VectorXd& parameters,
                           const std::vector<EffectiveCondition>& conditions,
                           const std::vector<std::size_t>& places) const override;

  private:
    /// Emulated quantities: stress ratio, solid fraction, overlap and, for wet grains, contacts and
    /// bridges without contact per grain.
    static constexpr Eigen::Index quantities = 5;
    using Quantities = Eigen::Vector<double, quantities>;
    /// First-order expansion of the quantities about one condition.
    struct Place {
        FlowState state;
        double liquid_content = 0;  ///< liquid content [1]
        Quantities value = Quantities::Zero();
        /// Part of `value` due to effects on grains and stiffness.
        Quantities by_effects = Quantities::Zero();
        /// Derivatives of `value` with respect to friction, ln I, 1/P* and ln V0. The first three
        /// omit `by_effects`.
        Eigen::Matrix<double, quantities, 4> slopes = Eigen::Matrix<double, quantities, 4>::Zero();

        double coordination() const { return value(3) + value(4); }
    };

    void expand();
    /// Sets `by_effects` of each place and adds its derivative with respect to ln V0 to `slopes`.
    void expand_effects();
    /// Returns the changes of the quantities by effects on grains and by stiffness, for each state.
    std::vector<Quantities> effects_at(const std::vector<FlowState>& states) const;
    /// Whether the expansion about `place` can predict `state`: both wet or both dry, and inertial
    /// numbers both positive or equal. A wet place needs coordination() > 1 (`bridge_volume_of`).
    static bool reaches(const Place& place, const FlowState& state);
    /// Returns stress ratio [1], solid fraction [1] and overlap over grain diameter [1] at `state`.
    /// @param liquid_content liquid content of the state [1]
    /// @param by_effects changes by effects on grains and stiffness at the state
    static Eigen::Vector3d flow_at(const Place& place, const FlowState& state,
                                   double liquid_content, const Quantities& by_effects);

    const EmulatedSimulation& simulation_;
    std::vector<Place> places_;
};

}  // namespace pendular
