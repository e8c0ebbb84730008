#pragma once

#include <vector>

#include "analysis/diagnosis/diagnosis.h"
#include "analysis/misfit/checks.h"
#include "data/reading.h"

namespace pendular {

/// Readings of a study as a diagnosis takes them: with errors as they were estimated, of shear
/// stress and of solid fraction apart, and as suspects the readings of each condition and those of
/// each file, whose shear stresses and solid fractions may be off by a factor each. Direct
/// measurements follow them, with errors as stated; those of a parameter are suspects too.
Evidence evidence_of(const std::vector<Reading>& readings, const ReplicateScatter& scatter,
                     const std::vector<DirectMeasurement>& direct = {});

/// Quantities that vary between readings, by a tenth at least: smaller differences are the scatter
/// of set points or, for the height, follow from the solid fraction. `direct` direct measurements,
/// which have no such quantities, follow.
std::vector<Covariate> covariates_of(const std::vector<Reading>& readings, std::size_t direct = 0);

/// Kinds of the entries of readings and direct measurements.
EntryKinds entries_of(const std::vector<Reading>& readings,
                      const std::vector<Parameter>& parameters, std::size_t direct = 0);

/// Condition as text: "300 Pa, I 0.003, liquid content 0.03".
std::string condition_text(const Condition& condition);

}  // namespace pendular
