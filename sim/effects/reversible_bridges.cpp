#include "sim/catalogue/effect.h"

namespace pendular {

/// In the base law bridges have a hysteresis: a bridge forms on contact and breaks at the gap D0.
/// With this effect, bridges form as soon as the gap is below D0, as they do where liquid films on
/// the beads meet before the beads touch, or where vapour condenses. There are then more bridges
/// without contact, as many between approaching as between parting beads, and they carry less shear
/// stress.
Effect reversible_bridges() {
    return {.summary =
                "bridges form without contact, as soon as two grains are closer than the rupture "
                "distance",
            .equation = "a bridge joins two grains wherever their gap h <= D0",
            .parameters = {on_switch("bridges form as soon as two grains are within the rupture "
                                     "distance instead of at a contact")},
            .change = dem::ChangePairs{.bridges_without_contact = true},
            .touches = Touches::wet,
            .fades_with_capillarity = true,
            .acts_through = {"liquid_content", "1/reduced_pressure"},
            .references = {
                "Kohonen, Geromichalos, Scheel, Schier, Herminghaus, Physica A 339 (2004) 7: "
                "formation and rupture of bridges in wet grains",
                "Badetti et al. (2018), section 2.3, for the hysteretic base"}};
}

}  // namespace pendular
