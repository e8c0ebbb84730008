#include "reports/run_report.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>

#include "calib/emulator/emulated_observables.h"
#include "data/quantities/quantity.h"
#include "reports/with_error.h"
#include "reports/words.h"
#include "sim/runs/run_request.h"
#include "workflow/json/commands.h"

namespace pendular {

std::string observable_line(dem::Observable which, const Mean& mean) {
    const Quantity& about = quantity(dem::observable_names[static_cast<std::size_t>(which)]);
    return fmt::format("  {:<32} {:<22} {}", about.name,
                       with_error(mean.value, mean.standard_error), about.meaning);
}

namespace {

/// Adds the liquid of a simulation of wet grains.
void add_liquid(Output& output, const dem::RunResult& run) {
    const dem::RunParameters& p = run.parameters;
    output.line(fmt::format(
        "Reduced pressure {:g} and bridge volume {:g} a^3 give a liquid content of {}; {} of "
        "the liquid is in bridges without contact.",
        p.wetting->reduced_pressure, p.wetting->bridge_volume,
        with_error(run[dem::Observable::liquid_content].value,
                   run[dem::Observable::liquid_content].standard_error),
        fmt::format("{:.0f} %", 100 * run[dem::Observable::distant_coordination].value /
                                    (run[dem::Observable::distant_coordination].value +
                                     run[dem::Observable::contact_coordination].value))));
    if (p.wetting->bridge_volume > dem::largest_pendular_volume) {
        output.note(fmt::format(
            "The bridge volume {:g} a^3 is above {:g} a^3, where the bridges between three "
            "grains in contact merge: the model holds for separate bridges.",
            p.wetting->bridge_volume, dem::largest_pendular_volume));
    }
}

/// Adds the effects, a friction coefficient or reduced pressure that they changed and, if an effect
/// has parameters in SI units, the scale. If none has but the user gave the scale, a note says that
/// the scale changes nothing.
void add_effects(Output& output, const Simulated& simulated) {
    const dem::RunParameters &changed = simulated.run.parameters, &without = simulated.without;
    std::string text;
    for (const ActiveEffect& active : simulated.effects) {
        text += (text.empty() ? "With " : ", ") + to_string(active);
    }
    if (changed.friction != without.friction) {
        text += fmt::format("; friction {:g} in place of {:g}", changed.friction, without.friction);
    }
    if (!changed.wetting && without.wetting) {
        text += "; the grains are dry";
    } else if (changed.wetting &&
               changed.wetting->reduced_pressure != without.wetting->reduced_pressure) {
        text += fmt::format("; reduced pressure {:.4g} in place of {:g}",
                            changed.wetting->reduced_pressure, without.wetting->reduced_pressure);
    }
    if (!text.empty()) {
        output.line(text + ".");
    }
    if (const auto& scale = simulated.scale) {
        output.line(fmt::format(
            "The normal stress is {:.4g} Pa, on grains of {:.4g} um and {:g} kg/m^3{}.",
            scale->normal_stress, 1e6 * scale->grains.diameter, scale->grains.density,
            without.wetting
                ? fmt::format(", surface tension {:.4g} mN/m", 1e3 * scale->liquid.surface_tension)
                : ""));
    } else if (simulated.scale_given) {
        output.note(
            "no effect of this simulation has a parameter in SI units: --diameter, --density, "
            "--normal-stress and --surface-tension change nothing");
    }
}

/// Adds notes on what limits the averages of a simulation.
void add_notes(Output& output, const dem::RunResult& run) {
    const dem::RunParameters& p = run.parameters;
    if (const Mean& banded = run[dem::Observable::localization];
        banded.value > dem::localised_above) {
        output.note(
            fmt::format("The shear is localised: its localisation (0: uniform shear, 1: a thin "
                        "band) is {}, above the limit of {}.{}",
                        with_error(banded.value, banded.standard_error), dem::localised_above,
                        banded.value > emulated::banded_above
                            ? " The emulator is not trained on this simulation."
                            : ""));
    }
    if (run.crystallised) {
        output.note(
            "The sample crystallised: its averages are not those of a random packing. Use another "
            "seed, more grains or a higher friction.");
    }
    for (const dem::Precision& wanted : p.precision) {
        const double reached = run[wanted.which].standard_error;
        if (reached > wanted.standard_error) {
            output.note(
                fmt::format("The standard error of {} is {:.2g} after averaging over a strain of "
                            "{:.3g}; the request was {:g}: raise --strain or --beads.",
                            dem::observable_names[static_cast<std::size_t>(wanted.which)], reached,
                            run.strain_averaged, wanted.standard_error));
        }
    }
    if (!run.steady) {
        output.note("No steady state was found within the simulated strain: raise --strain.");
    }
}

/// First line of the answer, "Predicted at friction 0.12, inertial number 0 (quasi-static), dry:
/// stress ratio 0.30 +- 0.01, solid fraction 0.600 +- 0.001."; `how` is the first word.
std::string answer_of(const char* how, const RequestedState& at, const Mean& stress_ratio,
                      const Mean& solid_fraction) {
    return fmt::format("{} at {}: stress ratio {}, solid fraction {}.", how, at.text(),
                       with_error(stress_ratio.value, stress_ratio.standard_error),
                       with_error(solid_fraction.value, solid_fraction.standard_error));
}

/// Adds notes where the simulated state differs from the requested state, crystallised or is not
/// steady.
void note_differences(Output& output, const RequestedState& requested, const dem::RunResult& run) {
    if (run.parameters.inertial_number != requested.inertial_number) {
        output.note(
            fmt::format("The simulation has an inertial number of {:g}, the lowest one at this "
                        "fidelity, instead "
                        "of {:g}.",
                        run.parameters.inertial_number, requested.inertial_number));
    }
    if (requested.liquid_content) {
        const Mean& content = run[dem::Observable::liquid_content];
        output.note(fmt::format("The simulation has a liquid content of {}; the request was {:g}.",
                                with_error(content.value, content.standard_error),
                                *requested.liquid_content));
    }
    if (run.crystallised) {
        output.note("The sample crystallised: its averages are not those of a random packing.");
    }
    if (!run.steady) {
        output.note("The simulation found no steady state; a higher fidelity shears longer.");
    }
}

std::string wetness(const dem::RunParameters& p) {
    return p.wetting ? fmt::format("{:>8.3g} {:>8.3g}", p.wetting->reduced_pressure,
                                   p.wetting->bridge_volume)
                     : fmt::format("{:>8} {:>8}", "dry", "");
}

std::string flags(const dem::RunResult& run) {
    std::vector<std::string> words;
    const auto flag = [&](bool holds, const char* word) {
        if (holds) {
            words.emplace_back(word);
        }
    };
    if (!run.failure.empty()) {
        return "failed";
    }
    flag(run.crystallised, "crystallised");
    flag(!run.steady, "not steady");
    flag(run[dem::Observable::localization].value > dem::localised_above, "localised");
    return fmt::format("{}", fmt::join(words, ", "));
}

/// Text of the effects of a run, preceded by `before`; empty for a run without effects.
std::string with_effects(const dem::RunParameters& p, const std::string& before) {
    return p.effects.empty() ? "" : before + effects_text(p.effects);
}

}  // namespace

void add_closures(Output& output, const closures::ClosureValues& values, double stress_ratio) {
    output.line(fmt::format(
        "Formulas of Badetti et al. (2018), evaluated with the values above, without standard "
        "errors (for comparison: the stress ratio above is {:.4g}):",
        stress_ratio));
    for (const auto& each : closures::closure_quantities) {
        output.line(fmt::format("  {:<52} {:.4g}", each.text, values.*each.value));
    }
}

Output closures_output(const std::optional<closures::ClosureValues>& values, double stress_ratio) {
    Output output;
    if (values) {
        add_closures(output, *values, stress_ratio);
    } else {
        output.line(
            "The formulas of Badetti et al. (2018) are not evaluated: they need the stress ratio "
            "of "
            "dry grains, which the simulations in atlas and store do not give for this friction, "
            "inertial number, damping and these effects.");
    }
    return output;
}

Output simulation_output(const Simulated& simulated) {
    const dem::RunResult& run = simulated.run;
    Output output;
    const auto& p = run.parameters;
    output.answer(
        fmt::format("Simulated: stress ratio {}, solid fraction {} at friction {:g}, inertial "
                    "number {:g}, stiffness number {:g}.",
                    with_error(run[dem::Observable::stress_ratio].value,
                               run[dem::Observable::stress_ratio].standard_error),
                    with_error(run[dem::Observable::solid_fraction].value,
                               run[dem::Observable::solid_fraction].standard_error),
                    p.friction, p.inertial_number, p.stiffness_number));
    add_effects(output, simulated);
    if (p.wetting) add_liquid(output, run);
    add_notes(output, run);
    for (std::size_t k = 0; k < dem::observable_count; ++k) {
        if (!p.wetting && dem::needs_bridges(static_cast<dem::Observable>(k))) {
            continue;
        }
        output.line(observable_line(static_cast<dem::Observable>(k), run.means[k]));
    }
    output.line(fmt::format(
        "{} grains; averages over a strain of {:.2f} after a transient strain of {:.2f}; {} time "
        "steps, each {:.3g} sqrt(m/(a s22)) (m: grain mass, a: grain diameter, s22: normal "
        "stress); computing time {:.1f} s, {:.3g} grain updates per second.",
        p.grains, run.strain_averaged, run.strain_transient, run.steps, run.time_step,
        run.wall_seconds, run.particle_steps_per_second()));
    return output;
}

Output simulated_output(const RequestedState& requested, const dem::RunParameters& wanted,
                        const dem::RunResult& run, const Fidelity& fidelity,
                        const RunStore* store) {
    RequestedState at = requested;
    at.inertial_number = run.parameters.inertial_number;
    Output output;
    output.answer(answer_of("Simulated", at, run[dem::Observable::stress_ratio],
                            run[dem::Observable::solid_fraction]));
    for (const dem::Observable which : observables_of(emulated::flow_state_of(wanted))) {
        output.line(observable_line(which, run[which]));
    }
    output.line(fmt::format(
        "Simulated at {} fidelity, since the simulations in atlas and store do not cover this "
        "state: {} grains, averages over a strain of {:.3g}, stiffness number {:.4g}.{}",
        fidelity.name, wanted.grains, run.strain_averaged, wanted.stiffness_number,
        store ? " The result is in " + store->file().string() + "." : ""));
    note_differences(output, requested, run);
    return output;
}

Output prediction_output(const RequestedState& requested, const StatePrediction& prediction,
                         bool simulates) {
    const auto predicted = [&prediction](dem::Observable which) {
        const auto found = std::ranges::find_if(
            prediction.observables, [which](const auto& one) { return one.which == which; });
        return Mean{found->value.value, found->value.standard_error};
    };
    Output output;
    output.answer(answer_of("Predicted", requested, predicted(dem::Observable::stress_ratio),
                            predicted(dem::Observable::solid_fraction)));
    for (const auto& one : prediction.observables) {
        output.line(observable_line(one.which, {one.value.value, one.value.standard_error}));
    }
    if (prediction.closures) {
        add_closures(output, *prediction.closures, predicted(dem::Observable::stress_ratio).value);
    }
    output.line(fmt::format(
        "The emulator was trained on {} simulations{}; the predictions hold for stiffness "
        "number {:.4g}.",
        prediction.runs, simulates ? ", which cover this state: nothing was simulated" : "",
        prediction.stiffness_number));
    return output;
}

Output curve_output(const PredictionCurve& curve, int points, std::size_t runs,
                    const std::filesystem::path& folder) {
    Output output;
    output.answer(fmt::format("{} states, predicted from {} simulations, are written to {} and {}.",
                              curve.at.size(), runs, (folder / "prediction.csv").string(),
                              (folder / "figures" / "prediction.png").string()));
    if (curve.left_out > 0) {
        output.note(
            fmt::format("{} of {} states are left out, since the simulations in atlas and store do "
                        "not cover them ({}). The curve covers {} {:.4g} to {:.4g}. 'pendular "
                        "simulate' and 'pendular campaign' extend the range.",
                        curve.left_out, points, curve.why_left_out, spoken(curve.variable),
                        curve.at.front(), curve.at.back()));
    }
    return output;
}

Output runs_output(const std::vector<StoredRun>& runs) {
    Output output;
    const bool effects = std::ranges::any_of(
        runs, [](const StoredRun& stored) { return !stored.run.parameters.effects.empty(); });
    output.answer(fmt::format("{} simulation{}.", runs.size(), runs.size() == 1 ? "" : "s"));
    output.line(
        "                inertial  reduced   bridge stiffness               stress              "
        "solid");
    output.line(fmt::format(
        "  run friction    number pressure   volume    number grains strain ratio               "
        "fraction            remarks{}",
        effects ? "       effects" : ""));
    for (const auto& [id, version, run] : runs) {
        const auto& p = run.parameters;
        const Mean &ratio = run[dem::Observable::stress_ratio],
                   &solid = run[dem::Observable::solid_fraction];
        std::string row = fmt::format(
            "{:>5} {:>8.4g} {:>9.3g} {} {:>9.4g} {:>6} {:>6.3g} {:<19} {:<19} {:<13} {}", id,
            p.friction, p.inertial_number, wetness(p), p.stiffness_number, p.grains, p.strain,
            run.failure.empty() ? with_error(ratio.value, ratio.standard_error) : "",
            run.failure.empty() ? with_error(solid.value, solid.standard_error) : "", flags(run),
            with_effects(p, ""));
        row.erase(row.find_last_not_of(' ') + 1);
        output.line(row);
    }
    output.line(
        fmt::format("  (reduced pressure: P* = a^2 s22/F0; bridge volume: V0/a^3; a: grain "
                    "diameter, s22: normal "
                    "stress, F0: pull-off force of a bridge{})",
                    effects ? "; effects: in units of a, s22 and the grain mass" : ""));
    return output;
}

Output run_output(const StoredRun& stored) {
    Output output;
    output.line(fmt::format("run {}\n{}", stored.id,
                            run_description(stored.run.parameters, stored.run.threads)));
    for (std::size_t k = 0; k < dem::observable_count; ++k) {
        const auto which = static_cast<dem::Observable>(k);
        if (stored.run.parameters.wetting || !dem::needs_bridges(which)) {
            output.line(observable_line(which, stored.run[which]));
        }
    }
    if (const std::string words = flags(stored.run); !words.empty()) {
        output.note(words + (stored.run.failure.empty() ? "" : ": " + stored.run.failure));
    }
    return output;
}

Output difference_output(const StoredRun& first, const StoredRun& second) {
    Output output;
    output.line(fmt::format("{:<32} {:>20} {:>20} {:>26}", "", fmt::format("run {}", first.id),
                            fmt::format("run {}", second.id), "(second - first)/std. err."));
    for (const StoredRun* stored : {&first, &second}) {
        if (!stored->run.parameters.effects.empty()) {
            output.line(with_effects(stored->run.parameters,
                                     fmt::format("run {} has the effects ", stored->id)));
        }
    }
    for (const auto& [which, difference, standardised] : differences(first.run, second.run)) {
        const Mean &a = first.run[which], &b = second.run[which];
        output.line(fmt::format("{:<32} {:>20} {:>20} {:>26.1f}",
                                dem::observable_names[static_cast<std::size_t>(which)],
                                with_error(a.value, a.standard_error),
                                with_error(b.value, b.standard_error), standardised));
    }
    return output;
}

Output campaign_output(const CampaignState& state, const std::vector<dem::RunResult>& failed) {
    Output output;
    for (const auto& run : failed) {
        output.note(fmt::format(
            "The simulation with friction {}, inertial number {} and seed {} failed: {}",
            run.parameters.friction, run.parameters.inertial_number, run.parameters.seed,
            run.failure));
    }
    output.answer(fmt::format("{} of {} simulations are in {}: {} new, {} failed.", state.stored,
                              state.runs, state.store.string(), state.made, state.failed));
    return output;
}

Output plan_output(const CampaignState& state, int threads, const std::string& source) {
    const std::size_t missing = state.runs - state.stored;
    Output output;
    output.answer(fmt::format("{} of {} simulations are in {}; remaining: {}.", state.stored,
                              state.runs, state.store.string(), missing));
    const auto seconds = state.seconds.value_or(std::nullopt);
    if (missing > 0 && !seconds) {
        output.line("The duration cannot be estimated: the store holds no simulation.");
    } else if (missing > 0) {
        output.line(
            fmt::format("Estimated duration of what remains: about {} on {} thread{}, from {}.",
                        duration(*seconds), threads, threads == 1 ? "" : "s", source));
    }
    return output;
}

}  // namespace pendular
