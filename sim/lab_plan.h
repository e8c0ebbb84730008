#pragma once

#include <cstdint>
#include <vector>

#include "data/study.h"
#include "sim/dem/run.h"
#include "sim/fidelity.h"
#include "sim/virtual_recording.h"

namespace pendular {

/// What a virtual laboratory measures, with which instrument, and the truth it hides; SI units.
struct LabPlan {
    double friction = 0.09;
    Grains grains = {.diameter = 500e-6, .density = 1050, .poisson_ratio = 0.3};
    Liquid liquid = {.surface_tension = 20.6e-3};
    AnnularCell cell = {.inner_radius = 21e-3, .outer_radius = 45e-3, .bead_volume = 60e-3 / 1050};
    std::vector<double> dry_normal_stresses = {300, 1000, 3000};
    std::vector<double> wet_normal_stresses = {300, 600, 1000, 3000};
    std::vector<double> liquid_contents = {0.007, 0.03};  ///< none: dry recordings only
    std::vector<double> inertial_numbers = {3e-3, 3e-2};
    int replicates = 2;
    Instrument instrument;
    Fidelity fidelity;
    std::uint64_t seed = 1;
};

/// Refuses, before any work, what cannot be simulated, recorded or told apart.
/// @throws InputError saying what is wrong and what to do
void check(const LabPlan& plan);

/// Condition of every step of one recording, in the order measured.
std::vector<Condition> conditions_of(const LabPlan& plan, double liquid_content);

/// Dry (0), then each liquid content.
std::vector<double> contents_of(const LabPlan& plan);

/// The run that says what is to be seen at a condition.
dem::RunParameters run_at(const LabPlan& plan, const Condition& condition, double bridge_volume);

/// A smaller and shorter one, to find the bridge volume.
dem::RunParameters pilot_at(const LabPlan& plan, const Condition& condition, double bridge_volume);

}  // namespace pendular
