#pragma once

#include <optional>
#include <string>

#include "calib/emulator/known_range.h"
#include "sim/runs/fidelity.h"

namespace pendular {

/// State of steady shear as the user requests it from `pendular predict`. The grains are wet where
/// a reduced pressure is given; the amount of liquid is then either a bridge volume or a liquid
/// content.
struct RequestedState {
    double friction = 0.09, inertial_number = 0;  ///< friction coefficient and inertial number [1]
    /// Reduced pressure P* [1], volume of a liquid bridge divided by the cubed grain diameter [1],
    /// and liquid content Phi_L/Phi_S, the liquid volume divided by the bead volume [1].
    std::optional<double> reduced_pressure, bridge_volume, liquid_content;
    /// Stiffness number of the grains [1]; 0: the stiffness number of most training runs.
    double stiffness_number = 0;

    /// Checks that the requested state is possible: its numbers lie within their ranges, and a wet
    /// state has its amount of liquid given in exactly one way.
    /// @throws InputError where the state is not possible; the message names the option of
    ///         `pendular predict` to change
    void check_supported() const;

    /// Returns the requested state in the coordinates of the emulator: friction, inertial number,
    /// 1/P* and bridge volume. A liquid content is converted to a bridge volume by means of the
    /// coordination number that the emulator predicts.
    /// @param known range of states in which the earlier simulation runs allow predictions
    /// @throws InputError for a wet state where no earlier run is wet, and for a dry state where no
    ///         earlier run is dry
    FlowState state(const Emulator& emulator, const KnownRange& known) const;
    /// Returns a request for another state, `state`. The new request gives a liquid content if this
    /// one does, else a bridge volume.
    RequestedState with(const FlowState& state, const Emulator& emulator) const;

    /// Text that describes the requested state, as in "friction 0.3, inertial number 0.01, reduced
    /// pressure 1, liquid content 0.03".
    std::string text() const;
    /// Options of `pendular predict` that request this state, as in "--friction 0.3".
    std::string options() const;
};

/// Parameters of the run that simulates a state of steady shear, with the number of grains and the
/// strain of `fidelity`, a set of simulation settings. An inertial number below the lowest one that
/// `fidelity` simulates is raised to that value.
dem::RunParameters run_of(const FlowState& state, const Fidelity& fidelity,
                          double stiffness_number);

/// Reason why a run with these parameters cannot be simulated, such as a number outside its range;
/// empty where the run can be simulated.
std::string why_impossible(const dem::RunParameters& run);

/// Command line of `pendular simulate` that simulates a run with these parameters. Number of grains
/// and strain are those of `fidelity`.
std::string simulate_command(const dem::RunParameters& run, const Fidelity& fidelity);

/// Error message for a requested state outside the range of the earlier simulation runs. It
/// contains the reason `why`, the nearest state within the range with the command that predicts it,
/// and the command that simulates the requested state instead.
/// @param state requested state in the coordinates of the emulator
std::string unsupported_text(const RequestedState& requested, const FlowState& state,
                             const std::string& why, const Emulator& emulator,
                             const KnownRange& known, const Fidelity& fidelity,
                             double stiffness_number);

/// Corrects the bridge volume of a state outside the range of the earlier simulation runs. The
/// volume follows from the requested liquid content and the coordination number, which the emulator
/// cannot predict reliably for `state`. The coordination number of the nearest state within the
/// range is used in its place. Returns `state` unchanged where no liquid content is requested.
FlowState with_known_coordination(const RequestedState& requested, FlowState state,
                                  const Emulator& emulator, const KnownRange& known);

}  // namespace pendular
