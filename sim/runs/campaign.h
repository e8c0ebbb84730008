#pragma once

#include <filesystem>
#include <vector>

#include "sim/dem/run.h"

namespace pendular {

/// Reads a campaign file (list of simulations to carry out, in TOML) and returns the parameters of
/// the runs that it requests, without duplicates: first all runs of the tables [[grid]], then of
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
/// Each table may have these keys: parameters of a run, as dimensionless numbers or arrays
/// (`reduced_pressure` makes the grains wet); effects on grains, as tables of their parameters; and
/// `repeats`, the number of runs at each point that differ only in their seed. The seed of a run
/// follows from the file's seed and the run's parameters, so that earlier runs keep their seeds
/// when a campaign is extended.
/// @throws InputError if the file cannot be read; at the line of a syntax error, an unknown key, a
///         value out of range or a run that cannot be simulated; if the file requests no run or too
///         many
std::vector<dem::RunParameters> read_campaign(const std::filesystem::path& file);

/// Divides the runs of a campaign (list of simulations) into groups of about equal expected
/// computing time, and returns one of the groups, with its longest run first. The division does not
/// depend on which runs were already carried out.
/// @param share number of the group, from 1
/// @param shares number of groups
std::vector<dem::RunParameters> share_of(const std::vector<dem::RunParameters>& runs, int share,
                                         int shares);

}  // namespace pendular
