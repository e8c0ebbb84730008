#pragma once

#include <fmt/format.h>

#include "data/recordings/measurements.h"
#include "tests/support/data_support.h"
#include "tests/support/ordinary_recordings.h"

namespace pendular {

/// Changes rows of one of several recordings.
using SpoilFile = std::function<void(RowOfStep row, int step, int file)>;

/// Import of a study of several simulated recordings.
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

/// Number of ordinary studies with any finding, among `studies`; prints what was found.
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
