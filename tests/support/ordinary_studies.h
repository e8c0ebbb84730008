#pragma once

#include <fmt/format.h>

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

}  // namespace pendular
