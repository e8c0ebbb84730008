#include "workflow/requested_state.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <utility>

#include "calib/emulator/emulated_state.h"
#include "data/input_error.h"
#include "sim/runs/run_request.h"

namespace pendular {
namespace {

/// List of the quantities that a request gives, with their values: as options of `pendular predict`
/// or as text.
std::string listed(const RequestedState& state, bool as_options) {
    std::string text;
    const auto add = [&](const char* option, const char* name, const std::optional<double>& value) {
        if (value) {
            text += as_options
                        ? fmt::format("{}--{} {:.4g}", text.empty() ? "" : " ", option, *value)
                        : fmt::format("{}{} {:.4g}", text.empty() ? "" : ", ", name, *value);
        }
    };
    add("friction", "friction", state.friction);
    add("inertial-number", "inertial number", state.inertial_number);
    add("reduced-pressure", "reduced pressure", state.reduced_pressure);
    add("bridge-volume", "bridge volume over a^3", state.bridge_volume);
    add("liquid-content", "liquid content", state.liquid_content);
    return text;
}

/// Reason why a state is not covered, with the requested liquid content beside the bridge volume
/// that follows from it.
std::string with_liquid_content(const RequestedState& requested, std::string why) {
    const std::string name = "bridge volume over a^3 ";
    const auto at = why.find(name);
    if (!requested.liquid_content || at == std::string::npos) return why;
    const auto end = std::min(why.find(' ', at + name.size()), why.size());
    return why.insert(end, fmt::format(" (liquid content {:.4g})", *requested.liquid_content));
}

/// Largest pressure, volume or content that is tried, and the inverse of the least [1]: far beyond
/// all simulations, and small enough that no power of it overflows.
constexpr double extreme = 1e9;

/// Name of a quantity, such as "bridge-volume": as an option of `pendular predict` or in words.
std::string called(std::string name, bool as_option) {
    if (as_option) return "--" + name;
    std::ranges::replace(name, '-', ' ');
    return name;
}

/// Text that says which number of a state lies outside of its range; empty: none does.
std::string wrong_number(const RequestedState& state, bool as_options) {
    if (!(state.friction >= 0 && state.friction <= 1)) {
        return fmt::format("{} {}: 0 to 1 is needed", called("friction", as_options),
                           state.friction);
    }
    if (!(state.inertial_number >= 0 && state.inertial_number <= dem::largest_inertial_number)) {
        return fmt::format("{} {}: 0 to {} is needed", called("inertial-number", as_options),
                           state.inertial_number, dem::largest_inertial_number);
    }
    for (const auto& [name, value] : {std::pair("reduced-pressure", state.reduced_pressure),
                                      std::pair("bridge-volume", state.bridge_volume),
                                      std::pair("liquid-content", state.liquid_content)}) {
        if (value && !(*value > 0 && std::isfinite(*value))) {
            return fmt::format("{} {}: a positive number is needed", called(name, as_options),
                               *value);
        }
        if (value && !(*value >= 1 / extreme && *value <= extreme)) {
            return fmt::format("{} {}: {:g} to {:g} is needed", called(name, as_options), *value,
                               1 / extreme, extreme);
        }
    }
    return {};
}

/// @throws InputError if the amount of liquid is not given in exactly one way
void check_amount(const RequestedState& state, bool as_options) {
    const std::string volume = called("bridge-volume", as_options),
                      content = called("liquid-content", as_options);
    if (state.reduced_pressure &&
        state.bridge_volume.has_value() == state.liquid_content.has_value()) {
        throw InputError(fmt::format("wet grains need either {} or {}", volume, content));
    }
    if (!state.reduced_pressure && (state.bridge_volume || state.liquid_content)) {
        throw InputError(fmt::format("{} and {} need {}: without it the grains are dry", volume,
                                     content, called("reduced-pressure", as_options)));
    }
}

}  // namespace

void RequestedState::check_supported() const {
    if (const std::string wrong = wrong_number(*this, true); !wrong.empty())
        throw InputError(wrong);
    check_amount(*this, true);
}

std::string RequestedState::why_wrong() const {
    check_amount(*this, false);
    return wrong_number(*this, false);
}

FlowState RequestedState::state(const Emulator& emulator, const KnownRange& known) const {
    FlowState result{friction, inertial_number};
    result.stiffness_number = stiffness_number;
    if (reduced_pressure) {
        if (!known.knows_wet()) {
            throw InputError(
                "no simulation in atlas and store has liquid bridges, so that wet states cannot be "
                "predicted; 'pendular campaign' makes such simulations");
        }
        result.inverse_pressure = 1 / *reduced_pressure;
        result.bridge_volume =
            bridge_volume ? *bridge_volume : bridge_volume_of(emulator, *liquid_content, result);
    } else if (!known.knows_dry()) {
        throw InputError(
            "no simulation in atlas and store is dry, so that dry states cannot be predicted; "
            "'pendular campaign' makes such simulations");
    }
    return result;
}

RequestedState RequestedState::with(const FlowState& state, const Emulator& emulator) const {
    RequestedState other{.friction = state.friction,
                         .inertial_number = state.inertial_number,
                         .stiffness_number = stiffness_number};
    if (!state.dry()) {
        other.reduced_pressure = 1 / state.inverse_pressure;
        if (liquid_content) {
            other.liquid_content =
                dem::liquid_content(state.bridge_volume, coordination(emulator, state).value);
        } else {
            other.bridge_volume = state.bridge_volume;
        }
    }
    return other;
}

std::string RequestedState::text() const {
    std::string text = listed(*this, false);
    if (inertial_number == 0) {
        const std::string zero = "inertial number 0";
        text.insert(text.find(zero) + zero.size(), " (quasi-static)");
    }
    return reduced_pressure ? text : text + ", dry";
}

std::string RequestedState::options() const {
    return listed(*this, true);
}

dem::RunParameters run_of(const FlowState& state, const Fidelity& fidelity,
                          double stiffness_number) {
    dem::RunParameters run{
        .friction = state.friction,
        .inertial_number = std::max(state.inertial_number, fidelity.lowest_inertial_number),
        .stiffness_number = stiffness_number,
        .grains = fidelity.grains,
        .strain = fidelity.strain};
    if (!state.dry()) {
        run.wetting = {.reduced_pressure = 1 / state.inverse_pressure,
                       .bridge_volume = state.bridge_volume};
    }
    return run;
}

std::string why_impossible(const dem::RunParameters& run) {
    try {
        check_run(run);
    } catch (const std::invalid_argument& error) {
        return error.what();
    }
    return {};
}

std::string simulate_command(const dem::RunParameters& run, const Fidelity& fidelity) {
    std::string command =
        fmt::format("pendular simulate --friction {:.4g} --inertial-number {:.4g}", run.friction,
                    run.inertial_number);
    if (run.wetting) {
        command += fmt::format(" --reduced-pressure {:.4g} --bridge-volume {:.4g}",
                               run.wetting->reduced_pressure, run.wetting->bridge_volume);
    }
    if (run.stiffness_number != fidelity.stiffness_number) {
        command += fmt::format(" --stiffness-number {:.6g}", run.stiffness_number);
    }
    return command + " --fidelity " + fidelity.name;
}

FlowState with_known_coordination(const RequestedState& requested, FlowState state,
                                  const Emulator& emulator, const KnownRange& known) {
    if (requested.liquid_content) {
        FlowState nearest = known.nearest_supported(state);
        nearest.stiffness_number = state.stiffness_number;
        state.bridge_volume =
            dem::bridge_volume(*requested.liquid_content, coordination(emulator, nearest).value);
    }
    return state;
}

std::string unsupported_text(const RequestedState& requested, const FlowState& state,
                             const std::string& why, const Emulator& emulator,
                             const KnownRange& known, const Fidelity& fidelity,
                             double stiffness_number) {
    FlowState nearest = known.nearest_supported(state);
    nearest.stiffness_number = state.stiffness_number;
    const RequestedState nearest_request = requested.with(nearest, emulator);
    const auto run = run_of(with_known_coordination(requested, state, emulator, known), fidelity,
                            stiffness_number);
    const std::string impossible = why_impossible(run);
    return fmt::format(
        "the simulations in atlas and store do not cover {}: {}.\n"
        "  The nearest state within the range of the simulations has {}:\n"
        "    pendular predict {}\n"
        "  {}",
        requested.text(), with_liquid_content(requested, why), nearest_request.text(),
        nearest_request.options(),
        impossible.empty()
            ? "To simulate the requested state, add --simulate, or:\n    " +
                  simulate_command(run, fidelity)
            : fmt::format("The requested state cannot be simulated either: {}.", impossible));
}

}  // namespace pendular
