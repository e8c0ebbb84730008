#include "sim/catalogue/effect.h"
#include "sim/dem/bridge_law.h"

namespace pendular {

/// Maugis' and Willett's bridges break at a gap of V0^(1/3), which holds for a small contact angle
/// and slow motion. A large contact angle (a factor 1 + angle/2), pinned contact lines or drainage
/// change this rupture distance. With a larger rupture distance there are more bridges, and they
/// exert forces at gaps where the base law has none.
Effect rupture_distance() {
    return {.summary = "bridges break at a gap that differs from V0^(1/3) (V0: volume of a bridge)",
            .equation = "D0 = factor V0^(1/3)",
            .parameters = {{.name = "factor",
                            .unit = "1",
                            .lower = 0.2,
                            .upper = 2,
                            .neutral = 1,
                            // Chosen: a contact angle of 0.4 rad changes it as much (1 + angle/2).
                            .smallest_of_interest = 0.2,
                            .meaning = "distance between two grains at which their bridge breaks, "
                                       "divided by V0^(1/3) (V0: volume of a bridge)"}},
            .change = dem::ChangePairs{.bridge_law =
                                           [](dem::BridgeLaw law, const Values& v) {
                                               law.rupture_distance *= v["factor"];
                                               return law;
                                           }},
            .touches = Touches::wet,
            .fades_with_capillarity = true,
            .acts_through = {"liquid_content", "1/reduced_pressure"},
            .references = {
                "Lian, Thornton, Adams, J. Colloid Interface Sci. 161 (1993) 138: rupture at (1 + "
                "theta/2) V0^(1/3)",
                "Willett, Adams, Johnson, Seville, Langmuir 16 (2000) 9396"}};
}

}  // namespace pendular
