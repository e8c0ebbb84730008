#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace pendular::bench {

struct OutsideShapesOptions {
    std::filesystem::path work = "build/outside-shapes";  ///< simulations, and outcomes so far
    /// Tables of truths; those of effects outside the catalogue are used.
    std::filesystem::path truths = "bench/hidden_effects/truths.csv";
    std::filesystem::path more_truths = "bench/hidden_effects/outside_truths.csv";
    std::vector<std::filesystem::path> runs = {"bench/hidden_effects/runs.csv"};
    std::filesystem::path results = "bench/results";
    std::vector<std::string> only;  ///< names of truths begin with one of these; empty: all
    int studies = 2;                ///< recordings, each with noise of its own, of each truth
    int threads = 1;
    bool plan = false;     ///< choose the sizes of `more_truths` anew
    bool diagnose = true;  ///< false: make simulations only
};

/// Hides effects that the program does not know, lets it propose the shape of what is missing, and
/// writes how often the shape is right.
/// @throws InputError, std::runtime_error; dem::Interrupted after Ctrl-C
void outside_shapes(const OutsideShapesOptions& options);

}  // namespace pendular::bench
