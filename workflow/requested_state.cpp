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

}  // namespace

/// Largest pressure, volume or content that is tried, and the inverse of the least [1]: far beyond
/// all simulations, and small enough that no power of it overflows.
constexpr double extreme = 1e9;

void RequestedState::check_supported() const {
    if (!(friction >= 0 && friction <= 1)) {
        throw InputError(fmt::format("--friction {}: 0 to 1 is needed", friction));
    }
    if (!(inertial_number >= 0 && inertial_number <= dem::largest_inertial_number)) {
        throw InputError(fmt::format("--inertial-number {}: 0 to {} is needed", inertial_number,
                                     dem::largest_inertial_number));
    }
    for (const auto& [name, value] :
         {std::pair("reduced-pressure", reduced_pressure),
          std::pair("bridge-volume", bridge_volume), std::pair("liquid-content", liquid_content)}) {
        if (value && !(*value > 0 && std::isfinite(*value))) {
            throw InputError(fmt::format("--{} {}: a positive number is needed", name, *value));
        }
        if (value && !(*value >= 1 / extreme && *value <= extreme)) {
            throw InputError(
                fmt::format("--{} {}: {:g} to {:g} is needed", name, *value, 1 / extreme, extreme));
        }
    }
    if (reduced_pressure && bridge_volume.has_value() == liquid_content.has_value()) {
        throw InputError("wet grains need either --bridge-volume or --liquid-content");
    }
    if (!reduced_pressure && (bridge_volume || liquid_content)) {
        throw InputError(
            "--bridge-volume and --liquid-content need --reduced-pressure: without it the grains "
            "are dry");
    }
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
