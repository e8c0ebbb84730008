#include "data/study/set_point.h"

#include "data/annular_cell.h"
#include "data/grains.h"

namespace pendular {

std::optional<SetPoint> set_point_of(const Condition& condition, const Study& study) {
    if (!study.cell) return {};
    AnnularCell cell = *study.cell;
    cell.bead_volume = condition.bead_volume.value_or(cell.bead_volume);
    constexpr double typical_solid_fraction = 0.6;
    const double rate =
        shear_rate_at(condition.inertial_number, condition.normal_stress, study.grains);
    return SetPoint{normal_force(condition.normal_stress, cell),
                    angular_velocity(rate, height(typical_solid_fraction, cell), cell)};
}

}  // namespace pendular
