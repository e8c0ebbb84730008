#include "sim/catalogue/effect.h"

namespace pendular {

/// Takes the stresses of the contacts from the simulation too. The closures assume that the
/// contacts have the stress ratio of dry grains, mu*_0, whatever the pressure and the liquid
/// content.
Effect contact_stress() {
    return {
        .summary =
            "the simulated stress of the contacts replaces the assumption that contacts have the "
            "stress ratio of dry grains",
        .equation =
            "mu* = |s12cont + s12cap|/s22 (cont: contacts, cap: bridges), all simulated;\n"
            "without the effect, s12cont = -mu*_0 s22cont with the dry stress ratio mu*_0",
        .parameters = {on_switch(
            "simulated stress of the contacts instead of the stress ratio of dry grains")},
        .change = ChangeClosure{.level = closures::Level::simulation},
        .touches = Touches::wet,
        .acts_through = {"1/reduced_pressure", "liquid_content"},
        .references = {"Badetti, Fall, Chevoir and Roux, Shear strength of wet granular materials: "
                       "macroscopic cohesion and effective stress (2018), Eq. (18), whose "
                       "assumption the effect removes"}};
}

}  // namespace pendular
