#pragma once

#include <optional>
#include <string>
#include <vector>

#include "app/options.h"
#include "sim/lab/lab_plan.h"

namespace pendular::app {

/// Options of `virtual-lab` that describe the experiment: beads, liquid, cell, set points, order,
/// noise and drifts. Values are texts with units, as the user typed them.
class LabOptions {
  public:
    explicit LabOptions(Options& options);

    /// Returns the plan that the options state. With --like, it begins with the study's set points
    /// and instrument, which other options replace.
    /// @param parsed options whose arguments have been parsed
    /// @param notes receives messages on what could not be taken from the study
    /// @throws InputError for a value with a wrong unit or out of range, and for options that
    ///         contradict each other
    LabPlan plan(const Options& parsed, std::vector<std::string>& notes) const;

  private:
    /// Number of a quantity: an option with its unit.
    struct Word {
        const char* option;
        const char* unit;
        std::string text = {};
    };

    void declare_beads(Options& options);
    void declare_set_points(Options& options);
    void declare_instrument(Options& options);
    void check(const Options& parsed) const;
    void take_beads(LabPlan& plan) const;
    void take_set_points(const Options& parsed, LabPlan& plan) const;
    void take_instrument(const Options& parsed, LabPlan& plan) const;

    Word inner_radius_{"inner-radius", "m"}, outer_radius_{"outer-radius", "m"};
    Word bead_mass_{"bead-mass", "kg"}, diameter_{"diameter", "m"};
    Word density_{"density", "kg/m^3"}, youngs_modulus_{"youngs-modulus", "Pa"};
    Word poisson_ratio_{"poisson-ratio", "1"};
    Word surface_tension_{"surface-tension", "N/m"}, contact_angle_{"liquid-contact-angle", "rad"};
    Word viscosity_{"liquid-viscosity", "Pa s"};
    Word dry_normal_stresses_{"dry-normal-stresses", "Pa"};
    Word wet_normal_stresses_{"wet-normal-stresses", "Pa"};
    Word liquid_contents_{"liquid-contents", "1"}, inertial_numbers_{"inertial-numbers", "1"};
    Word speeds_{"speeds", "rad/s"};
    Word torque_scatter_{"torque-scatter", "1"};
    Word solid_fraction_scatter_{"solid-fraction-scatter", "1"};
    Word force_scatter_{"force-scatter", "1"}, within_{"scatter-within-steps", "1"};
    Word correlation_{"correlation-strain", "1"};
    Word torque_drift_{"torque-drift", "1"}, gap_drift_{"gap-drift", "1"};
    Word force_drift_{"force-drift", "1"};
    std::string like_, order_;
    double friction_ = LabPlan{}.friction;
    Instrument instrument_;
    int replicates_ = LabPlan{}.replicates;
    bool dry_ = false;
};

}  // namespace pendular::app
