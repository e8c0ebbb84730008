#pragma once

namespace pendular::closures {

/// Which of the closures base `rumpf` uses.
struct Terms {
    bool capillary_shear_stress = false;  ///< eq:strength2 in place of eq:strength3
};

}  // namespace pendular::closures
