#pragma once

#include <optional>
#include <string>
#include <vector>

#include "analysis/diagnosis/impact.h"
#include "sim/catalogue/resolved_study.h"
#include "workflow/study_diagnosis.h"

namespace pendular {

/// One of the steps that a user should take after a diagnosis.
struct NextStep {
    std::string text;  ///< what to do, in one or more sentences
    /// Whether the step is to take the readings that `pendular next` plans.
    bool readings = false;
    bool direct = false;  ///< whether the step is to measure an effect's parameter directly
    /// Condition under which the step is to be taken, as the beginning of a sentence; may be empty.
    std::string condition = {};
};

/// Returns the steps to take after a diagnosis, in the order in which the user should take the
/// steps. The steps are checks of the instrument, direct measurements of effects (without shearing
/// grains), readings, and changes of the model. A step for a direct measurement states the value to
/// expect and the largest standard error with which the measurement decides: the deviation to be
/// seen, divided by sqrt(`telling_directly`). A step for readings names the command that plans the
/// readings.
/// @param impacts shifts of the fitted friction coefficient by each effect; used to choose among
///        effects that could go undetected
/// @param study name of the study as the user gave it
std::vector<NextStep> next_steps(const StudyDiagnosis& diagnosis,
                                 const std::optional<ImpactTable>& impacts,
                                 const ResolvedStudy& resolved, const std::string& study);

/// Returns the steps as numbered lines below a heading, then a line that says how to enter the
/// result of a direct measurement, if a step asks for one.
/// @param plan lines on the planned readings (`plan_lines`), which take the place of the step that
///        asks for readings; may be empty
std::vector<std::string> step_lines(const std::vector<NextStep>& steps,
                                    const std::vector<std::string>& plan = {});

/// Returns the text of the first step, without its number.
/// @param lines lines that `step_lines` returns
std::string first_step(const std::vector<std::string>& lines);

/// Returns the texts of the steps.
std::vector<std::string> texts_of(const std::vector<NextStep>& steps);

/// Returns the `pendular` command to give next. The command only proposes to add an effect if the
/// diagnosis found the effect missing; a proposed change of unknown cause is never added without a
/// check.
/// @param steps what to do after the diagnosis (`next_steps`)
/// @param study name of the study as the user gave it
std::string next_command(const Diagnosis& diagnosis, const std::vector<NextStep>& steps,
                         const std::string& study);

}  // namespace pendular
