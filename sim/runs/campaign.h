#pragma once

#include <filesystem>
#include <vector>

#include "sim/dem/run.h"

namespace pendular {

/// Runs that a campaign file requests, in its order, each once.
///
///     seed = 1                            # of all its runs
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
/// Keys of each table: the columns that determine a run (`reduced_pressure` makes grains wet),
/// numbers or arrays, 1 throughout; `repeats`: runs of each that differ in their seed alone. A
/// run's seed follows from the file's seed and from its own parameters, so that a longer campaign
/// repeats no run of a shorter one under another seed.
/// @throws InputError at the line of what is wrong: syntax, an unknown key, a value out of range
std::vector<dem::RunParameters> read_campaign(const std::filesystem::path& file);

/// Runs of one of several shares of about equal cost; the shares do not depend on the stored runs.
/// `share` counts from 1.
std::vector<dem::RunParameters> share_of(const std::vector<dem::RunParameters>& runs, int share,
                                         int shares);

}  // namespace pendular
