#pragma once

namespace pendular::closures {

/// Optional terms of the closures (analytical formulas) of the base model `rumpf`.
struct Terms {
    bool capillary_shear_stress = false;  ///< uses eq:strength2, not eq:strength3
};

}  // namespace pendular::closures
