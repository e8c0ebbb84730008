#pragma once

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <unistd.h>

#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <functional>
#include <optional>
#include <random>
#include <stdexcept>
#include <string>
#include <vector>

#include "data/files/header_cell.h"
#include "data/input_error.h"
#include "data/reading.h"
#include "data/remarks/wording.h"

namespace pendular {

/// Returns the path of a published recording of an instrument. The recordings are not part of the
/// project, since most of their origins name no licence; files of the same layouts (`look_alike`)
/// test the same functions everywhere. Empty where $PENDULAR_SAMPLES, the folder of the recordings,
/// is not set.
/// @param name path of the recording in this folder
/// @throws std::runtime_error where the folder does not contain the recording
inline std::optional<std::filesystem::path> published_sample(const std::string& name) {
    const char* const samples = std::getenv("PENDULAR_SAMPLES");
    if (!samples) return std::nullopt;
    const auto file = std::filesystem::path(samples) / name;
    if (!std::filesystem::exists(file)) throw std::runtime_error(file.string() + " is missing");
    return file;
}

/// Returns name and unit of a header cell, as "torque|mN m".
inline std::string parts(std::string_view text) {
    const HeaderCell cell = parse_header_cell(text);
    return cell.name + "|" + cell.unit;
}

/// Returns the path of a file of tests/data/formats, written for tests to look like the export of
/// an instrument.
inline std::filesystem::path look_alike(const std::string& name) {
    return std::filesystem::path(PENDULAR_SOURCE_DIR) / "tests/data/formats" / name;
}

/// Tables of study.toml that most studies of tests have: polystyrene beads, an annular cell with
/// this mass of beads, and readings in points.csv.
inline const std::string grains_table =
    "[grains]\ndiameter = \"500 um\"\ndensity = \"1050 kg/m^3\"\n";
inline std::string cell_table(const std::string& bead_mass = "60 g") {
    return "[cell]\ninner_radius = \"21 mm\"\nouter_radius = \"45 mm\"\nbead_mass = \"" +
           bead_mass + "\"\n";
}
inline const std::string points_table = "[[readings]]\nfile = \"points.csv\"\n";
/// Header of a recording, with its line end.
inline const std::string recording_header =
    "Time [s],Torque [mN m],Normal force [N],Gap [mm],Angular velocity [rad/s]\n";

/// Temporary folder that is new at construction and removed with all files at destruction.
class TemporaryFolder {
  public:
    TemporaryFolder()
        : path_(std::filesystem::temp_directory_path() /
                ("pendular_" + std::to_string(getpid()) + "_" + std::to_string(counter()++))) {
        std::filesystem::create_directories(path_);
    }
    TemporaryFolder(const TemporaryFolder&) = delete;
    TemporaryFolder& operator=(const TemporaryFolder&) = delete;
    ~TemporaryFolder() { std::filesystem::remove_all(path_); }

    const std::filesystem::path& path() const { return path_; }

    /// Writes a file to the folder and returns its path.
    std::filesystem::path write(const std::string& name, const std::string& content) const {
        std::ofstream(path_ / name, std::ios::binary) << content;
        return path_ / name;
    }

  private:
    static int& counter() {
        static int value = 0;
        return value;
    }

    std::filesystem::path path_;
};

/// Runs an action and returns the message of the InputError that it throws. If the action throws no
/// InputError, the test fails and the message is empty.
inline std::string input_error(const std::function<void()>& action) {
    try {
        action();
    } catch (const InputError& error) {
        return error.what();
    }
    ADD_FAILURE() << "no InputError";
    return "";
}

/// Returns remarks in the words of the user.
inline std::vector<std::string> texts(const std::vector<Remark>& remarks) {
    std::vector<std::string> result;
    for (const Remark& remark : remarks)
        result.push_back(text_of(remark));
    return result;
}

/// Returns what a study tells of its measurements: what was left out and why, doubts and notes.
inline std::vector<std::string> told_of(const Measurements& all) {
    std::vector<std::string> told;
    for (const Remark& each : all.left_out())
        told.push_back(to_string(Position{each.file(), each.first_line()}) + ": " + text_of(each));
    for (const auto& said : {all.doubts(), all.notes()})
        for (const std::string& text : texts(said))
            told.push_back(text);
    return told;
}

/// Returns `n` values of an autoregressive series with mean 0 and standard deviation 1,
///     x_t = rho x_(t-1) + noise.
/// The variance of the mean of the values is about (1 + rho)/(1 - rho)/n.
inline std::vector<double> autoregressive(std::size_t n, double rho, std::mt19937_64& random) {
    std::normal_distribution<double> normal;
    std::vector<double> series(n);
    double value = normal(random);
    for (double& sample : series) {
        sample = value;
        value = rho * value + std::sqrt(1 - rho * rho) * normal(random);
    }
    return series;
}

/// Copies an example study, without its results, to a folder, and returns the path of the copy.
/// @param name name of the study's folder in `examples`
inline std::filesystem::path copied_example(const std::string& name, const TemporaryFolder& to) {
    const auto study = to.path() / "study";
    std::filesystem::copy(std::filesystem::path(PENDULAR_SOURCE_DIR) / "examples" / name, study,
                          std::filesystem::copy_options::recursive);
    std::filesystem::remove_all(study / "out");
    return study;
}

}  // namespace pendular
