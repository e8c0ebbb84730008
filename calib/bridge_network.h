#pragma once

#include <Eigen/Core>
#include <vector>

#include "calib/basis.h"
#include "calib/structure_response.h"
#include "sim/dem/run.h"

namespace pendular {

/// What the bridge network of wet runs looks like as a smooth function of the state: coordination
/// and capillary shear stress, by least squares through the runs,
///     y = n0 + n1 v + n2 u + n3 x + n4 v^2 + n5 q + n6 u^2
/// in the coordinates of basis.h. From it follows the bridge volume of a liquid content.
class BridgeNetwork {
  public:
    /// Without wet runs it knows a typical coordination only, to begin with.
    BridgeNetwork(const std::vector<dem::RunResult>& runs, double centre);

    using Response = StructureResponse;
    Response coordination(const FlowState& state) const { return respond(0, state); }  ///< Z [1]
    Response effective_coordination(const FlowState& state) const {                    ///< Z* [1]
        return respond(1, state);
    }
    Response capillary_shear_stress(const FlowState& state) const {  ///< a^2 s12cap/F0 [1]
        return respond(2, state);
    }

    /// V0/a^3 that gives a liquid content at this friction, inertial number and reduced pressure:
    /// the solution of Phi_L/Phi_S = 3 Z(V0) V0/(pi a^3), eq:lcont.
    double volume_of(double liquid_content, const FlowState& state) const;
    /// d(ln V0)/d(friction) at constant liquid content.
    double log_volume_slope(const FlowState& state) const;
    /// The same response with its derivative by friction at constant liquid content, not volume.
    Response at_constant_content(const Response& response, const FlowState& state) const;

  private:
    Response respond(Eigen::Index which, const FlowState& state) const;

    double centre_;
    Basis basis_;
    Eigen::MatrixXd coefficients_;  ///< terms x 3
};

}  // namespace pendular
