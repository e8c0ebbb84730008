#pragma once

#include <Eigen/Core>
#include <memory>
#include <vector>

#include "calib/model/emulated_simulation.h"

namespace pendular {

/// Predictions of an `EmulatedSimulation` near n conditions. The part of plain grains is
/// expanded to first order in friction, ln I, 1/P* and ln V0 (bridge volume) about the conditions;
/// responses to effects on grains and to stiffness, which are cheap, are evaluated anew. The volume
/// follows from the liquid content with the expanded coordination number. Difference quotients over
/// short steps are as exact as those of the predictions themselves.
class EmulatedNeighbourhood : public FlowNeighbourhood {
  public:
    /// @param friction friction coefficient at which the predictions are expanded [1]
    EmulatedNeighbourhood(const EmulatedSimulation& simulation, double friction,
                          const std::vector<EffectiveCondition>& conditions);

    Eigen::VectorXd values(const Eigen::VectorXd& parameters,
                           const std::vector<EffectiveCondition>& conditions,
                           const std::vector<std::size_t>& places) const override;

  private:
    /// Emulated quantities: stress ratio, solid fraction, overlap, coordination numbers of contacts
    /// and of distant bridges, the last two of wet states.
    static constexpr Eigen::Index quantities = 5;
    using Quantities = Eigen::Vector<double, quantities>;
    /// Expansion about one condition.
    struct Place {
        FlowState state;
        double liquid_content = 0;  ///< Phi_L/Phi_S [1]
        Quantities value = Quantities::Zero();
        /// Part of `value` from effects on grains and stiffness.
        Quantities by_effects = Quantities::Zero();
        /// Derivatives by friction, ln I, 1/P* and ln V0; the first three omit that part.
        Eigen::Matrix<double, quantities, 4> slopes = Eigen::Matrix<double, quantities, 4>::Zero();

        double coordination() const { return value(3) + value(4); }
    };

    void expand();
    /// Sets the parts that effects on grains and stiffness contribute.
    void expand_effects();
    /// Parts of the quantities from effects on grains and stiffness at each state.
    std::vector<Quantities> effects_at(const std::vector<FlowState>& states) const;
    /// Whether the expansion about a place holds at a state, whose liquid is given too.
    static bool reaches(const Place& place, const FlowState& state);
    /// Stress ratio, solid fraction and overlap at a state near a place.
    static Eigen::Vector3d flow_at(const Place& place, const FlowState& state,
                                   double liquid_content, const Quantities& by_effects);

    const EmulatedSimulation& simulation_;
    std::vector<Place> places_;
};

}  // namespace pendular
