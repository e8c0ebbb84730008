#include "workflow/belief.h"

#include <optional>

#include "calib/calibration.h"

namespace pendular {

Belief belief_in(const Study& study, const Measurements& measurements, const Calibration& c,
                 const Comparison& comparison) {
    std::optional<UnitMistake> mistake;
    if (c.scales) {
        const StudyModel model(study, c);
        mistake = find_unit_mistake(model.model(), c.readings, study, c.fit.parameters);
    }
    return belief_in(c.fit, c.parameters, comparison.fitted, measurements, mistake);
}

}  // namespace pendular
