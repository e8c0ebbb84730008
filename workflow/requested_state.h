#pragma once

#include <optional>
#include <string>

#include "calib/emulator/known_range.h"
#include "sim/runs/fidelity.h"

namespace pendular {

/// State of steady shear that the user requests from `pendular predict`. The grains are wet if a
/// reduced pressure is given. The amount of liquid is then given either as a bridge volume or as a
/// liquid content.
struct RequestedState {
    double friction = 0.09, inertial_number = 0;  ///< friction coefficient and inertial number [1]
    /// Reduced pressure P* = a^2 s22/F0 [1] (a: grain diameter, s22: normal stress, F0: pull-off
    /// force of a bridge), volume of a liquid bridge divided by the cube of the grain diameter [1],
    /// and liquid content Phi_L/Phi_S (volume of liquid divided by volume of grains) [1]. Empty if
    /// not given.
    std::optional<double> reduced_pressure, bridge_volume, liquid_content;
    /// Stiffness number of the grains [1]. 0: the stiffness number of most simulation runs on which
    /// the emulator is trained.
    double stiffness_number = 0;

    /// Checks that the requested state is possible. The numbers must lie within their ranges, and
    /// the amount of liquid of a wet state must be given in exactly one way.
    /// @throws InputError if the state is not possible; the message names the option of `pendular
    ///         predict` to change
    void check_supported() const;

    /// Returns the requested state in the coordinates of the emulator: friction coefficient,
    /// inertial number, 1/P* (P*: reduced pressure) and bridge volume. A requested liquid content
    /// is converted to a bridge volume with the predicted coordination number.
    /// @param known range of states in which the earlier simulation runs allow predictions
    /// @throws InputError if the state is wet but no earlier run is wet, or if the state is dry but
    ///         no earlier run is dry
    FlowState state(const Emulator& emulator, const KnownRange& known) const;
    /// Returns a request for the state `state` that gives the amount of liquid in the same way as
    /// this request: as a liquid content or, otherwise, as a bridge volume.
    RequestedState with(const FlowState& state, const Emulator& emulator) const;

    /// Returns a text that describes the requested state, such as "friction 0.3, inertial number
    /// 0.01, reduced pressure 1, liquid content 0.03".
    std::string text() const;
    /// Returns the options of `pendular predict` that request the state, such as "--friction 0.3".
    std::string options() const;
};

/// Returns the parameters of the run that simulates a state of steady shear, with the number of
/// grains and the strain of `fidelity`, a set of simulation settings. An inertial number below the
/// lowest inertial number of `fidelity` is raised to that lowest inertial number.
/// @param stiffness_number stiffness number of the grains [1]
dem::RunParameters run_of(const FlowState& state, const Fidelity& fidelity,
                          double stiffness_number);

/// Returns the reason why a run with the parameters `run` cannot be simulated, such as a number
/// outside its range. Empty if the run can be simulated.
std::string why_impossible(const dem::RunParameters& run);

/// Returns the command line of `pendular simulate` that simulates a run with the parameters `run`,
/// with the number of grains and the strain of `fidelity`, a set of simulation settings.
std::string simulate_command(const dem::RunParameters& run, const Fidelity& fidelity);

/// Returns the error message for a requested state that lies outside the range of the earlier
/// simulation runs. The message states the reason `why`, the nearest state within the range, and
/// the command that predicts stress ratio and solid fraction at that nearest state. The last line
/// is the command that simulates the requested state, or the reason why this simulation is
/// impossible.
/// @param requested state as the user specified it
/// @param state the requested state in the coordinates of the emulator
std::string unsupported_text(const RequestedState& requested, const FlowState& state,
                             const std::string& why, const Emulator& emulator,
                             const KnownRange& known, const Fidelity& fidelity,
                             double stiffness_number);

/// Corrects the bridge volume of a state outside the range of the earlier simulation runs. The
/// emulator cannot predict the coordination number at such a state. The bridge volume is therefore
/// computed from the requested liquid content and the coordination number at the nearest state
/// within the range. Returns `state` unchanged if no liquid content is requested.
FlowState with_known_coordination(const RequestedState& requested, FlowState state,
                                  const Emulator& emulator, const KnownRange& known);

}  // namespace pendular
