#pragma once

#include <filesystem>
#include <vector>

#include "sim/dem/run.h"

namespace pendular {

/// Reads a campaign file (TOML list of simulation runs to carry out) and returns the parameters of
/// the runs that it requests, without duplicates: first all runs of the [[grid]] tables, then of
/// [[list]], then of [[sobol]].
///
///     seed = 1                            # from which the seed of every run follows
///     [[grid]]                            # every combination
///     friction = [0.05, 0.09, 0.15]
///     inertial_number = [0.003, 0.01]
///     [[list]]                            # first with first, second with second ...
///     friction = [0.1, 0.2]
///     reduced_pressure = [1, 2]
///     [[sobol]]                           # evenly scattered between two numbers
///     points = 64
///     friction = [0, 0.6]
///     inertial_number = [1e-3, 0.1]
///     logarithmic = ["inertial_number"]
///
/// The keys of each table are: inputs of a run, as dimensionless numbers or arrays
/// (`reduced_pressure` makes the grains wet); effects on grains, as tables of their parameters; and
/// `repeats`, the number of runs at each point that differ only in their seed. The seed of a run
/// follows from the file's seed and the run's parameters, so that a campaign that is extended
/// requests its earlier runs with their earlier seeds.
/// @throws InputError at the line of a syntax error, an unknown key, a value out of range or a run
///         that cannot be simulated, and where the file requests no run or too many
std::vector<dem::RunParameters> read_campaign(const std::filesystem::path& file);

/// Divides `runs` into `shares` groups of about equal expected computing time and returns group
/// number `share`, counted from 1, the longest run first. The division does not depend on which
/// runs a store (file of earlier runs) already holds.
std::vector<dem::RunParameters> share_of(const std::vector<dem::RunParameters>& runs, int share,
                                         int shares);

}  // namespace pendular
