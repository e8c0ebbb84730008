#pragma once

#include <vector>

namespace pendular::dem {

/// Averages over one block (a shear strain of about 0.02), in single precision. Stresses are
/// divided by the imposed normal stress [1].
struct TraceBlock {
    float strain = 0;  ///< of the block [1]
    float s11 = 0, s22 = 0, s33 = 0, s12 = 0;
    float solid_fraction = 0, contact_coordination = 0, distant_coordination = 0, localization = 0;

    friend bool operator==(const TraceBlock&, const TraceBlock&) = default;

    template <typename Archive>
    void serialize(Archive& archive) {
        archive(strain, s11, s22, s33, s12, solid_fraction, contact_coordination,
                distant_coordination, localization);
    }
};

/// Time series of a run, block by block.
using Trace = std::vector<TraceBlock>;

}  // namespace pendular::dem
