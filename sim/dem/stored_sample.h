#pragma once

#include <array>
#include <cstddef>
#include <vector>

#include "sim/dem/shear_cell.h"

namespace pendular::dem {

/// A sample as a run leaves it, in single precision: enough for another run to start from, not to
/// go on bit for bit (that is a checkpoint). What contacts remember is left out: it builds up again
/// while they slide by their overlap, a small part of any transient. Samples of unequal beads are
/// not stored: it stays empty.
struct StoredSample {
    Cell cell;
    std::vector<std::array<float, 9>> beads;  ///< position, peculiar velocity, angular velocity

    StoredSample() = default;
    explicit StoredSample(const ShearCell& sample) : cell(sample.cell()) {
        if (!sample.beads().diameters.empty()) {
            return;
        }
        beads.reserve(sample.beads().size());
        for (const auto& bead : sample.beads().motion) {
            auto& to = beads.emplace_back();
            for (std::size_t d = 0; d < 3; ++d) {
                to[d] = static_cast<float>(bead.position[d]);
                to[3 + d] = static_cast<float>(bead.velocity[d]);
                to[6 + d] = static_cast<float>(bead.spin[d]);
            }
        }
    }

    Sample sample() const {
        Sample result{Beads(beads.size()), cell};
        for (std::size_t i = 0; i < beads.size(); ++i) {
            const auto& b = beads[i];
            result.beads.motion[i] = {{b[0], b[1], b[2]}, {b[3], b[4], b[5]}, {b[6], b[7], b[8]}};
        }
        return result;
    }

    template <typename Archive>
    void serialize(Archive& archive) {
        archive(cell, beads);
    }
};

}  // namespace pendular::dem
