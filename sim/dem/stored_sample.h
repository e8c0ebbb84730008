#pragma once

#include <array>
#include <cstddef>
#include <vector>

#include "sim/dem/shear_cell.h"

namespace pendular::dem {

/// Final state of a run in single precision, from which a new run can start. It lacks the contact
/// history, so that only a checkpoint can continue a run bit for bit. If the grains differ in size,
/// the state is not stored and `grains` is empty.
struct StoredSample {
    Cell cell;
    /// Position, velocity without the imposed flow, and angular velocity of each grain, in reduced
    /// units (grain diameter, grain mass and imposed normal stress are 1).
    std::vector<std::array<float, 9>> grains;

    StoredSample() = default;
    explicit StoredSample(const ShearCell& sample) : cell(sample.cell()) {
        if (!sample.grains().diameters.empty()) {
            return;
        }
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

    Sample sample() const {
        Sample result{Grains(grains.size()), cell};
        for (std::size_t i = 0; i < grains.size(); ++i) {
            const auto& b = grains[i];
            result.grains.motion[i] = {{b[0], b[1], b[2]}, {b[3], b[4], b[5]}, {b[6], b[7], b[8]}};
        }
        return result;
    }

    template <typename Archive>
    void serialize(Archive& archive) {
        archive(cell, grains);
    }
};

}  // namespace pendular::dem
