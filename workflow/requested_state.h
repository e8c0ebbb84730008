#pragma once

#include <optional>
#include <string>

#include "calib/emulator/known_range.h"
#include "sim/runs/fidelity.h"

namespace pendular {

/// State of steady shear as the user requests it: wet where a reduced pressure is given, with the
/// liquid as a bridge volume or as a liquid content.
struct RequestedState {
    double friction = 0.09, inertial_number = 0;
    std::optional<double> reduced_pressure, bridge_volume, liquid_content;

    /// @throws InputError for what is no state
    void check_supported() const;

    /// State in the coordinates of the emulator; a liquid content is turned into a bridge volume by
    /// its coordination number.
    /// @throws InputError for a wet state where no known run has liquid bridges
    FlowState state(const Emulator& emulator, const KnownRange& known) const;
    /// Request of another state, with the liquid given as in this request.
    RequestedState with(const FlowState& state, const Emulator& emulator) const;

    /// State as text: "friction 0.3, inertial number 0.01, reduced pressure 1, liquid content
    /// 0.03".
    std::string text() const;
    /// Options of `pendular predict` that request this state.
    std::string options() const;
};

/// Run that simulates a state: at the fidelity's lowest inertial number where that of the state is
/// lower.
dem::RunParameters run_of(const FlowState& state, const Fidelity& fidelity,
                          double stiffness_number);

/// Message of `dem::check_run_parameters` for a run; empty where the run can be simulated.
std::string why_impossible(const dem::RunParameters& run);

/// Command that simulates a run of `run_of`.
std::string simulate_command(const dem::RunParameters& run, const Fidelity& fidelity);

/// Why no prediction is given at an unsupported state, the nearest supported state and the commands
/// that predict there and simulate.
std::string unsupported_text(const RequestedState& requested, const FlowState& state,
                             const std::string& why, const Emulator& emulator,
                             const KnownRange& known, const Fidelity& fidelity,
                             double stiffness_number);

/// An unsupported state with the bridge volume that its liquid content makes at the coordination
/// number of the nearest supported state, since the emulator's own is a guess there.
FlowState with_known_coordination(const RequestedState& requested, FlowState state,
                                  const Emulator& emulator, const KnownRange& known);

}  // namespace pendular
