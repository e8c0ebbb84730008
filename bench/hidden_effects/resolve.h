#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "bench/hidden_effects/truth.h"
#include "sim/lab/virtual_lab.h"

namespace pendular::bench {

/// Rule for the choice of the next measurement of a study. `next`: the measurement that `pendular
/// next` plans. `random`: a random measurement that the instrument can make.
enum class Policy { next, random };

/// Result of further measurements in a virtual laboratory, on a study for which several effects
/// explained the readings equally well.
struct Resolution {
    std::string truth;
    int study = 0;
    Policy policy = Policy::next;
    /// Number of models that fitted the readings before the further measurements.
    std::size_t rivals = 0;
    /// Whether the model with the hidden effect fitted the readings before the further
    /// measurements. Always true with `Policy::random`, which does not test this.
    bool among = true;
    /// Whether `pendular next` expects that further measurements can tell the model with the hidden
    /// effect from all other models that fit. Always true with `Policy::random`.
    bool separable = true;
    int measurements = 0;  ///< number of further measurements that were made
    std::string verdict;   ///< verdict after the last measurement
    std::vector<std::string> named;
    bool right = false;  ///< whether the verdict is "missing" and names exactly the hidden effect
};

/// Makes further measurements in a virtual laboratory until the verdict is no longer
/// "indistinguishable" (several effects explain the readings equally well), or until
/// `most_measurements` are made. With `Policy::next`, the measurements also end if `pendular next`
/// finds no measurement that tells the remaining models apart. No measurement is made if
/// `Resolution::separable` is false. Returns one result, or nothing if the first verdict is not
/// "indistinguishable".
/// @param study number of the study, which determines the noise of its recordings
/// @param folder folder for the files of the study, which the function creates and finally removes
std::vector<Resolution> resolve(const Truth& truth, const LabResult& laboratory, int study,
                                Policy policy, int most_measurements, const Workers& workers,
                                const std::filesystem::path& folder);

std::vector<Resolution> read_resolutions(const std::filesystem::path& file);
void write_resolutions(const std::filesystem::path& file,
                       const std::vector<Resolution>& resolutions);

}  // namespace pendular::bench
