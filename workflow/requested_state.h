#pragma once

#include <optional>
#include <string>

#include "calib/emulator/known_range.h"
#include "sim/runs/run_settings.h"

namespace pendular {

/// State of steady shear that the user requests from `pendular predict`. The grains are wet if a
/// reduced pressure is given; the amount of liquid is then given either as a bridge volume or as a
/// liquid content.
struct RequestedState {
    double friction = 0.09, inertial_number = 0;                            ///< [1]
    std::optional<double> reduced_pressure, bridge_volume, liquid_content;  ///< [1]
    /// [1]; 0: the stiffness number of most training runs of the emulator.
    double stiffness_number = 0;

    /// Checks that the numbers lie within their ranges, and that the amount of liquid of a wet
    /// state is given in exactly one way.
    /// @throws InputError if not; the message names the option of `pendular predict` to change
    void check_supported() const;
    /// Returns what is wrong with a number that lies outside of its range, such as "friction nan: 0
    /// to 1 is needed"; else empty. For states of a program's user, who gives no options.
    /// @throws InputError if the amount of liquid of a wet state is not given in exactly one way
    std::string why_wrong() const;

    /// Returns the state in the coordinates of the emulator. A requested liquid content is
    /// converted to a bridge volume with the predicted coordination number.
    /// @param known range of states in which the earlier runs allow predictions
    /// @throws InputError if the state is wet but no earlier run is wet, or dry but no run is dry
    FlowState state(const Emulator& emulator, const KnownRange& known) const;
    /// Returns a request for `state` that gives the amount of liquid in the same way as this one.
    RequestedState with(const FlowState& state, const Emulator& emulator) const;

    /// Returns a text such as "friction 0.3, inertial number 0.01, reduced pressure 1, liquid
    /// content 0.03".
    std::string text() const;
    /// Returns the options of `pendular predict` that request the state, such as "--friction 0.3".
    std::string options() const;
};

/// Returns the parameters of the run that simulates a state. An inertial number below the lowest
/// one of `fidelity` is raised to it.
dem::RunParameters run_of(const FlowState& state, const Fidelity& fidelity,
                          double stiffness_number);

/// Returns the reason why a run cannot be simulated, such as a number outside its range; else
/// empty.
std::string why_impossible(const dem::RunParameters& run);

/// Returns the command line of `pendular simulate` for a run, with grains and strain of `fidelity`.
std::string simulate_command(const dem::RunParameters& run, const Fidelity& fidelity);

/// Returns the error message for a requested state outside the range of the earlier runs: the
/// reason `why`, the nearest state within the range and the command that predicts it, and last the
/// command that simulates the requested state, or the reason why that is impossible.
/// @param state the requested state in the coordinates of the emulator
std::string unsupported_text(const RequestedState& requested, const FlowState& state,
                             const std::string& why, const Emulator& emulator,
                             const KnownRange& known, const Fidelity& fidelity,
                             double stiffness_number);

/// Corrects the bridge volume of a state outside the range of the earlier runs, where the emulator
/// cannot predict the coordination number: computes it from the requested liquid content and the
/// coordination number at the nearest state within the range. Returns `state` unchanged if no
/// liquid content is requested.
FlowState with_known_coordination(const RequestedState& requested, FlowState state,
                                  const Emulator& emulator, const KnownRange& known);

}  // namespace pendular
