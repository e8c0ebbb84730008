#pragma once

#include <array>
#include <string>
#include <vector>

#include "analysis/diagnosis/diagnosis.h"
#include "analysis/misfit/checks.h"

namespace pendular {

/// The verdict in one line, in plain words: "Missing: torque-offset (0.41 +- 0.03 mN m). Adding it
/// brings chi2/dof from 9.8 to about 1.1.", "Something is missing that no known effect explains; it
/// grows with height."
std::string verdict_line(const Diagnosis& diagnosis, const ModelSpace& space, const Checks& checks);

/// Table of the tested effects, one line each, the largest reduction of chi2 first.
std::vector<std::string> diagnosis_table(const Diagnosis& diagnosis, const ModelSpace& space);

/// Sentence with chi2 of the model as it is, its degrees of freedom and its probabilities.
std::string fit_line(const Diagnosis& diagnosis);

/// Sentences on a verdict that names effects which do not explain everything: how sure they lead,
/// by how much the RMS errors [%] fall from `before` to `after`, and what `remaining` checks show;
/// empty where the verdict is complete.
std::vector<std::string> incomplete_lines(const Diagnosis& diagnosis,
                                          const std::array<double, 2>& before,
                                          const std::array<double, 2>& after,
                                          const Checks& remaining);

/// Sentence that names the measurements that deviate most from the rest; empty where none does.
std::string suspects_line(const Diagnosis& diagnosis, const Evidence& evidence);

/// Effects of a size of interest that these readings would not reveal, one line each below a
/// heading; empty unless the verdict is inconclusive.
std::vector<std::string> unseen_table(const Diagnosis& diagnosis, const ModelSpace& space);

/// Sentences on how far the verdict reaches: effects that would stay unseen, rival explanations,
/// assumed errors.
std::vector<std::string> advice_on(const Diagnosis& diagnosis, const ModelSpace& space);

/// The command or measurement that follows from the verdict; `study` as the user names it.
std::string next_step(const Diagnosis& diagnosis, const std::string& study);

}  // namespace pendular
