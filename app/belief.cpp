#include "app/belief.h"

#include <fmt/format.h>

namespace pendular::app {

Belief belief_in(const Study& study, const Measurements& measurements, const Calibration& c,
                 const Comparison& comparison) {
    std::optional<UnitMistake> mistake;
    if (c.scales) {
        const StudyModel model(study, c);
        mistake = find_unit_mistake(model.model(), c.readings, study, c.fit.parameters);
    }
    return pendular::belief_in(c.fit, c.parameters, comparison.fitted, measurements, mistake);
}

std::string verdict_on(const Belief& belief, const std::string& basis) {
    if (belief.believable()) return "; " + basis;
    return fmt::format("; do not use this value{}: {}",
                       belief.meaningless ? ", it is meaningless" : "", belief.reasons.front());
}

void print_doubts(Console& console, const Belief& belief) {
    for (const std::string& reason : belief.reasons) {
        console.line("doubt: " + reason);
    }
}

}  // namespace pendular::app
