#include "reports/run_report.h"

#include <fmt/format.h>

#include <algorithm>

#include "reports/with_error.h"

namespace pendular {
namespace {

void add_wet_step(Output& output, const LabRecording& recording, const LabStep& step) {
    const Mean& found = step.run[dem::Observable::liquid_content];
    const auto& wetting = *step.run.parameters.wetting;
    output.line(fmt::format("  {:<16} {:>11g} {:>9.3g} {:>9g} {:>10.3e}   {:g}: {}", recording.file,
                            step.condition.normal_stress, wetting.reduced_pressure,
                            step.condition.inertial_number, wetting.bridge_volume,
                            step.imposed.liquid_content,
                            with_error(found.value, found.standard_error)));
}

const char* what_pilots_found(const LabResult& result) {
    bool speeds = false, wet = false;
    for (const LabRecording& recording : result.recordings) {
        wet = wet || recording.liquid_content > 0;
        for (const LabStep& step : recording.steps)
            speeds = speeds || step.angular_velocity > 0;
    }
    return speeds && wet ? "heights and bridge volumes" : speeds ? "heights" : "bridge volumes";
}

}  // namespace

Output lab_output(const LabResult& result, const std::filesystem::path& folder) {
    Output output;
    const LabPlan& plan = result.plan;
    std::size_t steps = 0;
    for (const auto& recording : result.recordings) {
        steps += recording.steps.size();
    }
    const auto counted = [](std::size_t count, const char* what) {
        return fmt::format("{} {}{}", count, what, count == 1 ? "" : "s");
    };
    output.answer(fmt::format(
        "{} holds {} with {} in all, with noise {:g}; truth.json states the hidden friction{}.",
        folder.string(), counted(result.recordings.size(), "recording"), counted(steps, "step"),
        plan.instrument.noise, plan.effects.empty() ? "" : " and the hidden effects"));
    output.line(fmt::format(
        "Each step has its own simulation and seed: {} grains, stiffness number {:g}, averages "
        "over a strain of {:g}.{}",
        result.recordings.front().steps.front().run.parameters.grains,
        plan.fidelity.stiffness_number, plan.fidelity.strain,
        result.pilots > 0 ? fmt::format(" {} shorter simulations found the {}.", result.pilots,
                                        what_pilots_found(result))
                          : ""));
    if (std::ranges::any_of(contents_of(plan), [](double content) { return content > 0; })) {
        output.line(fmt::format("  {:<16} {:>11} {:>9} {:>9} {:>10}   {}", "wet", "normal",
                                "reduced", "inertial", "bridge", "liquid content"));
        output.line(fmt::format("  {:<16} {:>11} {:>9} {:>9} {:>10}   {}", "recording",
                                "stress [Pa]", "pressure", "number", "volume/a^3",
                                "requested: reached"));
    }
    for (const auto& recording : result.recordings) {
        for (const auto& step : recording.steps) {
            if (!step.imposed.dry()) add_wet_step(output, recording, step);
        }
    }
    output.notes(result.notes);
    return output;
}

}  // namespace pendular
