#pragma once

#include <cstdint>
#include <functional>
#include <map>
#include <string>
#include <vector>

#include "data/study.h"
#include "sim/ensemble.h"
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

/// One step of a recording: what was imposed and the run that says what was to be seen.
struct LabStep {
    Condition condition;  ///< with the liquid content asked for
    dem::RunResult run;
};

/// One file: a replicate of all steps of one liquid content.
struct LabRecording {
    std::string file;
    double liquid_content = 0;
    int replicate = 1;
    std::uint64_t seed = 0;  ///< of the instrument
    std::vector<LabStep> steps;
};

struct LabResult {
    LabPlan plan;
    std::vector<LabRecording> recordings;
    std::size_t pilots = 0;          ///< short runs made to find bridge volumes
    std::vector<std::string> notes;  ///< lines the user should read
};

/// Told the name of each phase of the work before its runs begin.
using AnnouncePhase = std::function<void(const std::string&)>;

/// Simulates every step of every recording, each on its own: no two share a seed, and none shares
/// its seed with a run of a calibration of equal seed (seeds.h) or its number of beads, 1.5 times
/// the fidelity's. Bridge volumes that give the liquid contents are found by short runs first.
/// A run that fails, crystallises or is not steady is replaced by one of another seed, three times
/// at most.
/// @throws InputError as `check`
/// @throws dem::SimulationError where a step has no usable run
/// @throws dem::Interrupted when a stop is requested
LabResult simulate_lab(const LabPlan& plan, const Workers& workers,
                       const AnnouncePhase& announce = {});

/// The study folder: recordings and study.toml by file name. Nothing in it tells the truth.
std::map<std::string, std::string> study_files(const LabResult& result);

}  // namespace pendular
