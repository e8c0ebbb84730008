#include "data/recordings/averaged_rows.h"

#include <algorithm>
#include <functional>
#include <utility>

namespace pendular {

AveragedRows::AveragedRows(Recording& recording,
                           std::vector<std::vector<double> Recording::*> columns, std::size_t most)
    : recording_(recording), columns_(std::move(columns)), most_(most), sums_(columns_.size()) {
    const auto found = std::ranges::find(columns_, &Recording::interval);
    if (found != columns_.end()) interval_ = found - columns_.begin();
}

bool AveragedRows::add(int line, const std::vector<double>& values) {
    if (count_ > 0 && interval_ >= 0) {
        const auto i = static_cast<std::size_t>(interval_);
        if (values[i] != sums_[i] / count_ && !append_mean()) return false;
    }
    if (count_ == 0) {
        first_line_ = line;
        sums_ = values;
    } else {
        std::ranges::transform(sums_, values, sums_.begin(), std::plus());
    }
    return ++count_ < recording_.averaged_rows || append_mean();
}

void AveragedRows::finish() {
    if (count_ > 0) append_mean();
}

bool AveragedRows::append_mean() {
    recording_.line.push_back(first_line_);
    for (std::size_t k = 0; k < columns_.size(); ++k) {
        (recording_.*columns_[k]).push_back(sums_[k] / count_);
    }
    count_ = 0;
    if (recording_.line.size() < most_) return true;
    halve();
    return recording_.line.size() < most_;
}

bool AveragedRows::same_interval(std::size_t row) const {
    return interval_ < 0 || recording_.interval[row] == recording_.interval[row + 1];
}

void AveragedRows::halve() {
    const std::size_t rows = recording_.line.size();
    std::vector<std::size_t> first;  // row of each mean, of this row alone or with the next
    for (std::size_t row = 0; row < rows; ++row) {
        first.push_back(row);
        if (row + 1 < rows && same_interval(row)) ++row;
    }
    for (const auto member : columns_) {
        std::vector<double>& column = recording_.*member;
        for (std::size_t k = 0; k < first.size(); ++k) {
            // A row alone is both the first and the last of its mean.
            const std::size_t next = k + 1 < first.size() ? first[k + 1] : rows;
            column[k] = (column[first[k]] + column[next - 1]) / 2;
        }
        column.resize(first.size());
    }
    for (std::size_t k = 0; k < first.size(); ++k) {
        recording_.line[k] = recording_.line[first[k]];
    }
    recording_.line.resize(first.size());
    recording_.averaged_rows *= 2;
}

}  // namespace pendular
