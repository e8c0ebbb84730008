// The example of a missing effect, changed: with its effect listed, or with faults in recordings.
#pragma once

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <filesystem>
#include <functional>
#include <sstream>
#include <string>
#include <vector>

#include "tests/support/data_support.h"
#include "tests/support/golden.h"

namespace pendular {

/// Columns of the example's recordings: torque [mN m], gap [mm], number of the interval.
enum RecordedColumn : std::size_t { torque_column = 1, gap_column = 3, interval_column = 5 };

/// Returns a recording of which each row below the header has other cells.
inline std::string with_cells(const std::string& recording,
                              const std::function<void(std::vector<std::string>&)>& change) {
    std::istringstream lines(recording);
    std::string line, text;
    std::getline(lines, text);
    text += '\n';
    while (std::getline(lines, line)) {
        std::vector<std::string> cells;
        std::istringstream row(line);
        for (std::string cell; std::getline(row, cell, ',');)
            cells.push_back(cell);
        change(cells);
        text += fmt::format("{}\n", fmt::join(cells, ","));
    }
    return text;
}

/// Copies examples/hidden-effect into a folder, and returns its path there.
inline std::filesystem::path copy_of_example(const TemporaryFolder& folder) {
    const std::filesystem::path study = folder.path() / "study";
    std::filesystem::copy(std::filesystem::path(PENDULAR_SOURCE_DIR) / "examples/hidden-effect",
                          study);
    return study;
}

/// Returns the same with the effect that the example lacks in its list.
inline std::filesystem::path copy_with_its_effect(const TemporaryFolder& folder) {
    const std::filesystem::path study = copy_of_example(folder);
    std::string text = content_of(study / "study.toml");
    const std::string none = "effects = []";
    text.replace(text.find(none), none.size(), "effects = [\"wall-friction\"]");
    folder.write("study/study.toml", text);
    return study;
}

}  // namespace pendular
