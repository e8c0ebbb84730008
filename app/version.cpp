#include "app/version.h"

#include <fmt/format.h>

#include <exception>
#include <filesystem>

#include "calib/emulator/known_runs.h"
#include "data/files/file_access.h"
#include "sim/dem/run_result.h"
#include "sim/runs/run_request.h"
#include "sim/runs/store/run_table.h"

namespace pendular::app {
namespace {

/// Line on the atlas. The hash is one of bytes, so that a table that cannot be read has one too.
std::string atlas_line() {
    const std::filesystem::path atlas = atlas_file();
    if (atlas.empty()) return "Atlas: none; set PENDULAR_ATLAS to the file of the atlas";
    try {
        std::string bytes = read_bytes(atlas, largest_table);
        const auto hyperparameters = atlas.parent_path() / hyperparameters_name;
        if (std::filesystem::exists(hyperparameters)) {
            bytes += read_bytes(hyperparameters, largest_table);
        }
        return fmt::format("Atlas: hash {:016x}, {}", fingerprint(bytes), atlas.string());
    } catch (const std::exception& error) {
        return fmt::format("Atlas: {}", error.what());
    }
}

}  // namespace

std::string version_text() {
    return fmt::format("pendular {}\nCompiler: {}\nLibraries: {}\nSolver: version {}\n{}\n",
                       PENDULAR_VERSION, PENDULAR_COMPILER, PENDULAR_LIBRARIES,
                       dem::physics_version, atlas_line());
}

}  // namespace pendular::app
