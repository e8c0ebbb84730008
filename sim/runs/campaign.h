#pragma once

#include <filesystem>
#include <vector>

#include "sim/dem/run.h"
#include "sim/runs/run_settings.h"

namespace pendular {

/// Reads a campaign file (simulations to carry out, in TOML) and returns the parameters of its runs
/// without duplicates: first those of the tables [[grid]], then of [[list]], then of [[sobol]].
///
///     seed = 1                            # from which the seed of every run follows
///     [[grid]]                            # every combination of the values
///     friction = [0.05, 0.09, 0.15]
///     inertial_number = [0.003, 0.01]
///     [[list]]                            # the k-th values of the keys make run k
///     friction = [0.1, 0.2]
///     reduced_pressure = [1, 2]
///     [[sobol]]                           # values evenly scattered between two bounds
///     points = 64
///     friction = [0, 0.6]
///     inertial_number = [1e-3, 0.1]
///     logarithmic = ["inertial_number"]
///
/// A parameter of a run is a dimensionless number or an array of numbers; `reduced_pressure` makes
/// the grains wet. An effect on grains is a table of its parameters. `repeats` is the number of
/// runs that differ only in their seeds. The seed of a run follows from the file's seed, the
/// parameters of the run and the number of the repeat.
/// @param fidelity settings for tables without `beads`, `stiffness_number`, `strain` or
///         `inertial_number`, which is then the lowest inertial number of the fidelity
/// @throws InputError that names the line, if the file cannot be read, requests no run or too many
///         runs, or contains a syntax error, an unknown key, a value out of range or a run that
///         cannot be simulated
std::vector<dem::RunParameters> read_campaign(const std::filesystem::path& file,
                                              const Fidelity& fidelity);

/// Divides runs into groups of about equal expected computing time, for example one for each
/// machine, and returns one group, the longest run first. The division does not depend on which
/// runs were already carried out.
/// @param share number of the group, from 1
/// @param shares number of groups
std::vector<dem::RunParameters> share_of(const std::vector<dem::RunParameters>& runs, int share,
                                         int shares);

}  // namespace pendular
