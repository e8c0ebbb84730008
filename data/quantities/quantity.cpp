#include "data/quantities/quantity.h"

#include <algorithm>
#include <cctype>
#include <cstdlib>
#include <string>
#include <unordered_map>

namespace pendular {
namespace {

const std::vector<Quantity>& table() {
    static const std::vector<Quantity> all = {
        // Imposed conditions.
        {"normal_stress",
         "σ22",
         "Pa",
         "normal stress in the direction of the velocity gradient",
         {"normal pressure", "sigma", "sigma n", "sigma22", "s22", "σ", "σn", "σ22", "pressure"}},
        {"shear_rate",
         "γ̇",
         "1/s",
         "shear rate at the mean radius",
         {"gamma dot", "γ̇", "strain rate"}},
        {"preshear_stress", "σ_p", "Pa", "normal stress of the preshear before a point of failure"},
        {"preshear_shear_stress", "τ_p", "Pa",
         "shear stress at the end of the preshear before a point of failure"},
        {"bulk_density",
         "ρ_b",
         "kg/m^3",
         "mass of the grains, without liquid, over the volume of the sample",
         {"bulk solid density"}},
        {"inertial_number",
         "I",
         "1",
         "shear rate times sqrt(m/(a s22)) (m, a: mass and diameter of a grain)",
         {"I"}},
        {"inertial_number_diameter_density", "I", "1",
         "shear rate times a sqrt(density/s22) (a, density: of a grain); sqrt(6/pi) times the "
         "inertial number"},
        {"height",
         "H",
         "m",
         "height of the sample between base and lid",
         {"gap", "H", "h", "cell height", "sample height", "gap height"}},
        {"bead_volume", "V_S", "m^3", "volume of the beads in the cell", {"bead volume", "V_S"}},
        {"reduced_pressure",
         "P*",
         "1",
         "a^2 s22 over the pull-off force of a bridge (a: grain diameter, s22: normal stress)",
         {"P*"}},
        {"stiffness_number",
         "κ",
         "1",
         "(E/((1 - nu^2) s22))^(2/3) (E, nu: Young's modulus and Poisson ratio of the grains, s22: "
         "normal stress)",
         {"kappa", "κ"}},
        {"bridge_volume", "V0/a³", "1", "volume of a liquid bridge over a^3 (a: grain diameter)"},
        // Measured or predicted quantities.
        {"shear_stress",
         "|σ12|",
         "Pa",
         "magnitude of the shear stress",
         {"tau", "τ", "sigma12", "s12", "σ12", "|σ12|"}},
        {"error_correlation", "r", "1",
         "correlation between the errors of shear stress and solid fraction"},
        {"friction", "μ", "1", "friction coefficient between grains", {"mu", "μ", "µ"}},
        {"reduced_cohesion", "c*", "1",
         "a^2 times the cohesion over the pull-off force of a bridge (a: grain diameter)"},
#define OBSERVABLE(name, symbol, unit, grains, meaning, ...) \
    {#name, symbol, unit, meaning, {__VA_ARGS__}},
#include "data/quantities/observables.def"
        // Quantities recorded by a rheometer.
        {"time",
         "t",
         "s",
         "time since the first recording of the study began",
         {"t", "elapsed time"}},
        {"torque", "T", "N m", "torque on the lid", {"T", "M", "moment"}},
        {"normal_force",
         "F_N",
         "N",
         "normal force on the lid, compression positive",
         {"F_N", "axial force", "force"}},
        {"lever_force",
         "F_S",
         "N",
         "force on the lever that holds the lid; times the lever arm, the torque",
         {"shear force", "lever force", "force on lever"}},
        {"angular_velocity",
         "ω",
         "rad/s",
         "angular velocity of the lid",
         {"omega", "ω", "lid angular velocity", "angular speed", "rotation rate"}},
        {"rotational_speed",
         "n",
         "turn/s",
         "revolutions of the lid per time",
         {"speed", "rotation speed", "rotary speed"}},
        {"shear_velocity",
         "v",
         "m/s",
         "speed of the lid at the mean radius",
         {"shear speed", "shearing velocity"}},
        {"interval",
         "",
         "1",
         "number of the step of constant set points",
         {"step", "segment", "interval number", "step number"}},
        // Origin of a reading.
        {"sampled_seconds", "", "s",
         "duration of the steady part over which a reading was averaged"},
        {"replicates", "", "1", "readings of the same condition, this one included"},
        {"error_assumed", "", "1", "1 where an error was assumed rather than measured"},
        {"filling", "", "1",
         "number of the filling of the cell that a reading was made on, from 1"},
        {"shear_stress_of_filling", "", "Pa",
         "part of the standard error of a shear stress that readings of one filling share"},
        {"solid_fraction_of_filling", "", "1",
         "part of the standard error of a solid fraction that readings of one filling share"},
        {"failure", "", "1",
         "1 for a point of failure (peak of the shear stress), 0 for steady shear"},
        {"gap_creep", "", "1",
         "relative change of the gap per unit of strain while the torque was steady; not 0: the "
         "solid fraction is unknown"},
        {"line", "", "1", "line of the file from which a reading was made"},
        {"file", "", "", "file a reading was made from"}};
    return all;
}

/// Name in lower case without separators, so that "Normal force", "normal_force" and "NormalForce"
/// are equal. Letters other than ASCII do not change, nor do names of one letter: T is a torque, t
/// a time.
std::string compact(std::string_view name) {
    if (name.size() == 1) return std::string(name);
    std::string result;
    for (const char c : name) {
        const auto byte = static_cast<unsigned char>(c);
        if (std::isspace(byte) || c == '_' || c == '-' || c == '.') continue;
        result += static_cast<char>(std::tolower(byte));
    }
    return result;
}

}  // namespace

std::span<const Quantity> quantities() {
    return table();
}

const Quantity& quantity(std::string_view name) {
    for (const Quantity& each : table())
        if (each.name == name) return each;
    std::abort();
}

const Quantity* find_quantity(std::string_view spelling) {
    static const std::unordered_map<std::string, const Quantity*> by_spelling = [] {
        std::unordered_map<std::string, const Quantity*> all;
        for (const Quantity& each : table()) {
            all.emplace(compact(each.name), &each);
            for (const std::string_view other : each.also)
                all.emplace(compact(other), &each);
        }
        return all;
    }();
    const auto found = by_spelling.find(compact(spelling));
    return found == by_spelling.end() ? nullptr : found->second;
}

}  // namespace pendular
