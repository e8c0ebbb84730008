#include "sim/lab/virtual_study.h"

#include <fmt/format.h>

#include <algorithm>
#include <numbers>

namespace pendular {
namespace {

std::string names_of_fidelities(double stiffness_number) {
    std::vector<std::string> names;
    for (const Fidelity& f : fidelities()) {
        if (f.stiffness_number == stiffness_number) names.push_back(f.name);
    }
    return fmt::format("{}", fmt::join(names, ", "));
}

std::string study_toml(const LabResult& result) {
    const LabPlan& plan = result.plan;
    const double kappa = plan.fidelity.stiffness_number;
    std::string text = fmt::format(
        "# Recordings of a virtual laboratory: simulated beads as an annular cell would have shown "
        "them.\n\n"
        "[grains]\n"
        "diameter = \"{:.7g} um\"\n"
        "density = \"{:.7g} kg/m^3\"\n"
        "poisson_ratio = {:.7g}\n",
        1e6 * plan.grains.diameter, plan.grains.density, plan.grains.poisson_ratio);
    text +=
        plan.grains.youngs_modulus
            ? fmt::format("youngs_modulus = \"{:.7g} GPa\"\n\n", 1e-9 * *plan.grains.youngs_modulus)
            : fmt::format(
                  "# No youngs_modulus: the beads were simulated at stiffness number "
                  "{:g}, whatever the normal stress.\n"
                  "# Use a fidelity that shares it ({}).\n\n",
                  kappa, names_of_fidelities(kappa));
    const std::vector<double> contents = contents_of(plan);
    if (*std::ranges::max_element(contents) > 0) {
        text += fmt::format(
            "[liquid]\n"
            "surface_tension = \"{:.7g} mN/m\"\n"
            "contact_angle = \"{:.7g} deg\"\n",
            1e3 * plan.liquid.surface_tension, plan.liquid.contact_angle * 180 / std::numbers::pi);
        if (plan.liquid.viscosity > 0) {
            text += fmt::format("viscosity = \"{:.7g} mPa.s\"\n", 1e3 * plan.liquid.viscosity);
        }
        text += "\n";
    }
    text += fmt::format(
        "[cell]\n"
        "inner_radius = \"{:.7g} mm\"\n"
        "outer_radius = \"{:.7g} mm\"\n"
        "bead_mass = \"{:.7g} g\"           # normal stress is normal force over area\n",
        1e3 * plan.cell.inner_radius, 1e3 * plan.cell.outer_radius,
        1e3 * plan.cell.bead_volume * plan.grains.density);
    for (const double content : contents) {
        text += content > 0 ? fmt::format(
                                  "\n[[recording]]\nfile = \"wet_{0:g}_*.csv\"\n"
                                  "liquid_content = {0:g}\n",
                                  content)
                            : "\n[[recording]]\nfile = \"dry_*.csv\"\nliquid_content = 0.0\n";
    }
    return text +
           "\n[model]\nbase = \"dem\"\ncalibrate = [\"friction\"]\nfit_to = \"dry\"\n"
           "effects = []\n";
}

/// Returns the true state of a step, with the typical relative standard errors of the laboratory's
/// runs.
TrueState true_state(const LabPlan& plan, const LabStep& step, double ratio_error,
                     double fraction_error) {
    Mean ratio = step.run[dem::Observable::stress_ratio];
    Mean fraction = step.run[dem::Observable::solid_fraction];
    ratio.standard_error = ratio_error * ratio.value;
    fraction.standard_error = fraction_error * fraction.value;
    TrueState state{step.condition, ratio, fraction};
    if (!plan.effects.empty()) {
        state.shown = shown_over_time(plan, step.condition, {ratio.value, fraction.value});
    }
    return state;
}

}  // namespace

std::map<std::string, std::string> study_files(const LabResult& result) {
    const double ratio_error = typical_error(result, dem::Observable::stress_ratio);
    const double fraction_error = typical_error(result, dem::Observable::solid_fraction);
    std::map<std::string, std::string> files = {{"study.toml", study_toml(result)}};
    for (const LabRecording& recording : result.recordings) {
        std::vector<TrueState> states;
        for (const LabStep& step : recording.steps) {
            states.push_back(true_state(result.plan, step, ratio_error, fraction_error));
        }
        files[recording.file] = recording_csv(record(states, result.plan.cell, result.plan.grains,
                                                     result.plan.instrument, recording.seed));
    }
    return files;
}

}  // namespace pendular
