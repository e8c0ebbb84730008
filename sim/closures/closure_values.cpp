#include "sim/closures/closure_values.h"

#include "sim/closures/state.h"

namespace pendular::closures {

double contact_stress_ratio(double stress_ratio, const CapillaryStress& capillary,
                            double reduced_pressure) {
    // s12 is negative and s12cap positive, so that the magnitudes add.
    return (stress_ratio + capillary.shear / reduced_pressure) /
           (1 - capillary.normal / reduced_pressure);
}

double stress_ratio_from_stresses(double dry_stress_ratio, const CapillaryStress& capillary,
                                  double reduced_pressure) {
    return dry_stress_ratio * (1 - capillary.normal / reduced_pressure) -
           capillary.shear / reduced_pressure;
}

double reduced_cohesion(double dry_stress_ratio, double solid_fraction,
                        double effective_coordination) {
    return -dry_stress_ratio * capillary_pressure(solid_fraction, effective_coordination);
}

double rumpf_cohesion(double dry_stress_ratio, double solid_fraction, double coordination,
                      double pull_off_force, double diameter) {
    return reduced_cohesion(dry_stress_ratio, solid_fraction, coordination) * pull_off_force /
           (diameter * diameter);
}

double generalised_cohesion(double dry_stress_ratio, double solid_fraction,
                            double effective_coordination, double capillary_shear_stress) {
    return reduced_cohesion(dry_stress_ratio, solid_fraction, effective_coordination) -
           capillary_shear_stress;
}

double stress_ratio_from_cohesion(double dry_stress_ratio, double reduced_cohesion,
                                  double reduced_pressure) {
    return dry_stress_ratio + reduced_cohesion / reduced_pressure;
}

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
