#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "data/annular_cell.h"
#include "data/input_error.h"
#include "data/reading.h"

namespace pendular {

/// The beads, in SI units.
struct Grains {
    double diameter = 0;  ///< a [m]
    double density = 0;   ///< [kg/m^3]
    /// E [Pa]; without it results stand at the fidelity's stiffness number
    std::optional<double> youngs_modulus = {};
    double poisson_ratio = 0.3;  ///< nu [1]

    /// Mass of one bead [kg]: rho pi a^3/6.
    double mass() const;
};

/// The wetting liquid, in SI units.
struct Liquid {
    double surface_tension = 0;  ///< Gamma [N/m]
    double contact_angle = 0;    ///< theta [rad]
    double viscosity = 0;        ///< [Pa s]
};

/// I = rate sqrt(m/(a s22)) [1], from a shear rate [1/s] and a normal stress [Pa].
/// Source: Badetti et al. (2018), eq:defI, in its three-dimensional form; the other common form,
/// rate a sqrt(rho/s22), is sqrt(6/pi) = 1.382 times larger.
double inertial_number(double shear_rate, double normal_stress, const Grains& grains);

/// Shear rate [1/s] at an inertial number [1] and a normal stress [Pa]; the inverse of
/// `inertial_number`.
double shear_rate_at(double inertial_number, double normal_stress, const Grains& grains);

/// Stiffness number kappa = (E~/s22)^(2/3) [1], E~ = E/(1 - nu^2); empty without a Young's modulus.
std::optional<double> stiffness_number(double normal_stress, const Grains& grains);

/// Pull-off force F0 = pi a Gamma cos(theta) [N]: the attraction of two equal beads in contact,
/// joined by a liquid bridge of any volume.
/// Source: Maugis, J. Adhesion Sci. Technol. 1 (1987) 105; Badetti et al. (2018), eq:Maugis, where
/// a is the bead diameter.
double pull_off_force(const Grains& grains, const Liquid& liquid);

/// Reduced pressure P* = a^2 s22/F0 [1], from a normal stress [Pa]; infinite for a liquid without
/// surface tension.
/// Source: Badetti et al. (2018), eq:defPstar.
double reduced_pressure(double normal_stress, const Grains& grains, const Liquid& liquid);

/// One [[recording]] or [[readings]] entry with its glob already resolved.
struct Source {
    enum class Kind { recording, readings };
    Kind kind = Kind::recording;
    std::vector<std::filesystem::path> files;  ///< matches of the glob, by name
    std::optional<double> liquid_content;      ///< Phi_L/Phi_S [1]
    std::optional<double> bead_volume;         ///< [m^3], where the entry overrides the cell's
    Position position;                         ///< of the entry in the study file
};

/// What to do with the model.
struct ModelChoice {
    std::string base = "dem";
    std::vector<std::string> calibrate = {"friction"};
    std::string fit_to = "dry";  ///< "dry" or "all"
    std::vector<std::string> effects;
    Form bridge_force = Form::derived;
};

/// A study folder: what belongs together.
struct Study {
    std::filesystem::path folder;
    std::filesystem::path file;
    Grains grains;
    std::optional<Liquid> liquid;
    std::optional<AnnularCell> cell;  ///< needed by recordings
    std::vector<Source> sources;      ///< in run order
    ModelChoice model;
};

/// Reads STUDY/study.toml (or the file itself). Every key is checked; quantities are strings with
/// their unit, or plain numbers where dimensionless.
/// @throws InputError at file:line:column for anything missing, unknown (with the nearest known
///         key), of the wrong dimension, or impossible (Ri >= Re, density <= 0, ...)
Study read_study(const std::filesystem::path& study);

/// Why separate bridges do not describe beads of this liquid content; empty where they do.
std::optional<std::string> pendular_range_warning(double liquid_content);

/// Turns every source of the study into readings, in run order.
/// @throws InputError at file:line:column for a malformed file
Measurements read_measurements(const Study& study);

}  // namespace pendular
