#pragma once

#include <optional>
#include <string>
#include <vector>

#include "analysis/diagnosis/impact.h"
#include "sim/catalogue/resolved_study.h"
#include "workflow/study_diagnosis.h"

namespace pendular {

/// Step that a user should take after a diagnosis.
struct NextStep {
    std::string text;       ///< what to do, in one or more sentences
    bool readings = false;  ///< whether it is to take the readings of `pendular next`
    bool direct = false;    ///< whether it is a direct measurement of an effect
    /// Premise as the beginning of a sentence: "If the new readings agree with the old: ".
    std::string condition = {};
};

/// Returns the steps in the order in which to take them: checks of the instrument, direct
/// measurements of effects, readings (with the command that plans them), changes of the model. A
/// direct measurement states the value to expect, if known, and the largest standard error that
/// suffices to detect the effect: the change of the value by the effect over
/// sqrt(`telling_directly`).
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

}  // namespace pendular
