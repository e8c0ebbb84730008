#pragma once

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <unistd.h>

#include <filesystem>
#include <fstream>
#include <functional>
#include <random>
#include <string>
#include <vector>

#include "data/input_error.h"

namespace pendular {

/// A folder of its own for each test, removed at its end.
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

/// Message of the InputError that an action ends in; a failure and "" if there is none.
inline std::string input_error(const std::function<void()>& action) {
    try {
        action();
    } catch (const InputError& error) {
        return error.what();
    }
    ADD_FAILURE() << "no InputError";
    return "";
}

/// x_t = rho x_(t-1) + noise, of standard deviation 1: its mean's variance is about
/// (1 + rho)/(1 - rho)/n.
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

}  // namespace pendular
