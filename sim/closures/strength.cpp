#include "sim/closures/strength.h"

#include "sim/closures/capillary_stress.h"

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

}  // namespace pendular::closures
