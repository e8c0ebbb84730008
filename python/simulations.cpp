#include <fmt/format.h>
#include <pybind11/stl.h>
#include <pybind11/stl/filesystem.h>

#include <algorithm>
#include <map>
#include <nlohmann/json.hpp>
#include <stdexcept>
#include <utility>

#include "data/input_error.h"
#include "data/quantities/number.h"
#include "data/quantities/units.h"
#include "python/bindings.h"
#include "python/convert.h"
#include "python/long_call.h"
#include "python/store.h"
#include "sim/runs/run_request.h"
#include "sim/runs/store/run_table.h"
#include "workflow/json/run.h"
#include "workflow/state_prediction.h"

namespace py = pybind11;

namespace pendular::python {
namespace {

using Path = std::filesystem::path;

/// Values of effects by "EFFECT.PARAMETER": numbers in SI units, or texts with a unit.
using EffectTexts = std::map<std::string, std::string>;

double value_in_si(const std::string& text, const std::string& unit) {
    const auto number = parse_number(text);
    return number ? *number : quantity_in_si(text, Unit(unit));
}

/// @throws std::invalid_argument for an unknown effect or parameter and a value that is none of it
void set(std::vector<ActiveEffect>& effects, const std::string& name, const std::string& text) {
    const std::size_t dot = std::min(name.find('.'), name.size());
    const Effect& effect = built_in_effect(name.substr(0, dot));
    const std::size_t place = effect.parameter(name.substr(std::min(dot + 1, name.size())));
    auto active = std::ranges::find(effects, &effect, &ActiveEffect::effect);
    if (active == effects.end())
        active = effects.insert(effects.end(), {&effect, effect.neutral()});
    const EffectParameter& parameter = effect.parameters[place];
    active->values[place] = value_in_si(text, parameter.unit);
    if (!(active->values[place] >= parameter.lower && active->values[place] <= parameter.upper))
        throw std::invalid_argument(fmt::format("{}: it must lie between {} and {}", text,
                                                printed_value(parameter.lower, parameter),
                                                printed_value(parameter.upper, parameter)));
}

/// Effects with their values, without those that change nothing.
/// @throws InputError for a name or value that is wrong
std::vector<ActiveEffect> effects_of(const EffectTexts& texts) {
    std::vector<ActiveEffect> effects;
    for (const auto& [name, text] : texts) {
        try {
            set(effects, name, text);
        } catch (const std::invalid_argument& error) {
            throw InputError(fmt::format("effects[\"{}\"]: {}", name, error.what()));
        }
    }
    std::erase_if(effects, [](const ActiveEffect& active) {
        return active.is_neutral() && !active.effect->given_by_liquid;
    });
    return effects;
}

/// Simulation that a user asks for. What is not stated belongs to the fidelity.
struct Wanted {
    Fidelity fidelity;
    dem::RunParameters run;
    std::vector<ActiveEffect> effects;
    RunScale scale;
};

Wanted wanted_run(const std::string& fidelity, double friction,
                  const std::optional<double>& inertial_number,
                  const std::optional<double>& stiffness_number,
                  const std::optional<double>& reduced_pressure, double bridge_volume,
                  const std::optional<int>& beads, const std::optional<double>& strain,
                  std::uint64_t seed, const EffectTexts& effects,
                  const std::map<std::string, double>& scale) {
    Wanted wanted{.fidelity = fidelity_named(fidelity), .run = {}, .effects = {}, .scale = {}};
    dem::RunParameters& run = wanted.run;
    run.friction = friction;
    run.inertial_number = inertial_number.value_or(wanted.fidelity.lowest_inertial_number);
    run.stiffness_number = stiffness_number.value_or(wanted.fidelity.stiffness_number);
    run.grains = beads.value_or(wanted.fidelity.grains);
    run.strain = strain.value_or(wanted.fidelity.strain);
    run.seed = seed;
    if (reduced_pressure)
        run.wetting = {.reduced_pressure = *reduced_pressure, .bridge_volume = bridge_volume};
    wanted.effects = effects_of(effects);
    wanted.scale.grains.diameter = scale.at("diameter");
    wanted.scale.grains.density = scale.at("density");
    wanted.scale.normal_stress = scale.at("normal_stress");
    wanted.scale.liquid.surface_tension = scale.at("surface_tension");
    wanted.scale = wanted.scale.of(run);
    return wanted;
}

/// @throws InputError where the run cannot be simulated
dem::RunParameters with_effects(const Wanted& wanted) {
    try {
        check_run(wanted.run);
        dem::RunParameters run = changed_run(wanted.run, wanted.effects, wanted.scale);
        check_run(run);
        return run;
    } catch (const std::invalid_argument& error) {
        throw InputError(error.what());
    }
}

nlohmann::ordered_json simulated(const Wanted& wanted, const dem::RunParameters& run, int threads,
                                 RunStore* store, const std::stop_token& stop,
                                 const Listener& listener) {
    constexpr double parts = 1000;  // of the progress; more would not show
    const auto progress = [&](double done, double expected) {
        tell(listener, {.kind = Event::Kind::refits,
                        .text = "simulation",
                        .number = static_cast<std::size_t>(parts * std::min(1.0, done / expected)),
                        .total = static_cast<std::size_t>(parts)});
    };
    const dem::RunResult result =
        simulate(run, {.stop = stop, .progress = progress, .threads = threads});
    if (store) store->add(result);
    const bool scaled = std::ranges::any_of(
        wanted.effects, [](const ActiveEffect& active) { return needs_scale(*active.effect); });
    Simulated whole{.run = result,
                    .without = wanted.run,
                    .effects = wanted.effects,
                    .scale = scaled ? std::optional(wanted.scale) : std::nullopt,
                    .scale_given = scaled,
                    .threads = threads};
    if (run.wetting) {
        try {
            whole.closures =
                StatePredictor(wanted.fidelity, store, run.stiffness_number).closures_of(result);
        } catch (const InputError&) {
            // No earlier runs predict the stress ratio of dry grains: there are no closures.
        }
    }
    return to_json(whole);
}

py::object stored_runs(const std::string& condition, bool atlas, const std::optional<Path>& file) {
    nlohmann::ordered_json json;
    {
        const py::gil_scoped_release release;
        if (atlas) {
            RunStore store(RunStore::in_memory);
            for (const StoredRun& run : read_runs(atlas_file()))
                store.add(run.run, run.physics_version);
            json = to_json(store.select(condition));
        } else {
            json =
                to_json(RunStore(file.value_or(RunStore::standard_file()), true).select(condition));
        }
    }
    return to_python(json);
}

}  // namespace

void bind_simulations(py::module_& module) {
    module.def("simulate", [](const py::object& on_event, const std::optional<Path>& store,
                              int threads, const std::string& fidelity, double friction,
                              const std::optional<double>& inertial_number,
                              const std::optional<double>& stiffness_number,
                              const std::optional<double>& reduced_pressure, double bridge_volume,
                              const std::optional<int>& beads, const std::optional<double>& strain,
                              std::uint64_t seed, const EffectTexts& effects,
                              const std::map<std::string, double>& scale) {
        const Wanted wanted =
            wanted_run(fidelity, friction, inertial_number, stiffness_number, reduced_pressure,
                       bridge_volume, beads, strain, seed, effects, scale);
        const dem::RunParameters run = with_effects(wanted);
        const std::shared_ptr<RunStore> opened = open_store(store);
        return to_python(long_call(on_event, [&](const auto& stop, const auto& listener) {
            return simulated(wanted, run, threads, opened.get(), stop, listener);
        }));
    });
    module.def("runs", stored_runs);
    module.def("standard_store", &RunStore::standard_file);
}

}  // namespace pendular::python
