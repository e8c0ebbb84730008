#pragma once

#include <optional>
#include <string>

#include "calib/emulator/known_range.h"
#include "sim/runs/fidelity.h"

namespace pendular {

/// State of steady shear as the user requests it. The state is wet where a reduced pressure is
/// given; the amount of liquid is then either a bridge volume or a liquid content.
struct RequestedState {
    double friction = 0.09, inertial_number = 0;  ///< friction coefficient and inertial number [1]
    /// Reduced pressure P* [1], bridge volume over a^3 [1], liquid content Phi_L/Phi_S [1].
    std::optional<double> reduced_pressure, bridge_volume, liquid_content;
    double stiffness_number = 0;  ///< of the grains [1]; 0: that of most training runs

    /// Checks that the requested state is possible: numbers within their ranges, and the amount of
    /// liquid given in exactly one way where the state is wet.
    /// @throws InputError where it is not possible, naming the option of `pendular predict`
    void check_supported() const;

    /// Requested state in the coordinates of the emulator (friction, inertial number, 1/P*, bridge
    /// volume). A liquid content is converted to a bridge volume with the emulated coordination
    /// number.
    /// @throws InputError for a wet state where no run of atlas and store is wet, and for a dry
    ///         state where none is dry
    FlowState state(const Emulator& emulator, const KnownRange& known) const;
    /// Request for another state, `state`, with the amount of liquid given in the same way as in
    /// this request.
    RequestedState with(const FlowState& state, const Emulator& emulator) const;

    /// Text that describes the state, as in "friction 0.3, inertial number 0.01, reduced pressure
    /// 1, liquid content 0.03".
    std::string text() const;
    /// Options of `pendular predict` that request this state, as in "--friction 0.3".
    std::string options() const;
};

/// Parameters of the run that simulates a state of steady shear, with the number of grains and the
/// strain of a fidelity (set of simulation settings). An inertial number below the lowest one of
/// the fidelity is raised to it.
dem::RunParameters run_of(const FlowState& state, const Fidelity& fidelity,
                          double stiffness_number);

/// Reason why a run with these parameters cannot be simulated, the message of `check_run`; empty
/// where it can be simulated.
std::string why_impossible(const dem::RunParameters& run);

/// Command line of `pendular simulate` that simulates a run with parameters from `run_of`.
std::string simulate_command(const dem::RunParameters& run, const Fidelity& fidelity);

/// Error message for a state that the runs of atlas and store do not cover: the reason `why`, the
/// nearest state that they cover with the command that predicts it, and a command that simulates
/// instead.
std::string unsupported_text(const RequestedState& requested, const FlowState& state,
                             const std::string& why, const Emulator& emulator,
                             const KnownRange& known, const Fidelity& fidelity,
                             double stiffness_number);

/// Returns an unsupported state with its bridge volume computed again from the requested liquid
/// content, with the coordination number of the nearest supported state; the emulated coordination
/// number of the state itself would be unreliable. Unchanged where no liquid content is requested.
FlowState with_known_coordination(const RequestedState& requested, FlowState state,
                                  const Emulator& emulator, const KnownRange& known);

}  // namespace pendular
