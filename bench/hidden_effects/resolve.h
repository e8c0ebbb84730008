#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "bench/hidden_effects/truth.h"
#include "sim/lab/virtual_lab.h"

namespace pendular::bench {

/// How the next measurement is chosen.
enum class Policy { next, random };

/// Result of further measurements on a study whose effects could not be told apart.
struct Resolution {
    std::string truth;
    int study = 0;
    Policy policy = Policy::next;
    std::size_t rivals = 0;  ///< models that stood at first
    bool among = true;       ///< what is hidden was one of them
    /// `next` says that its rig tells what is hidden from all others; of its own policy.
    bool separable = true;
    int measurements = 0;  ///< made
    std::string verdict;   ///< at the end
    std::vector<std::string> named;
    bool right = false;  ///< `missing`, and it is what is hidden
};

/// Measures on, in the simulated laboratory, until one effect is named, `next` says that nothing on
/// the rig separates what stands, or so many measurements are made; not at all where `next` says
/// at first that its rig does not tell what is hidden from all that stands beside it. The rig goes
/// beyond what was measured: other stresses, rates, contents and fillings, the torque of the empty
/// cell and the tare. Empty where the study is not indistinguishable to begin with.
std::vector<Resolution> resolve(const Truth& truth, const LabResult& laboratory, int study,
                                Policy policy, int most_measurements, const Workers& workers,
                                const std::filesystem::path& folder);

std::vector<Resolution> read_resolutions(const std::filesystem::path& file);
void write_resolutions(const std::filesystem::path& file,
                       const std::vector<Resolution>& resolutions);

}  // namespace pendular::bench
