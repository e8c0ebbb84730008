#pragma once

namespace pendular::closures {

/// Optional terms in the closures (analytical formulas for the strength of wet grains) of the base
/// model `rumpf`; by default none is used.
struct Terms {
    bool capillary_shear_stress = false;  ///< cohesion includes the capillary shear stress
};

}  // namespace pendular::closures
