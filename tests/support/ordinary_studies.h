#pragma once

#include <fmt/format.h>

#include <algorithm>

#include "data/recordings/measurements.h"
#include "tests/support/data_support.h"
#include "tests/support/ordinary_recordings.h"

namespace pendular {

/// Function that changes one row of one of several simulated recordings. `step` and `file` are the
/// indices of the row's step and recording, from 0.
using SpoilFile = std::function<void(RowOfStep row, int step, int file)>;

/// Imports a study of simulated recordings (`ordinary_recording`), and returns its measurements.
/// @param seed seed of the study's noise; each recording of the study has different noise
/// @param spoil function that changes rows of the recordings; empty: no row is changed
/// @param import further text for the end of study.toml, such as a table [import]
inline Measurements study_of(int files, std::uint64_t seed, const OrdinaryNoise& noise = {},
                             const SpoilFile& spoil = {}, const std::string& import = "") {
    const TemporaryFolder folder;
    for (int file = 0; file < files; ++file) {
        const Spoil own = [&](RowOfStep row, int step) {
            if (spoil) spoil(row, step, file);
        };
        folder.write(fmt::format("run_{:02}.csv", file + 1),
                     csv_of(ordinary_recording("", 1000 * seed + static_cast<std::uint64_t>(file),
                                               noise, own)));
    }
    folder.write("study.toml", grains_table + cell_table("20 g") +
                                   "[[recording]]\nfile = \"run_*.csv\"\n" + import);
    return read_measurements(read_study(folder.path()));
}

/// Counts false alarms: studies of undisturbed recordings in which the import nevertheless finds an
/// irregularity. Prints each irregularity.
/// @param files number of recordings of each study
/// @param first seed of the first study; further studies have the following seeds
inline int alarms(int studies, int files, const OrdinaryNoise& noise, std::uint64_t first) {
    int count = 0;
    for (int k = 0; k < studies; ++k) {
        const Measurements m = study_of(files, first + static_cast<std::uint64_t>(k), noise);
        count += !m.faults(true).empty();
        for (const std::string& line : sentences(m.faults(true)))
            fmt::print("study {}: {}\n", k, line);
    }
    return count;
}

/// Counts the studies of independent recordings of which one is taken for a copy of another: two to
/// six recordings of white or correlated noise, in turn with usual, large and no scatter between
/// fillings and steps. Without such scatter, replicates agree as well as their rows allow.
/// @param first seed of the first study; further studies have the following seeds
inline int honest_studies_with_copies(int studies, std::uint64_t first) {
    const OrdinaryNoise noises[] = {
        {},
        {.correlation_rows = 10, .filling = 0, .step = 0},
        {.torque = 0.01, .correlation_rows = 0.2, .filling = 0, .step = 0},
        {.filling = 0.04, .step = 0.02}};
    int count = 0;
    for (int k = 0; k < studies; ++k) {
        const Measurements all =
            study_of(2 + k % 5, first + static_cast<std::uint64_t>(k), noises[k % 4]);
        count += std::ranges::any_of(all.remarks, [](const Remark& remark) {
            return remark.kind == Remark::Kind::copied_readings;
        });
    }
    return count;
}

}  // namespace pendular
