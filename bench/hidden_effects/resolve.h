#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "bench/hidden_effects/truth.h"
#include "sim/virtual_lab.h"

namespace pendular::bench {

/// How the next measurement is chosen.
enum class Policy { next, random };

/// What further measurements made of a study whose effects could not be told apart.
struct Resolution {
    std::string truth;
    int study = 0;
    Policy policy = Policy::next;
    std::size_t rivals = 0;  ///< models that stood at first
    bool separable = true;   ///< whether `next` knew a point that separates any
    int measurements = 0;    ///< made
    std::string verdict;     ///< at the end
    std::vector<std::string> named;
    bool right = false;  ///< `missing`, and it is what is hidden
};

/// Measures on, in the simulated laboratory, until one effect is named, `next` says that nothing on
/// the rig separates what stands, or so many measurements are made. The rig goes beyond what was
/// measured: other stresses, rates, contents and fillings. Empty where the study is not
/// indistinguishable to begin with.
std::vector<Resolution> resolve(const Truth& truth, const LabResult& laboratory, int study,
                                Policy policy, int most_measurements, const Workers& workers,
                                const std::filesystem::path& folder);

std::vector<Resolution> read_resolutions(const std::filesystem::path& file);
void write_resolutions(const std::filesystem::path& file,
                       const std::vector<Resolution>& resolutions);

}  // namespace pendular::bench
