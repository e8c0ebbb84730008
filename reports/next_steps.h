#pragma once

#include <optional>
#include <string>
#include <vector>

#include "analysis/diagnosis/impact.h"
#include "sim/catalogue/resolved_study.h"
#include "workflow/study_diagnosis.h"

namespace pendular {

/// One of the steps that a user should take after a diagnosis, such as a measurement or a change of
/// the model.
struct NextStep {
    std::string text;  ///< what to do, in one or more sentences
    /// Whether the step is to take the readings that `pendular next` plans.
    bool readings = false;
    /// Whether the step is to measure an effect's parameter directly, without shearing grains.
    bool direct = false;
    /// Premise of the step as the beginning of a sentence, such as "If the new readings agree with
    /// the old: ". Empty if the step has no premise.
    std::string condition = {};
};

/// Returns the steps to take after a diagnosis, in the order in which the user should take the
/// steps. The steps are checks of the instrument, direct measurements of effects (without shearing
/// grains), readings, and changes of the model. A step for a direct measurement states the value to
/// expect, if known, and the largest standard error that suffices to detect the effect: the change
/// of the value by the effect, divided by sqrt(`telling_directly`). A step for readings names the
/// command that plans the readings.
/// @param impacts shifts of the fitted friction coefficient by each effect; used to choose among
///        effects that could go undetected
/// @param study name of the study as the user gave it
std::vector<NextStep> next_steps(const StudyDiagnosis& diagnosis,
                                 const std::optional<ImpactTable>& impacts,
                                 const ResolvedStudy& resolved, const std::string& study);

/// Returns the steps after a diagnosis as numbered lines below a heading. If a step asks for a
/// direct measurement, a last line says how to enter the result into study.toml.
/// @param plan lines on the planned readings (`plan_lines`), which take the place of the step that
///        asks for readings; may be empty
std::vector<std::string> step_lines(const std::vector<NextStep>& steps,
                                    const std::vector<std::string>& plan = {});

/// Returns the text of the first step after a diagnosis, without its number. Empty if there is no
/// step.
/// @param lines lines that `step_lines` returns
std::string first_step(const std::vector<std::string>& lines);

/// Returns the text of each step, preceded by the premise of the step (`NextStep::condition`).
std::vector<std::string> texts_of(const std::vector<NextStep>& steps);

/// Returns the `pendular` command that the user should give after a diagnosis. The command adds an
/// effect to the model only if the verdict names the effect as missing. A change of unknown cause
/// is never added by this command.
/// @param steps steps to take after the diagnosis (`next_steps`)
/// @param study name of the study as the user gave it
std::string next_command(const Diagnosis& diagnosis, const std::vector<NextStep>& steps,
                         const std::string& study);

}  // namespace pendular
