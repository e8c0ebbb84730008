#include "sim/dem/run_result.h"

#include "sim/dem/shear_cell.h"

namespace pendular::dem {

StoredSample::StoredSample(const ShearCell& sample) : cell(sample.cell()) {
    if (!sample.grains().diameters.empty()) return;
    grains.reserve(sample.grains().size());
    for (const auto& grain : sample.grains().motion) {
        auto& to = grains.emplace_back();
        for (std::size_t d = 0; d < 3; ++d) {
            to[d] = static_cast<float>(grain.position[d]);
            to[3 + d] = static_cast<float>(grain.velocity[d]);
            to[6 + d] = static_cast<float>(grain.angular_velocity[d]);
        }
    }
}

Sample StoredSample::sample() const {
    Sample result{Grains(grains.size()), cell};
    for (std::size_t i = 0; i < grains.size(); ++i) {
        const auto& b = grains[i];
        result.grains.motion[i] = {{b[0], b[1], b[2]}, {b[3], b[4], b[5]}, {b[6], b[7], b[8]}};
    }
    return result;
}

double rigidity_shift(double solid_fraction, double mean_overlap) {
    return rigidity_factor * 3 * solid_fraction * mean_overlap;
}

}  // namespace pendular::dem
