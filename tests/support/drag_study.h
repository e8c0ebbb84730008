#pragma once

#include <filesystem>
#include <fstream>

#include "tests/support/data_support.h"

namespace pendular {

/// Writes a study to a new folder. Its three dry readings are the emulator's predictions at
/// friction 0.09, reduced by a shear stress of 20 Pa, as if a drag in the instrument took this part
/// of the torque. The inertial number is 0.1, so that simulations of the study are short.
inline void write_drag_study(const std::filesystem::path& folder) {
    std::filesystem::create_directory(folder);
    std::ofstream(folder / "points.csv")
        << "normal_stress [Pa],shear_stress [Pa],shear_stress_sd [Pa],solid_fraction,"
           "solid_fraction_sd,inertial_number\n"
           "300,85.1,0.9,0.5985,0.0012,0.1\n"
           "1000,331.0,3.3,0.5992,0.0012,0.1\n"
           "3000,1028,10,0.5996,0.0012,0.1\n";
    std::ofstream(folder / "study.toml") << grains_table << cell_table() << points_table
                                         << "liquid_content = 0\n[model]\neffects = []\n";
}

}  // namespace pendular
