#pragma once

#include <fmt/format.h>

#include "data/recordings/measurements.h"
#include "tests/support/data_support.h"
#include "tests/support/ordinary_recordings.h"

namespace pendular {

/// Function that changes a row of one of several recordings, given the indices of step and file,
/// from 0.
using SpoilFile = std::function<void(RowOfStep row, int step, int file)>;

/// Imports a study of simulated recordings (`ordinary_recording`), and returns its measurements.
/// @param files number of recordings
/// @param seed seed of the noise; recordings of one study differ
/// @param spoil function that changes rows of the recordings; empty: none
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
    folder.write("study.toml",
                 "[grains]\ndiameter = \"500 um\"\ndensity = \"1050 kg/m^3\"\n"
                 "[cell]\ninner_radius = \"21 mm\"\nouter_radius = \"45 mm\"\n"
                 "bead_mass = \"20 g\"\n[[recording]]\nfile = \"run_*.csv\"\n" +
                     import);
    return read_measurements(read_study(folder.path()));
}

/// Counts the studies of undisturbed recordings in which the import finds an irregularity, a false
/// alarm. Prints each finding.
/// @param studies number of studies
/// @param files number of recordings of each study
/// @param first seed of the first study; further studies have the following seeds
inline int alarms(int studies, int files, const OrdinaryNoise& noise, std::uint64_t first) {
    int count = 0;
    for (int k = 0; k < studies; ++k) {
        const Measurements m = study_of(files, first + static_cast<std::uint64_t>(k), noise);
        count += !m.findings.empty();
        for (const std::string& line : sentences(m.findings))
            fmt::print("study {}: {}\n", k, line);
    }
    return count;
}

}  // namespace pendular
