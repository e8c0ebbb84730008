#include "sim/catalogue/effect.h"

namespace pendular {

/// A bed that was consolidated, by a preshear at a larger normal stress for example, is denser than
/// steady shear at its present normal stress would keep it. It has to dilate before it flows, and
/// the normal stress works against the dilation, so that the shear stress passes a peak: the point
/// of failure that a yield locus consists of. The factor compares this peak with steady shear at
/// the same normal stress. A constant factor describes a linear yield locus without cohesion; the
/// solid fraction at failure is not changed.
Effect peak_strength() {
    return {.summary =
                "the peak shear stress at failure exceeds that of steady shear, since a dense "
                "sample must dilate first",
            .equation =
                "s12 at failure = factor x s12 in steady shear      for readings at failure only",
            .parameters = {{.name = "factor",
                            .unit = "1",
                            .lower = 1,
                            .upper = 3,
                            .neutral = 1,
                            // Chosen: 2 %, the error that readings without replicates are given.
                            .smallest_of_interest = 0.02,
                            .meaning = "shear stress at failure over that of steady shear"}},
            .change = ChangeFlow{[](FlowPoint point, const Condition&, const Values& v) {
                point.stress_ratio *= v["factor"];
                return point;
            }},
            .touches = Touches::failure,
            .acts_through = {"shear_stress"},
            .directly = "the peak and the plateau of one test that is sheared on after failure",
            .references = {
                "Schulze, Powders and Bulk Solids (2008): yield locus, incipient and steady flow",
                "Taylor, Fundamentals of Soil Mechanics (1948): work of dilation at the peak"}};
}

}  // namespace pendular
