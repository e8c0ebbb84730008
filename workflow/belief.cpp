#include "workflow/belief.h"

#include <optional>

#include "calib/fit/calibration.h"

namespace pendular {

Belief belief_in(const ResolvedStudy& study, const Measurements& measurements, const Calibration& c,
                 const Comparison& comparison) {
    const StudyModel model(study, c);
    const auto mistake = find_unit_mistake(model.model(), c.readings, study, c.fit.parameters);
    return belief_in(c.fit, c.parameters, comparison.fitted, measurements, mistake);
}

}  // namespace pendular
