#pragma once

#include <optional>
#include <string>
#include <vector>

#include "analysis/diagnosis/impact.h"
#include "reports/figure.h"
#include "reports/output.h"
#include "sim/catalogue/resolved_study.h"
#include "workflow/next.h"
#include "workflow/study_diagnosis.h"

namespace pendular {

/// Step that a user should take after a diagnosis.
struct NextStep {
    std::string text;       ///< what to do, in one or more sentences
    bool readings = false;  ///< whether it is to take the readings of `pendular next`
    bool direct = false;    ///< whether it is a direct measurement of an effect
    /// Premise as the beginning of a sentence: "If the new readings agree with the old: ".
    std::string condition = {};
    std::string add = {};  ///< effect that it adds to the model; empty: none
};

/// Returns the steps in the order in which to take them: checks of the instrument, direct
/// measurements of effects, readings (with the command that plans them), changes of the model. A
/// direct measurement states the value to expect, if known, and the largest standard error that
/// suffices to detect the effect: the change of the value by the effect over
/// sqrt(`telling_directly`).
/// Readings that cannot be planned (`can_plan`) are no step.
/// @param impacts used to choose among effects that could go undetected
/// @param study name of the study as the user gave it
std::vector<NextStep> next_steps(const StudyDiagnosis& diagnosis,
                                 const std::optional<ImpactTable>& impacts,
                                 const ResolvedStudy& resolved, const std::string& study);

/// Returns the steps as numbered lines below a heading. If a step is a direct measurement, a last
/// line says how to enter the result into study.toml.
/// @param plan lines on the planned readings (`plan_lines`), which take the place of the step that
///        asks for readings; may be empty
std::vector<std::string> step_lines(const std::vector<NextStep>& steps,
                                    const std::vector<std::string>& plan = {});

/// Returns the first step among the lines of `step_lines`, without its number; empty if none.
std::string first_step(const std::vector<std::string>& lines);

/// Returns the text of each step after its premise.
std::vector<std::string> texts_of(const std::vector<NextStep>& steps);

/// Returns the command to give after a diagnosis. It adds an effect only if the verdict names it as
/// missing, and never a change of unknown cause.
/// @param study name of the study as the user gave it
std::string next_command(const Diagnosis& diagnosis, const std::vector<NextStep>& steps,
                         const std::string& study);

/// Returns lines on the next readings to take. If one model fits, they list the standard errors of
/// its parameters before and after these readings. If several fit, they list the measurements that
/// tell the models apart with the prediction of each model or, if no possible readings do, say so
/// and state the predictions where these differ most.
std::vector<std::string> plan_lines(const NextMeasurement& next);

/// Returns what `pendular next` says: what to do, in order, with the plan of the readings.
/// @param has_rig whether study.toml states the settings that the rheometer can reach
Output next_output(const NextMeasurement& next, const StudyDiagnosis& diagnosis,
                   const std::vector<NextStep>& steps, bool has_rig);

/// Returns a figure of the predicted stress ratio and solid fraction against the normal stress, as
/// differences from those of the first model [%], with a curve and a band of one standard error for
/// each of up to four models that fit. All other
/// quantities are those of the first suggested reading or, without any, of the reading for which
/// the predictions differ most. Vertical lines mark the normal stresses of the suggested readings,
/// or the normal stress where the predictions differ most. Without panels if only one model fits,
/// or if all possible measurements are direct measurements.
Figure next_figure(const NextMeasurement& next);

}  // namespace pendular
