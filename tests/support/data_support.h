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

#include "data/input_error.h"

namespace pendular {

/// Published recording of an instrument, by its path in the folder that $PENDULAR_SAMPLES names;
/// empty where the variable is not set. The project does not ship these files, since their origins
/// name no licence.
/// @throws std::runtime_error where the folder lacks the file
inline std::optional<std::filesystem::path> published_sample(const std::string& name) {
    const char* const samples = std::getenv("PENDULAR_SAMPLES");
    if (!samples) return std::nullopt;
    const auto file = std::filesystem::path(samples) / name;
    if (!std::filesystem::exists(file)) throw std::runtime_error(file.string() + " is missing");
    return file;
}

/// File of tests/data/formats, which looks like an export of an instrument.
inline std::filesystem::path look_alike(const std::string& name) {
    return std::filesystem::path(PENDULAR_SOURCE_DIR) / "tests/data/formats" / name;
}

/// New temporary folder, removed with all files at the end of the object's life.
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

    /// Writes a file in the folder and returns its path.
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

/// Runs an action and returns the message of the InputError that it throws. Where it throws none,
/// the test fails and the message is empty.
inline std::string input_error(const std::function<void()>& action) {
    try {
        action();
    } catch (const InputError& error) {
        return error.what();
    }
    ADD_FAILURE() << "no InputError";
    return "";
}

/// Autoregressive series x_t = rho x_(t-1) + noise of `n` values with standard deviation 1. The
/// variance of its mean is about (1 + rho)/(1 - rho)/n.
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

/// Copies an example study, without results, to a folder, and returns the path of the copy.
inline std::filesystem::path copied_example(const std::string& name, const TemporaryFolder& to) {
    const auto study = to.path() / "study";
    std::filesystem::copy(std::filesystem::path(PENDULAR_SOURCE_DIR) / "examples" / name, study,
                          std::filesystem::copy_options::recursive);
    std::filesystem::remove_all(study / "out");
    return study;
}

}  // namespace pendular
