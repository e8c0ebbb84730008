#pragma once

#include <optional>
#include <vector>

#include "analysis/diagnosis/diagnosis.h"
#include "reports/figure.h"
#include "workflow/study_diagnosis.h"

namespace pendular {

/// Returns a figure of up to nine candidate effects, one in each row, the largest reduction of chi2
/// first. The upper panel shows the reduction of chi2 [1], predicted and refitted. The lower panel
/// shows the magnitude of the estimated size of each effect beside the size that 80 % of
/// repetitions of the study would detect, both divided by the smallest size of interest [1].
/// Without panels if the readings could reveal none of the effects.
Figure diagnosis_figure(const Diagnosis& diagnosis, const ModelSpace& space);

/// Returns two figures of the tested effects:
/// - `scan`: predicted reduction of chi2 [1] by up to 20 effects, beside that of a refit. Without
///   panels if the readings could reveal no effect.
/// - `cosines`: absolute cosine [1] between the changes of the readings by two effects, for each
///   pair of up to ten; 1: the readings cannot tell them apart. Without panels if the readings
///   could reveal fewer than two effects.
std::vector<Figure> scan_figures(const Diagnosis& diagnosis, const ModelSpace& space);

/// Returns the figures of `pendular diagnose`: `diagnosis_figure`, `scan_figures`, and those of the
/// first proposal (`proposal_figure`) and of the impacts (`impact_figure`), if there are any.
std::vector<Figure> diagnosis_figures(const StudyDiagnosis& diagnosis,
                                      const std::optional<ImpactTable>& impacts);

}  // namespace pendular
