#include "sim/closures/closure_values.h"

#include "sim/closures/capillary_stress.h"
#include "sim/closures/strength.h"

namespace pendular::closures {

ClosureValues closure_values(const State& state, const CapillaryStress& capillary,
                             double stress_ratio, double dry_stress_ratio, double liquid_content) {
    const double pressure = state.reduced_pressure, fraction = state.solid_fraction;
    ClosureValues values{
        .dry_stress_ratio = dry_stress_ratio,
        .contact_stress_ratio = closures::contact_stress_ratio(stress_ratio, capillary, pressure),
        .effective_coordination = closures::effective_coordination(state),
        .approximate_coordination = closures::approximate_coordination(state)};
    values.rumpf_cohesion =
        reduced_cohesion(dry_stress_ratio, fraction, values.approximate_coordination);
    values.generalised_cohesion = closures::generalised_cohesion(
        dry_stress_ratio, fraction, values.effective_coordination, capillary.shear);
    values.strength1 = stress_ratio_from_stresses(dry_stress_ratio, capillary, pressure);
    values.strength2 =
        stress_ratio_from_cohesion(dry_stress_ratio, values.generalised_cohesion, pressure);
    values.strength3 = stress_ratio_from_cohesion(
        dry_stress_ratio,
        reduced_cohesion(dry_stress_ratio, fraction, values.effective_coordination), pressure);
    values.saturation = liquid_content * fraction / (1 - fraction);
    return values;
}

ClosureValues closure_values(const dem::RunResult& run, double dry_stress_ratio) {
    using dem::Observable;
    return closure_values(network_state_of(run), capillary_stress_of(run),
                          run[Observable::stress_ratio].value, dry_stress_ratio,
                          run[Observable::liquid_content].value);
}

}  // namespace pendular::closures
